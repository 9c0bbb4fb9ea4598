"""Skeletons of USD: the joints of a head or a figure, meshes bound to them, and poses as animations.

UsdSkel (OpenUSD, "Schemas In-Depth"): bind transforms say where joints are as meshes are kept, rest transforms where
they rest; both are the skeleton's own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.interchange.exports.identifiers import identifiers
from omote.interchange.formats.glb_writer import ExportScene
from omote.interchange.formats.rig import Joint, Motion, Rig, strongest_weights

HEAD = "head"
SKELETON = "skeleton"
POSES = "poses"
INFLUENCES = 8
"""Joints that move a vertex at most: as many as our figures have."""


@dataclass(frozen=True, eq=False)
class SkeletonJoints:
    """The joints of a scene. paths: from the first; binds (J, 4, 4): where they are as meshes are kept; steps (J, 3):
    where each rests, from its parent, metres; own: the place of the joint that a mesh has for itself, by its name;
    carrier: of the joint that all others are on; weights: of meshes on several, (n, J)."""

    paths: tuple[str, ...]
    binds: Values
    steps: Points
    own: Mapping[str, int]
    carrier: int
    weights: Mapping[str, csr_array]


def find_joints(scene: ExportScene, /) -> SkeletonJoints:
    """The joints of a scene: its rig's, or the head's in the origin, and one for each eyeball."""
    eyes = [shape for shape in scene.shapes if any(shape.place)]
    rig = _lone_head() if scene.rig is None else scene.rig
    names = identifiers(joint.name for joint in rig.joints)
    paths: dict[str, str] = {"": ""}
    for joint in rig.joints:
        paths[joint.name] = f"{paths[joint.parent]}/{names[joint.name]}".lstrip("/")
    carrier = [joint.name for joint in rig.joints].index(rig.carrier)
    hung = np.array([shape.place for shape in eyes]).reshape(-1, 3)
    binds = np.tile(np.eye(4), (len(eyes), 1, 1))
    binds[:, :3, 3] = hung
    return SkeletonJoints(
        (*(paths[joint.name] for joint in rig.joints), *(f"{paths[rig.carrier]}/{shape.name}" for shape in eyes)),
        np.concatenate([np.linalg.inv(rig.inverse), binds]),
        np.concatenate([rig.steps, hung - rig.joints[carrier].place]),
        {shape.name: len(rig.joints) + place for place, shape in enumerate(eyes)},
        carrier,
        rig.weights,
    )


def _lone_head() -> Rig:
    return Rig((Joint(HEAD, (0.0, 0.0, 0.0)),), np.eye(4)[None], {}, HEAD, {})


def add_skeleton(stage: Any, top: str, joints: SkeletonJoints, expressions: Sequence[str], /) -> None:
    """Adds the skeleton and the animation that rests in it, with a weight for each expression.

    stage, top: where; joints: of the scene; expressions: identifiers.
    """
    from pxr import Gf, UsdSkel, Vt

    skeleton = UsdSkel.Skeleton.Define(stage, f"{top}/{SKELETON}")
    skeleton.CreateJointsAttr(Vt.TokenArray(joints.paths))
    binds = joints.binds.astype(np.float32).astype(np.float64)
    skeleton.CreateBindTransformsAttr(Vt.Matrix4dArray([Gf.Matrix4d(bind.T.tolist()) for bind in binds]))  # rows move
    steps = joints.steps.astype(np.float32).astype(np.float64)
    rest = [Gf.Matrix4d().SetTranslate(Gf.Vec3d(step)) for step in steps.tolist()]
    skeleton.CreateRestTransformsAttr(Vt.Matrix4dArray(rest))
    animation = _animation(stage, f"{top}/animation", joints, np.tile(np.eye(3), (len(steps), 1, 1)), joints.steps)
    animation.CreateBlendShapesAttr(Vt.TokenArray(expressions))
    animation.CreateBlendShapeWeightsAttr(Vt.FloatArray([0.0] * len(expressions)))
    binding = UsdSkel.BindingAPI.Apply(skeleton.GetPrim())
    binding.CreateAnimationSourceRel().SetTargets([animation.GetPath()])


def add_poses(stage: Any, top: str, joints: SkeletonJoints, motions: Mapping[str, Motion], /) -> dict[str, Any]:
    """Adds an animation for each pose, which a skeleton takes in place of its own: the prims by the poses' names.

    stage, top: where; joints: of the scene; motions: poses of the rig's joints.
    """
    from pxr import UsdGeom

    UsdGeom.Scope.Define(stage, f"{top}/{POSES}")
    names = identifiers(motions)
    hung = len(joints.own)
    prims = {}
    for name, motion in motions.items():
        turns = np.concatenate([motion.turns, np.tile(np.eye(3), (hung, 1, 1))])
        steps = np.concatenate([motion.travel[None], joints.steps[1:]])
        prims[name] = _animation(stage, f"{top}/{POSES}/{names[name]}", joints, turns, steps).GetPrim()
    return prims


def _animation(stage: Any, path: str, joints: SkeletonJoints, turns: Values, steps: Points) -> Any:
    from pxr import Gf, UsdSkel, Vt

    animation = UsdSkel.Animation.Define(stage, path)
    animation.CreateJointsAttr(Vt.TokenArray(joints.paths))
    animation.CreateTranslationsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(steps, np.float32)))
    rotations = Rotation.from_matrix(turns).as_quat().tolist()
    animation.CreateRotationsAttr(Vt.QuatfArray([Gf.Quatf(w, x, y, z) for x, y, z, w in rotations]))
    animation.CreateScalesAttr(Vt.Vec3hArray([Gf.Vec3h(1.0)] * len(turns)))
    return animation


def bind_joints(mesh: Any, joints: SkeletonJoints, name: str, /) -> Any:
    """Binds a mesh to its joints; the binding (UsdSkel.BindingAPI). name: the mesh's in the scene."""
    from pxr import UsdSkel, Vt

    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets([mesh.GetPath().GetParentPath().AppendChild(SKELETON)])
    if name not in joints.weights:
        binding.CreateJointIndicesPrimvar(True, 1).Set(Vt.IntArray([joints.own.get(name, joints.carrier)]))
        binding.CreateJointWeightsPrimvar(True, 1).Set(Vt.FloatArray([1.0]))
        return binding
    places, weights = strongest_weights(joints.weights[name], INFLUENCES)
    binding.CreateJointIndicesPrimvar(False, INFLUENCES).Set(Vt.IntArray.FromNumpy(places.astype(np.int32).ravel()))
    binding.CreateJointWeightsPrimvar(False, INFLUENCES).Set(
        Vt.FloatArray.FromNumpy(weights.astype(np.float32).ravel())
    )
    return binding
