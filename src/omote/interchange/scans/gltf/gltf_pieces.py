"""The primitives of a glTF scene where a viewer shows them at rest, with triangles, colours and named targets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.glb_reader import MOST_TARGETS
from omote.interchange.formats.gltf_accessors import AccessorReader, Values, entry
from omote.interchange.scans.gltf.gltf_scene import (
    FAN,
    POINTS,
    STRIP,
    TRIANGLES,
    SceneDocument,
    SkinnedNode,
    SurfaceMesh,
    SurfacePrimitive,
)  # fmt: skip
from omote.interchange.scans.gltf.vrm_expressions import read_vrm_expressions
from omote.interchange.scans.scan_parts import MOST_NUMBERS, MOST_POINTS, MOST_TRIANGLES, Rows, refuse_many
from omote.model.albedo import encode_light

Places = Mapping[int, Values]
_MOST_JOINTS = 4096


@dataclass(frozen=True, eq=False)
class ScenePiece:
    """One primitive where it stands.

    points (n, 3); triangles (t, 3); colours uint8 (n, 3); texcoords (n, 2), v down; material: its number, -1 for none;
    moves: what each target adds to the points (n, 3).
    """

    points: Values
    triangles: Rows
    colours: NDArray[np.uint8] | None
    texcoords: Values | None
    material: int
    moves: Mapping[str, Values] = field(default_factory=dict)


class SceneReader(AccessorReader):
    """Reads the primitives of a scene."""

    document: SceneDocument

    def __init__(self, document: SceneDocument, buffers: Sequence[bytes]) -> None:
        super().__init__(document, buffers)
        self.document = document
        self.expressions = read_vrm_expressions(document)

    def refuse_costly(self, nodes: Sequence[SkinnedNode]) -> None:
        """Rejects documents that declare too many numbers, before any of them is allocated."""
        points = targets = corners = 0
        for node in nodes:
            mesh = None if node.mesh is None else entry(self.document.meshes, node.mesh, "mesh")
            for primitive in () if mesh is None else mesh.primitives:
                count = self._count(primitive.attributes.get("POSITION"))
                points, targets = points + count, targets + count * 3 * len(primitive.targets)
                corners += self._count(primitive.indices)
        refuse_many(points, "points", MOST_POINTS)
        refuse_many(targets, "numbers of morph targets", MOST_NUMBERS)
        refuse_many(corners // 3, "triangles", MOST_TRIANGLES)

    def _count(self, index: int | None) -> int:
        return 0 if index is None else entry(self.document.accessors, index, "accessor").count

    def pieces(self, at: int, places: Places) -> list[ScenePiece]:
        """The primitives of a node's mesh that have points."""
        node = self.document.nodes[at]
        if node.mesh is None:
            return []
        mesh = entry(self.document.meshes, node.mesh, "mesh")
        shown = [each for each in mesh.primitives if "POSITION" in each.attributes and each.mode in _SHOWN]
        return [self._piece(mesh, each, at, places) for each in shown]

    def _piece(self, mesh: SurfaceMesh, primitive: SurfacePrimitive, at: int, places: Places) -> ScenePiece:
        node, place = self.document.nodes[at], places[at]
        points = self.numbers(primitive.attributes["POSITION"], 3, "POSITION", MOST_POINTS)
        count = len(points)
        names = _target_names(mesh, primitive)
        moves = {
            name: self._column(target["POSITION"], 3, "POSITION of a target", count)
            for name, target in zip(names, primitive.targets, strict=True)
            if "POSITION" in target
        }
        placed = self._skin(primitive, node, count, places)
        turn, shift = (place[:3, :3], place[:3, 3]) if placed is None else (placed[:, :3, :3], placed[:, :3, 3])
        return ScenePiece(
            points=_turned(points, turn) + shift,
            triangles=self._triangles(primitive, count),
            colours=self._colours(primitive, count),
            texcoords=self._texcoords(primitive, count),
            material=-1 if primitive.material is None else primitive.material,
            moves={name: _turned(move, turn) for name, move in self.expressions.rename(at, names, moves).items()},
        )

    def _column(self, index: int, columns: int, what: str, count: int) -> Values:
        found = self.numbers(index, columns, what, MOST_POINTS)
        if len(found) != count:
            raise ValueError(f"{what} has {len(found)} rows and its mesh {count} vertices; export it anew")
        return found

    def _triangles(self, primitive: SurfacePrimitive, count: int) -> Rows:
        if primitive.indices is None:
            row = np.arange(count)
        else:
            row = self.numbers(primitive.indices, 1, "indices", 3 * MOST_TRIANGLES)[:, 0].astype(np.int64)
        if len(row) and not 0 <= row.min() <= row.max() < count:
            raise ValueError(f"a mesh names vertices {row.min()} to {row.max()} and has {count}; export it anew")
        if primitive.mode == TRIANGLES:
            return row[: len(row) // 3 * 3].reshape(-1, 3)
        at = np.arange(max(len(row) - 2, 0))
        if primitive.mode == STRIP:
            return np.stack([row[at], row[at + 1 + at % 2], row[at + 2 - at % 2]], axis=1)
        if primitive.mode == FAN:
            return np.stack([row[at + 1], row[at + 2], np.full_like(at, row[0] if len(at) else 0)], axis=1)
        return np.empty((0, 3), np.int64)

    def _colours(self, primitive: SurfacePrimitive, count: int) -> NDArray[np.uint8] | None:
        index = primitive.attributes.get("COLOR_0")
        if index is None:
            return None
        columns = 4 if entry(self.document.accessors, index, "accessor").type == "VEC4" else 3
        return encode_light(np.clip(self._column(index, columns, "COLOR_0", count)[:, :3], 0.0, 1.0))

    def _texcoords(self, primitive: SurfacePrimitive, count: int) -> Values | None:
        materials = self.document.materials
        known = primitive.material is not None and primitive.material < len(materials)
        info = materials[primitive.material or 0].pbr_metallic_roughness.base_color_texture if known else None
        index = primitive.attributes.get(f"TEXCOORD_{0 if info is None else info.tex_coord}")
        return None if index is None else self._column(index, 2, "TEXCOORD", count)

    def _skin(self, primitive: SurfacePrimitive, node: SkinnedNode, count: int, places: Places) -> Values | None:
        """Where the joints bring each vertex (n, 4, 4), None where nothing but its node places the mesh."""
        attributes = primitive.attributes
        if node.skin is None or not {"JOINTS_0", "WEIGHTS_0"} <= attributes.keys():
            return None
        skin = entry(self.document.skins, node.skin, "skin")
        refuse_many(len(skin.joints), "joints", _MOST_JOINTS)
        if not skin.joints or any(joint not in places for joint in skin.joints):
            raise ValueError("a skin of the file names joints that are none of its nodes; export it anew")
        bones = np.stack([places[joint] for joint in skin.joints])
        if skin.inverse_bind_matrices is not None:
            inverse = self._column(skin.inverse_bind_matrices, 16, "inverse bind matrices", len(bones))
            bones = bones @ inverse.reshape(-1, 4, 4).transpose(0, 2, 1)
        joints = self._column(attributes["JOINTS_0"], 4, "JOINTS_0", count).astype(np.int64)
        weights = self._column(attributes["WEIGHTS_0"], 4, "WEIGHTS_0", count)
        if joints.min() < 0 or joints.max() >= len(bones):
            raise ValueError(f"a mesh names joint {joints.max()} and its skin has {len(bones)}; export it anew")
        total = weights.sum(axis=1)
        if not (total > 1e-6).all():
            return None  # a mesh that no joint holds stays where its node stands
        return sum(
            ((weights[:, at] / total)[:, None, None] * bones[joints[:, at]] for at in range(4)), np.zeros((count, 4, 4))
        )


_SHOWN = (TRIANGLES, STRIP, FAN, POINTS)


def _turned(points: Values, turn: Values) -> Values:
    """Points (n, 3) by one matrix (3, 3), or each by its own (n, 3, 3)."""
    turned: Values = points @ turn.T if turn.ndim == 2 else np.einsum("nij,nj->ni", turn, points)
    return turned


def _target_names(mesh: SurfaceMesh, primitive: SurfacePrimitive) -> list[str]:
    """The targets' names, in order; a name that is there twice gets a number."""
    count = len(primitive.targets)
    refuse_many(count, "morph targets of one mesh", MOST_TARGETS)
    given = mesh.extras.target_names if mesh.extras else []
    if not given and isinstance(primitive.extras, dict):  # where VRM 0 has them
        own = primitive.extras.get("targetNames")
        given = [name for name in own if isinstance(name, str)] if isinstance(own, list) else []
    names = list[str]()
    for at in range(count):
        name = given[at] if at < len(given) and given[at] else f"target_{at}"
        names.append(name if name not in names else f"{name} {at}")
    return names
