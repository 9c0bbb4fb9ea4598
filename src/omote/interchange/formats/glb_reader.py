"""Parses meshes with named morph targets (blendshapes) from untrusted GLB files.

All that a file declares is validated: chunks, views, accessors, strides, sparse indices, nodes. Memory is bounded
before it is allocated, nothing outside the file is opened, and invalid files are rejected with an error message.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from omote.geometry.mesh import FARTHEST, rows_out_of_reach
from omote.interchange.formats.file_content import describe_content
from omote.interchange.formats.glb_writer import BIN_CHUNK, JSON_CHUNK, MAGIC, ROWS, VERSION
from omote.interchange.formats.gltf_document import Accessor, Document, Mesh, Node, Primitive, Sparse, parse_document

Values = NDArray[np.float64]
T = TypeVar("T")

LARGEST = 512 * 2**20
"""Bytes of a file at most."""
MOST_VERTICES, MOST_TARGETS, MOST_NUMBERS = 1_000_000, 1024, 40_000_000
"""Of one primitive; and numbers of all together: every expression of the cast on a head with hair makes 15 million."""
_COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_KNOWN = frozenset({"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform", "KHR_materials_specular"})


@dataclass(frozen=True, eq=False)
class Piece:
    """One primitive where it stands in the scene.

    points (n, 3) metres; moves: what each target adds to them (n, 3); rows (n,): the vertices of a cast that they are,
    where the file says so.
    """

    name: str
    points: Values
    rows: NDArray[np.int64] | None = None
    moves: Mapping[str, Values] = field(default_factory=dict)


def read_glb(data: bytes, /) -> tuple[Piece, ...]:
    """The pieces of every mesh that a node shows, in the nodes' order.

    ValueError for an invalid GLB or one that is larger than any face.
    """
    text, binary = _chunks(data)
    document = parse_document(text)
    _refuse_outside(document, binary)
    shown = [(document.nodes[node], place) for node, place in _places(document).items()]
    meshes = [(_at(document.meshes, node.mesh, "mesh"), node, place) for node, place in shown if node.mesh is not None]
    _refuse_costly(document, [primitive for mesh, _, _ in meshes for primitive in mesh.primitives])
    reader = _Reader(document, binary)
    return tuple(piece for mesh, node, place in meshes for piece in reader.pieces(mesh, node, place))


def _chunks(data: bytes) -> tuple[bytes, bytes]:
    if len(data) > LARGEST:
        raise ValueError(f"the file has {len(data)} bytes; expected {LARGEST} at most")
    if len(data) < 20 or struct.unpack_from("<I", data)[0] != MAGIC:
        what = "its beginning alone" if data.startswith(MAGIC.to_bytes(4, "little")) else describe_content(data)
        raise ValueError(f"the file is no GLB, but {what}; export the head as glTF binary (.glb)")
    _, version, length = struct.unpack_from("<III", data)
    if version != VERSION:
        raise ValueError(f"the file is glTF {version}; expected version {VERSION}: export it anew")
    if length != len(data):
        raise ValueError(f"the file says that it has {length} bytes and has {len(data)}; it is cut short: copy it anew")
    found, at = list[tuple[int, bytes]](), 12
    while at < len(data):
        if at + 8 > len(data) or at + 8 + struct.unpack_from("<I", data, at)[0] > len(data):
            raise ValueError(f"the chunk at byte {at} reaches beyond the file; export it anew")
        size, kind = struct.unpack_from("<II", data, at)
        found.append((kind, data[at + 8 : at + 8 + size]))
        at += 8 + size
    if found[0][0] != JSON_CHUNK:
        raise ValueError("the file's first chunk is no JSON; export it anew")
    return found[0][1], next((body for kind, body in found[1:2] if kind == BIN_CHUNK), b"")


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
        points = _at(document.accessors, primitive.attributes.get("POSITION", -1), "positions in accessor")
        numbers += points.count * 3 * (1 + len(primitive.targets))
        if numbers > MOST_NUMBERS:
            raise ValueError(f"the file lays out more than {MOST_NUMBERS} numbers; export fewer meshes or targets")


class _Reader:
    """A document with its bytes."""

    def __init__(self, document: Document, binary: bytes) -> None:
        self.document, self.binary = document, binary

    def pieces(self, mesh: Mesh, node: Node, place: Values) -> list[Piece]:
        name = node.name or mesh.name or "mesh"
        return [self.piece(mesh, primitive, name, place) for primitive in mesh.primitives]

    def piece(self, mesh: Mesh, primitive: Primitive, name: str, place: Values) -> Piece:
        points = self.numbers(primitive.attributes["POSITION"], 3, "POSITION")
        moves = {
            label: self.moves(target, len(points)) @ place[:3, :3].T
            for label, target in zip(_labels(mesh, primitive, name), primitive.targets, strict=True)
        }
        standing = points @ place[:3, :3].T + place[:3, 3]
        if any(len(rows_out_of_reach(values)) for values in (standing, *moves.values())):
            raise ValueError(f"mesh {name[:80]!r} stands further off than {FARTHEST:g} metres; export it in metres")
        return Piece(name, standing, self.rows(primitive, len(points)), moves)

    def moves(self, target: Mapping[str, int], count: int) -> Values:
        """What a target adds to positions; one without positions adds nothing."""
        if "POSITION" not in target:
            return np.zeros((count, 3))
        found = self.numbers(target["POSITION"], 3, "POSITION of a target", count)
        if len(found) != count:
            raise ValueError(f"a target has {len(found)} vertices and its mesh {count}; export it anew")
        return found

    def rows(self, primitive: Primitive, count: int) -> NDArray[np.int64] | None:
        if ROWS not in primitive.attributes:
            return None
        rows = self.numbers(primitive.attributes[ROWS], 1, ROWS, count)[:, 0]
        if len(rows) != count or (rows != np.rint(rows)).any() or (rows < 0).any():
            raise ValueError(f"{ROWS} holds no vertex for each of {count}; export the face from Omote anew")
        return rows.astype(np.int64)

    def numbers(self, index: int, columns: int, what: str, most: int = MOST_VERTICES) -> Values:
        """The values (count, columns) of an accessor, its sparse ones in place, all finite."""
        accessor = _at(self.document.accessors, index, "accessor")
        if _COLUMNS.get(accessor.type) != columns or not 0 < accessor.count <= most:
            raise ValueError(
                f"{what} is {accessor.count} of {accessor.type[:20]!r}; expected 1 to {most} of {columns} numbers each"
            )
        if accessor.buffer_view is None:
            values = np.zeros((accessor.count, columns))
        else:
            values = self.read_numbers(accessor.buffer_view, accessor, accessor.byte_offset, accessor.count, columns)
        if accessor.sparse is not None:
            self.sparse(accessor, accessor.sparse, values)
        if not np.isfinite(values).all():
            raise ValueError(f"{what} holds numbers that are not finite; export it anew")
        return values

    def sparse(self, accessor: Accessor, sparse: Sparse, values: Values) -> None:
        if not 0 < sparse.count <= accessor.count or sparse.indices.component_type not in (5121, 5123, 5125):
            raise ValueError(f"a sparse accessor has {sparse.count} values of {accessor.count}; export it anew")
        kind = Accessor(sparse.count, "SCALAR", sparse.indices.component_type)
        at = self.read_numbers(sparse.indices.buffer_view, kind, sparse.indices.byte_offset, sparse.count, 1)[:, 0]
        if (np.diff(at) <= 0).any() or at[-1] >= accessor.count:
            raise ValueError("the places of a sparse accessor do not rise within its vertices; export it anew")
        kept = sparse.values
        values[at.astype(np.int64)] = self.read_numbers(
            kept.buffer_view, accessor, kept.byte_offset, sparse.count, values.shape[1]
        )

    def read_numbers(self, view: int, accessor: Accessor, offset: int, count: int, columns: int) -> Values:
        """Numbers (count, columns) from a view, of the accessor's kind."""
        found = _at(self.document.buffer_views, view, "buffer view")
        if accessor.component_type not in _COMPONENTS:
            raise ValueError(f"numbers of kind {accessor.component_type} are none of glTF's; export it anew")
        kind = np.dtype(_COMPONENTS[accessor.component_type])
        stride = found.byte_stride or kind.itemsize * columns
        begin, end = found.byte_offset, found.byte_offset + found.byte_length
        last = begin + offset + stride * (count - 1) + kind.itemsize * columns
        if found.buffer != 0 or end > len(self.binary) or last > end or stride < kind.itemsize * columns:
            raise ValueError(
                f"buffer view {view} does not hold the {count} values that are read from it; export it anew"
            )
        values = np.ndarray(
            (count, columns), kind, self.binary, begin + offset, (stride, kind.itemsize)
        ).astype(np.float64)  # fmt: skip
        if accessor.normalized and kind.kind in "iu":
            values = np.maximum(values / np.iinfo(kind).max, -1.0)
        return values


