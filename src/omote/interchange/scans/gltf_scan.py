"""Parses untrusted glTF files (.glb, .gltf, .vrm) into one scan: every mesh that a viewer shows, at rest, joined."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture, Rows, Values
from omote.interchange.formats.file_content import describe_content
from omote.interchange.formats.gltf_document import (
    TRIANGLES,
    Mesh,
    Node,
    Primitive,
    entry,
    node_places,
    parse_document_as,
    shown_nodes,
    split_gltf,
)
from omote.interchange.formats.gltf_extensions import judge_extensions, refuse_packed
from omote.interchange.formats.gltf_scene import NodePlaces, SceneReader, read_buffers
from omote.interchange.scans.atlas import PATCH, join_textures
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_materials import SceneDocument, material_pictures, place_texcoords, texture_layout
from omote.interchange.scans.scan_parts import (
    LARGEST,
    MOST_NUMBERS,
    MOST_POINTS,
    MOST_TRIANGLES,
    make_scan,
    refuse_many,
    weld_scan,
)
from omote.interchange.scans.vrm_expressions import read_vrm_expressions
from omote.model.albedo import encode_light
from omote.model.fitting.scan import Scan

STRIP = 5
FAN = 6
POINTS = 0
"""Modes of primitives, with TRIANGLES; the others are lines."""
_SHOWN = (TRIANGLES, STRIP, FAN, POINTS)


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


class SurfaceReader(SceneReader):
    """Reads the primitives of a scene with their triangles and colours.

    document, buffers: the glTF and its bytes; beside: takes sentences.
    """

    document: SceneDocument

    def __init__(self, document: SceneDocument, buffers: Sequence[bytes], beside: Companions) -> None:
        expressions = read_vrm_expressions(document)
        super().__init__(document, buffers, expressions, note=beside.note, most=MOST_POINTS)
        self.document = document
        for sentence in expressions.notes:
            beside.note(sentence)

    def refuse_costly(self, nodes: Sequence[Node]) -> None:
        """Rejects documents that declare too many numbers, before any of them is allocated."""
        points = targets = corners = 0
        for node in nodes:
            for primitive in self._primitives(node):
                count = self._count(primitive.attributes.get("POSITION"))
                points = points + count
                targets = targets + count * 3 * len(primitive.targets)
                corners += self._count(primitive.indices)
        refuse_many(points, "points", MOST_POINTS)
        refuse_many(targets, "numbers of morph targets", MOST_NUMBERS)
        refuse_many(corners // 3, "triangles", MOST_TRIANGLES)
        refuse_packed(self.document, [primitive for node in nodes for primitive in self._primitives(node)])

    def _primitives(self, node: Node) -> Sequence[Primitive]:
        return () if node.mesh is None else entry(self.document.meshes, node.mesh, "mesh").primitives

    def _count(self, index: int | None) -> int:
        return 0 if index is None else entry(self.document.accessors, index, "accessor").count

    def pieces(self, at: int, places: NodePlaces) -> list[ScenePiece]:
        """The primitives of a node's mesh that have points.

        at: the node; places: where each node stands, (4, 4).
        """
        node = self.document.nodes[at]
        if node.mesh is None:
            return []
        mesh = entry(self.document.meshes, node.mesh, "mesh")
        shown = [
            primitive
            for primitive in mesh.primitives
            if "POSITION" in primitive.attributes and primitive.mode in _SHOWN
        ]
        return [self._piece(mesh, primitive, at, places) for primitive in shown]

    def _piece(self, mesh: Mesh, primitive: Primitive, at: int, places: NodePlaces) -> ScenePiece:
        resting = self.at_rest(at, mesh, primitive, places)
        count = len(resting.points)
        triangles = self._triangles(primitive, count)
        return ScenePiece(
            points=resting.points,
            triangles=triangles[:, ::-1] if resting.mirrored else triangles,
            colours=self._colours(primitive, count),
            texcoords=self._texcoords(primitive, count),
            material=-1 if primitive.material is None else primitive.material,
            moves=resting.moves,
        )

    def _triangles(self, primitive: Primitive, count: int) -> Rows:
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

    def _colours(self, primitive: Primitive, count: int) -> NDArray[np.uint8] | None:
        """Colours of vertices, white where one is no number; None and a sentence where they cannot be read."""
        index = primitive.attributes.get("COLOR_0")
        if index is None:
            return None
        try:
            columns = 4 if entry(self.document.accessors, index, "accessor").type == "VEC4" else 3
            tones = self.column(index, columns, "COLOR_0", count, finite=False, normalized=True)[:, :3]
        except ValueError as error:
            self.note(f"colours of its vertices cannot be read ({error})")
            return None
        return encode_light(np.clip(np.where(np.isfinite(tones), tones, 1.0), 0.0, 1.0))

    def _texcoords(self, primitive: Primitive, count: int) -> Values | None:
        chosen, moved, wraps = texture_layout(self.document, primitive.material)
        index = primitive.attributes.get(f"TEXCOORD_{chosen}")
        if index is None:
            return None
        texcoords = self.column(index, 2, "TEXCOORD", count, finite=False)
        return place_texcoords(np.where(np.isfinite(texcoords), texcoords, 0.0), moved, wraps)


def read_gltf(data: bytes, beside: Companions, /) -> Scan:
    """The scan in a glTF file, binary or text; beside: reads the buffers and pictures that lie beside it.

    ValueError for an invalid file.

    data: the file.
    """
    refuse_many(len(data), "bytes", LARGEST)
    text, binary = split_gltf(data)
    document = parse_document_as(SceneDocument, text)
    judge_extensions(document, beside.note)
    reader = SurfaceReader(document, read_buffers(document, binary, beside.find), beside)
    places = node_places(document)
    shown = shown_nodes(document)
    reader.refuse_costly([document.nodes[at] for at in places if at in shown])
    pieces = [piece for at in places if at in shown for piece in reader.pieces(at, places)]
    if not pieces:
        raise ValueError(f"the file shows no mesh of triangles ({describe_content(data)}); export the head as a mesh")
    return _join(pieces, material_pictures(document, reader, beside), beside)


def _join(pieces: list[ScenePiece], pictures: list[Picture], beside: Companions) -> Scan:
    """One scan of all pieces, doubled points joined."""
    begins = np.cumsum([0, *(len(piece.points) for piece in pieces)])
    points = np.concatenate([piece.points for piece in pieces])
    triangles = np.concatenate([piece.triangles + begin for piece, begin in zip(pieces, begins[:-1], strict=True)])
    of = np.repeat([_material(piece, pictures, beside) for piece in pieces], [len(piece.triangles) for piece in pieces])
    texcoords = np.concatenate([_texcoords(piece)[piece.triangles] for piece in pieces])
    if (of < 0).any():  # what has no material is grey in the picture of all
        of = np.where(of < 0, len(pictures), of)
    texture, moved = join_textures([*pictures, None], texcoords, of) if len(of) else (None, None)
    return weld_scan(
        make_scan(points, triangles, _colours(pieces), texture, moved, _shapes(pieces, begins), beside=beside)
    )


def _material(piece: ScenePiece, pictures: list[Picture], beside: Companions) -> int:
    """The material of a piece, -1 where nothing says which part of its picture is where."""
    if piece.texcoords is None and 0 <= piece.material < len(pictures) and pictures[piece.material].shape[0] > PATCH:
        beside.note("a mesh of it has a picture and no texture coordinates, so it has no colours")
        return -1
    return piece.material


def _texcoords(piece: ScenePiece) -> Values:
    return np.zeros((len(piece.points), 2)) if piece.texcoords is None else piece.texcoords


def _colours(pieces: list[ScenePiece]) -> NDArray[np.uint8] | None:
    """The colours of all points, white where a piece has none; None where no piece has any."""
    if all(piece.colours is None for piece in pieces):
        return None
    return np.concatenate(
        [np.full((len(piece.points), 3), 255, np.uint8) if piece.colours is None else piece.colours for piece in pieces]
    )


def _shapes(pieces: list[ScenePiece], begins: NDArray[np.int64]) -> dict[str, Values]:
    """The targets of all pieces by name; a name in several pieces moves them together, as programs play it."""
    names = dict.fromkeys(name for piece in pieces for name in piece.moves)
    refuse_many(3 * int(begins[-1]) * len(names), "numbers of morph targets", MOST_NUMBERS)
    shapes = {name: np.zeros((int(begins[-1]), 3)) for name in names}
    for piece, begin in zip(pieces, begins[:-1], strict=True):
        for name, moves in piece.moves.items():
            shapes[name][begin : begin + len(moves)] = moves
    return shapes
