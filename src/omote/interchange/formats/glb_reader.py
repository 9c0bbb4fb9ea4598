"""Parses meshes with named morph targets (blendshapes) from untrusted glTF files, as `gltf_scene` has them at rest.

All that a file declares is validated: chunks, views, accessors, strides, sparse indices, nodes. Memory is bounded
before it is allocated, nothing outside the file is opened but what `find` gives, and invalid files are rejected with
an error message.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.geometry.mesh import FARTHEST, rows_out_of_reach
from omote.interchange.formats.glb_writer import NO_ROW, ROWS
from omote.interchange.formats.gltf_document import (
    Document,
    Mesh,
    Primitive,
    entry,
    node_places,
    parse_document,
    shown_nodes,
    split_gltf,
)
from omote.interchange.formats.gltf_extensions import judge_extensions, refuse_packed
from omote.interchange.formats.gltf_scene import (
    Find,
    NodePlaces,
    Note,
    SceneReader,
    TargetNames,
    find_nothing,
    note_nothing,
    read_buffers,
)

MOST_NUMBERS = 40_000_000
"""Of one primitive; and numbers of all together: every expression of the cast on a head with hair makes 15 million."""


@dataclass(frozen=True, eq=False)
class Piece:
    """One primitive where it stands in the scene.

    points (n, 3) metres; moves: what each target adds to them (n, 3); rows (n,): the vertices of a cast that they are,
    where the file says so. ValueError where arrays do not belong together.
    """

    name: str
    points: Values
    rows: NDArray[np.int64] | None = None
    moves: Mapping[str, Values] = field(default_factory=dict)

    def __post_init__(self) -> None:
        rows = self.points if self.rows is None else self.rows
        if any(len(values) != len(self.points) for values in (*self.moves.values(), rows)):
            raise ValueError(f"arrays of the mesh {self.name[:80]!r} do not belong together; export it anew")


def read_glb(
    data: bytes, /, *, naming: Callable[[Document], TargetNames] | None = None, find: Find = find_nothing,
    note: Note = note_nothing,
) -> tuple[Piece, ...]:  # fmt: skip
    """The pieces of every mesh that a viewer shows, at rest, in the nodes' order.

    naming: finds what a document calls its targets; else by their own names; find: the bytes of a name beside the file,
    for the text of a .gltf; note: takes a sentence about what is left out. ValueError for an invalid file or one that
    is larger than any face.

    data: the file, binary or text.
    """
    text, binary = split_gltf(data)
    document = parse_document(text)
    judge_extensions(document, note)
    shown = shown_nodes(document)
    places = node_places(document)
    nodes = [(at, document.nodes[at].mesh) for at in places if at in shown]
    meshes = [(entry(document.meshes, mesh, "mesh"), at) for at, mesh in nodes if mesh is not None]
    primitives = [primitive for mesh, _ in meshes for primitive in mesh.primitives]
    _refuse_costly(document, primitives)
    refuse_packed(document, primitives)
    buffers = read_buffers(document, binary, find)
    reader = _Reader(document, buffers, None if naming is None else naming(document), note=note)
    return tuple(piece for mesh, at in meshes for piece in reader.pieces(mesh, at, places))


def _refuse_costly(document: Document, primitives: list[Primitive]) -> None:
    """Rejects documents that declare too many numbers, before any of them is allocated."""
    numbers = 0
    for primitive in primitives:
        points = entry(document.accessors, primitive.attributes.get("POSITION", -1), "positions in accessor")
        numbers += points.count * 3 * (1 + len(primitive.targets))
        if numbers > MOST_NUMBERS:
            raise ValueError(f"the file lays out more than {MOST_NUMBERS} numbers; export fewer meshes or targets")


class _Reader(SceneReader):
    """Reads the pieces of a document."""

    def pieces(self, mesh: Mesh, at: int, places: NodePlaces) -> list[Piece]:
        return [self.piece(mesh, primitive, at, places) for primitive in mesh.primitives]

    def piece(self, mesh: Mesh, primitive: Primitive, at: int, places: NodePlaces) -> Piece:
        name = self.document.nodes[at].name or mesh.name or "mesh"
        resting = self.at_rest(at, mesh, primitive, places)
        bad = np.flatnonzero(~np.isfinite(resting.points).all(axis=1))
        if len(bad):
            raise ValueError(
                f"vertex {bad[0]} of the mesh {name[:80]!r} is {resting.points[bad[0]].tolist()}; expected finite "
                "numbers: export it anew"
            )
        moves = {label: move for label, move in resting.moves.items() if np.isfinite(move).all()}
        for label in resting.moves.keys() - moves.keys():
            self.note(f"the shape {label[:80]!r} of the mesh {name[:80]!r} holds what is no number: it is left out")
        if any(len(rows_out_of_reach(values)) for values in (resting.points, *moves.values())):
            raise ValueError(f"mesh {name[:80]!r} stands further off than {FARTHEST:g} metres; export it in metres")
        return Piece(name, resting.points, self.rows(primitive, len(resting.points)), moves)

    def rows(self, primitive: Primitive, count: int) -> NDArray[np.int64] | None:
        if ROWS not in primitive.attributes:
            return None
        rows = self.numbers(primitive.attributes[ROWS], 1, ROWS, count)[:, 0]
        if len(rows) != count or (rows != np.rint(rows)).any() or (rows < NO_ROW).any():
            raise ValueError(f"{ROWS} holds no vertex for each of {count}; export the face from Omote anew")
        return rows.astype(np.int64)