def _labels(mesh: Mesh, primitive: Primitive, name: str) -> list[str]:
    """The targets' names, in order."""
    count, names = len(primitive.targets), mesh.extras.target_names if mesh.extras else []
    if count > MOST_TARGETS:
        raise ValueError(f"mesh {name[:80]!r} has {count} targets; expected {MOST_TARGETS} at most")
    labels = [names[at] if at < len(names) and names[at] else f"target_{at}" for at in range(count)]
    if len(set(labels)) < count:
        doubled = next(label for label in labels if labels.count(label) > 1)
        raise ValueError(f"mesh {name[:80]!r} has two targets named {doubled[:80]!r}; rename one")
    return labels


def _places(document: Document) -> dict[int, Values]:
    """Where each node stands, (4, 4): the nodes are walked from those that are nobody's child."""
    children = {child for node in document.nodes for child in node.children}
    waiting = [(at, np.eye(4)) for at in range(len(document.nodes)) if at not in children]
    places: dict[int, Values] = {}
    while waiting:
        at, above = waiting.pop()
        node = _at(document.nodes, at, "node")
        if at in places:
            raise ValueError(f"node {at} hangs under two others; export the scene anew")
        places[at] = above @ _transform(node)
        if len(rows_out_of_reach(places[at])):
            raise ValueError(f"node {at} stands nowhere: its place is out of all reach; export the scene anew")
        waiting += [(child, places[at]) for child in node.children]
    return dict(sorted(places.items()))


def _transform(node: Node) -> Values:
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T
    x, y, z, w = node.rotation
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = turn * node.scale, node.translation
    return place


def _at(entries: list[T], index: int, what: str) -> T:
    if not 0 <= index < len(entries):
        raise ValueError(f"the file speaks of {what} {index} and has {len(entries)}; export it anew")
    return entries[index]
