"""Exports a face as an avatar: VRM 1.0 or 0.x, a head on a plain skeleton or a figure, with all presets and Perfect
Sync."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np

from omote.arrays import Points
from omote.interchange.avatar.fold_overlays import build_overlays
from omote.interchange.avatar.humanoid_figure import figure_skeleton, hang_figure
from omote.interchange.avatar.humanoid_skeleton import Skeleton, build_skeleton
from omote.interchange.avatar.preset_expressions import (
    Weights,
    custom_expressions,
    find_overrides,
    preset_weights,
    required_expressions,
)
from omote.interchange.avatar.spring_bones import EXTENSION as SPRINGS
from omote.interchange.avatar.spring_bones import EarBone, describe_old_springs, describe_springs, find_ear_bones
from omote.interchange.avatar.vrm0_extension import EXTENSION as EXTENSION_0
from omote.interchange.avatar.vrm0_extension import describe_vrm0
from omote.interchange.avatar.vrm_extension import (
    EXTENSION,
    VERSION,
    describe_bones,
    describe_expressions,
    describe_first_person,
    describe_gaze,
    describe_meta,
)
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.collar_mesh import COLLAR
from omote.interchange.export_face import NOTICE, SKIN, ExportContext, Meshes, build_scene, named_compound_meshes
from omote.interchange.figures.figure_rig import BODY, export_figure
from omote.interchange.formats.glb_rig import INFLUENCES, Binding, Hanging, add_joints, bind_meshes
from omote.interchange.formats.glb_writer import (
    GENERATOR,
    ExportScene,
    Json,
    MorphTarget,
    Shape,
    Store,
    describe_scene,
    encode_glb,
)
from omote.interchange.formats.rig import Joint
from omote.model.space.face_fit import fit

Ears = tuple[EarBone, ...]

HEAD = "head"
TURNED = np.array([-1.0, 1.0, -1.0])
"""Half a turn: models of 0.x look along -z."""


def vrm_bytes(
    context: ExportContext,
    face: str,
    poses: Iterable[tuple[str, Meshes]],
    credit: Credit,
    /,
    *,
    own: bool = False,
    hair: bool = True,
    body: str = "",
) -> bytes:
    """Encodes a face of the cast as a VRM; poses: `named_compound_meshes` of what is chosen, by name.

    What presets and Perfect Sync need besides is added. own: the face did not come with Omote, so its terms must have
    been said. ValueError for a face that is not in the cast, and where terms are missing.

    context, face: whose avatar; credit: whose it is, and the version of VRM; hair: whether it comes along; body: what
    the head is on: a body's name, `own` for the face's, "" for none.
    """
    cast = context.cast
    terms = credit.agreed(face, own=own)
    meshes_by_name = dict(poses)
    presets = preset_weights(cast, meshes_by_name)
    customs = custom_expressions(cast, meshes_by_name)
    worn = {
        name: meshes_by_name.get(name) or named_compound_meshes(cast, face, name)
        for name in required_expressions(cast, meshes_by_name)
    }
    fitted = fit(cast.space, cast.faces[face])
    figure = export_figure(cast, face, body, influences=INFLUENCES) if body else None
    skeleton = build_skeleton(cast.space, fitted) if figure is None else figure_skeleton(figure, fitted)
    ears = find_ear_bones(cast.space, cast.faces[face], skeleton.shift)
    bare = build_scene(context, face, worn.items(), hair=hair, drawn=True, relief=False)  # VRM takes no tangents
    rest = fitted.positions.astype(np.float64)
    skins = {name: meshes[SKIN] for name, meshes in worn.items()}
    if figure is not None:
        clad = [shape for shape in bare.shapes if shape.name != COLLAR]
        bare = replace(bare, shapes=[*clad, *figure.body_shapes(skins)])
    scene = _stand(bare, skeleton)
    overlays = build_overlays(context, cast.looks[face], scene.shapes[0], rest, skins)
    scene = replace(scene, shapes=[*scene.shapes, *overlays.shapes])
    surfaces = list({id(shape.material): shape.material.name for shape in scene.shapes}.values())

    def shown(weights: Weights) -> dict[int, float]:
        return {surfaces.index(name): part for name, part in overlays.shown(weights).items()}

    overrides = find_overrides(cast.space, rest, skins, presets)
    expressions = describe_expressions(scene.shapes, presets, customs, overrides, shown)
    meta = describe_meta(credit.labels.get(face, face), credit.authors, terms, NOTICE)
    gaze = describe_gaze(cast, skeleton.eyes)
    parts = {"meta": meta, "expressions": expressions} | ({"lookAt": gaze} if gaze else {})
    hanging = _hang_head(scene, skeleton, ears) if figure is None else hang_figure(figure, scene.shapes, ears)
    return (_encode if credit.version == VERSION else _encode_old)(scene, skeleton, ears, hanging, parts)


def _stand(scene: ExportScene, skeleton: Skeleton) -> ExportScene:
    """The scene on its feet; each shape keeps the targets that move it."""
    return replace(scene, shapes=[_placed(shape, skeleton.shift) for shape in scene.shapes], apart=True)


def _placed(shape: Shape, shift: Points) -> Shape:
    points = shape.points.astype(np.float64) + shape.place + shift
    targets = {name: target for name, target in shape.targets.items() if target.moves.any()}
    return replace(shape, points=points.astype(np.float32), place=(0.0, 0.0, 0.0), targets=targets)


def _encode(
    scene: ExportScene, skeleton: Skeleton, ears: Ears, hanging: Hanging, parts: Mapping[str, Json]
) -> bytes:  # fmt: skip
    document, store, extension, nodes = _describe(scene, skeleton, ears, hanging, parts)
    extensions = {EXTENSION: extension} | ({SPRINGS: describe_springs(ears, nodes)} if ears else {})
    return encode_glb(document | {"extensions": extensions, "extensionsUsed": [*extensions]}, store)


def _encode_old(
    scene: ExportScene, skeleton: Skeleton, ears: Ears, hanging: Hanging, parts: Mapping[str, Json]
) -> bytes:  # fmt: skip
    """The same as VRM 0.x, turned to look along -z."""
    joints = {name: _turn_joint(joint) for name, joint in skeleton.joints.items()}
    ears = tuple(replace(ear, root=_turn_joint(ear.root), tip=_turn_joint(ear.tip)) for ear in ears)
    turned = replace(scene, shapes=[_turn_shape(shape) for shape in scene.shapes])
    half = np.diag([*TURNED, 1.0])
    hanging = replace(hanging, inverse=half @ hanging.inverse @ half)
    document, store, extension, nodes = _describe(turned, replace(skeleton, joints=joints), ears, hanging, parts)
    old = describe_vrm0(extension, [material["name"] for material in document["materials"]], GENERATOR)
    old["secondaryAnimation"]["boneGroups"] = describe_old_springs(ears, nodes)
    return encode_glb(document | {"extensions": {EXTENSION_0: old}, "extensionsUsed": [EXTENSION_0]}, store)


def _turn_joint(joint: Joint) -> Joint:
    x, y, z = joint.place
    return replace(joint, place=(0.0 - x, y, 0.0 - z))


def _turn_shape(shape: Shape) -> Shape:
    half = TURNED.astype(np.float32)
    targets = {name: MorphTarget(target.moves * half, target.turns * half) for name, target in shape.targets.items()}
    return replace(shape, points=shape.points * half, normals=shape.normals * half, targets=targets)


def _describe(
    scene: ExportScene, skeleton: Skeleton, ears: Ears, hanging: Hanging, parts: Mapping[str, Json]
) -> tuple[Json, Store, Json, dict[str, int]]:
    """The document of the scene on its skeleton, what it names, the extension of 1.0, and the nodes of joints."""
    store = Store()
    document = describe_scene(scene, store)
    swinging = [joint for ear in ears for joint in (ear.root, ear.tip)]
    nodes = add_joints(document, [*skeleton.joints.values(), *swinging])
    bind_meshes(document, store, hanging, nodes)
    seen = describe_first_person(
        {place: shape.name not in BODY for place, shape in enumerate(scene.shapes, start=1)}
    )  # fmt: skip
    bones = describe_bones({name: nodes[joint] for name, joint in skeleton.bones.items()})
    return document, store, {"specVersion": VERSION, **parts, "humanoid": bones, "firstPerson": seen}, nodes


def _hang_head(scene: ExportScene, skeleton: Skeleton, ears: Ears) -> Hanging:
    """All of the scene on the head, and of its skin what is of ears on these."""
    joints = [skeleton.joints[HEAD], *(ear.root for ear in ears)]
    inverse = np.tile(np.eye(4), (len(joints), 1, 1))
    inverse[:, :3, 3] = [[-along for along in joint.place] for joint in joints]
    bindings = {shape.name: _bind_head(shape, ears) for shape in scene.shapes}
    return Hanging(tuple(joint.name for joint in joints), inverse, bindings)


def _bind_head(shape: Shape, ears: Ears) -> Binding:
    weights = np.zeros((len(shape.points), INFLUENCES), np.uint8)
    if shape.name == SKIN and shape.rows is not None and ears:
        weights[:, 1 : 1 + len(ears)] = np.rint(255.0 * np.stack([ear.shares[shape.rows] for ear in ears], axis=1))
    weights[:, 0] = 255 - weights[:, 1:].sum(axis=1)
    return Binding(np.where(weights > 0, np.arange(INFLUENCES, dtype=np.uint8), np.uint8(0)), weights)
