"""Exports a face as an avatar: VRM 1.0, a head on a plain skeleton, with all presets and Perfect Sync's names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np

from omote.interchange.avatar.humanoid_skeleton import Skeleton, build_skeleton
from omote.interchange.avatar.joint_binding import add_joints, bind_meshes
from omote.interchange.avatar.preset_expressions import (
    custom_expressions,
    find_overrides,
    preset_weights,
    required_expressions,
)
from omote.interchange.avatar.vrm_extension import (
    EXTENSION,
    VERSION,
    Json,
    describe_bones,
    describe_expressions,
    describe_first_person,
    describe_gaze,
    describe_meta,
)
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.export_face import (
    NOTICE,
    SKIN,
    ExportContext,
    Meshes,
    Points,
    build_scene,
    named_compound_meshes,
)
from omote.interchange.formats.glb_writer import Scene, Shape, Store, describe_scene, encode_glb
from omote.model.space.face_fit import fit

HEAD = "head"


def vrm_bytes(
    context: ExportContext,
    face: str,
    poses: Iterable[tuple[str, Meshes]],
    credit: Credit,
    /,
    *,
    own: bool = False,
    hair: bool = True,
) -> bytes:
    """Encodes a face of the cast as a VRM 1.0; poses: `named_compound_meshes` of what is chosen, by name.

    What presets and Perfect Sync need besides is added. own: the face did not come with Omote, so its terms must have
    been said. ValueError for a face that is not in the cast, and where terms are missing.
    """
    cast, terms = context.cast, credit.agreed(face, own=own)
    given = dict(poses)
    presets, customs = preset_weights(cast, given), custom_expressions(cast, given)
    worn = {
        name: given.get(name) or named_compound_meshes(cast, face, name) for name in required_expressions(cast, given)
    }
    fitted = fit(cast.space, cast.faces[face])
    skeleton = build_skeleton(cast.space, fitted)
    scene = _stand(build_scene(context, face, worn.items(), hair=hair), skeleton)
    skins = {name: meshes[SKIN] for name, meshes in worn.items()}
    overrides = find_overrides(cast.space, fitted.positions.astype(np.float64), skins, presets)
    expressions = describe_expressions(scene.shapes, presets, customs, overrides)
    meta = describe_meta(face, credit.authors, terms, NOTICE)
    gaze = describe_gaze(cast, skeleton.eyes)
    return _encode(scene, skeleton, {"meta": meta, "expressions": expressions} | ({"lookAt": gaze} if gaze else {}))


def _stand(scene: Scene, skeleton: Skeleton) -> Scene:
    """The scene on its feet; each shape keeps the targets that move it."""
    return replace(scene, shapes=[_placed(shape, skeleton.shift) for shape in scene.shapes], apart=True)


def _placed(shape: Shape, shift: Points) -> Shape:
    points = shape.points.astype(np.float64) + shape.place + shift
    targets = {name: target for name, target in shape.targets.items() if target.moves.any()}
    return replace(shape, points=points.astype(np.float32), place=(0.0, 0.0, 0.0), targets=targets)


def _encode(scene: Scene, skeleton: Skeleton, parts: Mapping[str, Json]) -> bytes:
    store = Store()
    document = describe_scene(scene, store)
    nodes = add_joints(document, skeleton.joints)
    bind_meshes(document, store, skeleton.joints[HEAD], nodes[HEAD])
    seen = describe_first_person(range(1, 1 + len(scene.shapes)))
    extension = {"specVersion": VERSION, **parts, "humanoid": describe_bones(nodes), "firstPerson": seen}
    return encode_glb(document | {"extensions": {EXTENSION: extension}, "extensionsUsed": [EXTENSION]}, store)
