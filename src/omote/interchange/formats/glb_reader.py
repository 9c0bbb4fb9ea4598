"""Parses meshes with named morph targets (blendshapes) from untrusted GLB files.

All that a file declares is validated: chunks, views, accessors, strides, sparse indices, nodes. Memory is bounded
before it is allocated, nothing outside the file is opened, and invalid files are rejected with an error message.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.geometry.mesh import FARTHEST, rows_out_of_reach
from omote.interchange.formats.glb_writer import ROWS
from omote.interchange.formats.gltf_document import (
    AccessorReader,
    Document,
    Mesh,
    Primitive,
    entry,
    node_places,
    parse_document,
    split_glb,
)

MOST_TARGETS = 1024
MOST_NUMBERS = 40_000_000
"""Of one primitive; and numbers of all together: every expression of the cast on a head with hair makes 15 million."""
_KNOWN = frozenset({"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform", "KHR_materials_specular"})


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


class TargetNames(Protocol):
    """What the targets of nodes are called, and what is made of them."""

    def rename(self, node: int, names: Sequence[str], moves: Mapping[str, Values], /) -> Mapping[str, Values]:
        """What a node's targets, `names` in the order of the file, do under the names that count.

        node: its number; names: of the targets; moves (n, 3): by those names, metres.
        """


def read_glb(data: bytes, /, *, naming: Callable[[Document], TargetNames] | None = None) -> tuple[Piece, ...]:
    """The pieces of every mesh that a node shows, in the nodes' order.

    naming: finds what a document calls its targets; else by their own names. ValueError for an invalid GLB or one that
    is larger than any face.

    data: the file.
    """
    text, binary = split_glb(data)
    document = parse_document(text)
    _refuse_outside(document, binary)
    shown = [(at, document.nodes[at].mesh, place) for at, place in node_places(document).items()]
    meshes = [(entry(document.meshes, mesh, "mesh"), at, place) for at, mesh, place in shown if mesh is not None]
    _refuse_costly(document, [primitive for mesh, _, _ in meshes for primitive in mesh.primitives])
    reader = _Reader(document, (binary,), None if naming is None else naming(document))
    return tuple(piece for mesh, at, place in meshes for piece in reader.pieces(mesh, at, place))


def _refuse_outside(document: Document, binary: bytes) -> None:
    unknown = sorted(set(document.extensions_required) - _KNOWN)
    if unknown:
        raise ValueError(f"the file needs {', '.join(unknown)[:200]}; export it without compression and extensions")
    for place, buffer in enumerate(document.buffers):
        if buffer.uri is not None or place > 0:
            raise ValueError(f"buffer {place} lies outside the file; export everything into one GLB")
        if buffer.byte_length > len(binary):
            raise ValueError(
                f"buffer 0 has {buffer.byte_length} bytes, and the file holds {len(binary)}; export it anew"
            )


def _refuse_costly(document: Document, primitives: list[Primitive]) -> None:
    """Rejects documents that declare too many numbers, before any of them is allocated."""
    numbers = 0
    for primitive in primitives:
        points = entry(document.accessors, primitive.attributes.get("POSITION", -1), "positions in accessor")
        numbers += points.count * 3 * (1 + len(primitive.targets))
        if numbers > MOST_NUMBERS:
            raise ValueError(f"the file lays out more than {MOST_NUMBERS} numbers; export fewer meshes or targets")


class _Reader(AccessorReader):
    """Reads the pieces of a document; named: what its targets are called."""

    def __init__(self, document: Document, buffers: Sequence[bytes], named: TargetNames | None) -> None:
        super().__init__(document, buffers)
        self.named = named

    def pieces(self, mesh: Mesh, at: int, place: Values) -> list[Piece]:
        return [self.piece(mesh, primitive, at, place) for primitive in mesh.primitives]

    def piece(self, mesh: Mesh, primitive: Primitive, at: int, place: Values) -> Piece:
        name = self.document.nodes[at].name or mesh.name or "mesh"
        points = self.numbers(primitive.attributes["POSITION"], 3, "POSITION")
        labels = _labels(mesh, primitive, name)
        moves: Mapping[str, Values] = {
            label: self.moves(target, len(points)) @ place[:3, :3].T
            for label, target in zip(labels, primitive.targets, strict=True)
        }
        moves = moves if self.named is None else self.named.rename(at, labels, moves)
        standing = points @ place[:3, :3].T + place[:3, 3]
        if any(len(rows_out_of_reach(values)) for values in (standing, *moves.values())):
            raise ValueError(f"mesh {name[:80]!r} stands further off than {FARTHEST:g} metres; export it in metres")
        return Piece(name, standing, self.rows(primitive, len(points)), moves)

    def moves(self, target: Mapping[str, int], count: int) -> Values:
        """What a target adds to positions; one without positions adds nothing."""
        if "POSITION" not in target:
            return np.zeros((count, 3))
        moves = self.numbers(target["POSITION"], 3, "POSITION of a target", count)
        if len(moves) != count:
            raise ValueError(f"a target has {len(moves)} vertices and its mesh {count}; export it anew")
        return moves

    def rows(self, primitive: Primitive, count: int) -> NDArray[np.int64] | None:
        if ROWS not in primitive.attributes:
            return None
        rows = self.numbers(primitive.attributes[ROWS], 1, ROWS, count)[:, 0]
        if len(rows) != count or (rows != np.rint(rows)).any() or (rows < 0).any():
            raise ValueError(f"{ROWS} holds no vertex for each of {count}; export the face from Omote anew")
        return rows.astype(np.int64)


def _labels(mesh: Mesh, primitive: Primitive, name: str) -> list[str]:
    """The targets' names, in order."""
    count = len(primitive.targets)
    names = mesh.extras.target_names if mesh.extras else []
    if count > MOST_TARGETS:
        raise ValueError(f"mesh {name[:80]!r} has {count} targets; expected {MOST_TARGETS} at most")
    labels = [names[at] if at < len(names) and names[at] else f"target_{at}" for at in range(count)]
    if len(set(labels)) < count:
        doubled = next(label for label in labels if labels.count(label) > 1)
        raise ValueError(f"mesh {name[:80]!r} has two targets named {doubled[:80]!r}; rename one")
    return labels
