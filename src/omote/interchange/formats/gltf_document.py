"""The part of a glTF document that describes vertices and morph targets: accessors' numbers and the places of nodes.

What a file declares is validated before memory is allocated; nothing outside the given bytes is opened.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence
from typing import Annotated, Any, TypeVar

import msgspec
import numpy as np

from omote.arrays import Values
from omote.geometry.mesh import FARTHEST, rows_out_of_reach
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.file_content import describe_content, strip_mark
from omote.interchange.formats.glb_writer import BIN_CHUNK, JSON_CHUNK, MAGIC, VERSION

Whole = Annotated[int, msgspec.Meta(ge=0, le=2**31)]
Quad = tuple[float, float, float, float]
Triple = tuple[float, float, float]
LARGEST_JSON = 64 * 2**20
"""Bytes of JSON at most."""
T = TypeVar("T")
LARGEST = 512 * 2**20
"""Bytes of a file at most."""
MOST_VERTICES = 1_000_000
"""Of one primitive."""
TRIANGLES = 4
"""The mode of a primitive that says none."""
_COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}


class Buffer(msgspec.Struct, frozen=True, rename="camel"):
    """Bytes, in the file or elsewhere (uri)."""

    byte_length: Whole
    uri: str | None = None
    extensions: Any = None


class View(msgspec.Struct, frozen=True, rename="camel"):
    """A stretch of a buffer."""

    buffer: Whole
    byte_length: Whole
    byte_offset: Whole = 0
    byte_stride: Whole = 0


class SparseRows(msgspec.Struct, frozen=True, rename="camel"):
    """Where the vertices of a sparse accessor lie."""

    buffer_view: Whole
    component_type: Whole
    byte_offset: Whole = 0


class SparseValues(msgspec.Struct, frozen=True, rename="camel"):
    """Where the values of a sparse accessor lie."""

    buffer_view: Whole
    byte_offset: Whole = 0


class Sparse(msgspec.Struct, frozen=True, rename="camel"):
    """Values of some vertices in place of what the accessor has there."""

    count: Whole
    indices: SparseRows
    values: SparseValues


class Accessor(msgspec.Struct, frozen=True, rename="camel"):
    """Numbers of one kind; without a view all zero."""

    count: Whole
    type: str
    component_type: Whole
    buffer_view: Whole | None = None
    byte_offset: Whole = 0
    normalized: bool = False
    sparse: Sparse | None = None


class Primitive(msgspec.Struct, frozen=True, rename="camel"):
    """Vertices by attribute, what each target adds to them, triangles and material."""

    attributes: dict[str, Whole]
    targets: list[dict[str, Any]] = []
    indices: Whole | None = None
    mode: Whole = TRIANGLES
    material: Whole | None = None
    extras: Any = None
    extensions: Any = None


class Mesh(msgspec.Struct, frozen=True, rename="camel"):
    """A mesh of primitives; weights: of its targets at rest; extras: any JSON, where programs agree to name targets."""

    primitives: list[Primitive]
    name: str = ""
    weights: list[float] = []
    extras: Any = None


class Node(msgspec.Struct, frozen=True, rename="camel"):
    """A place in the scene, by a matrix or by translation, rotation and scale, and what stands there; weights: of the
    mesh's targets at this node, in place of the mesh's own."""

    name: str = ""
    mesh: Whole | None = None
    children: list[Whole] = []
    matrix: Annotated[list[float], msgspec.Meta(min_length=16, max_length=16)] | None = None
    translation: Triple = (0.0, 0.0, 0.0)
    rotation: Quad = (0.0, 0.0, 0.0, 1.0)
    scale: Triple = (1.0, 1.0, 1.0)
    skin: Whole | None = None
    weights: list[float] | None = None


class Skin(msgspec.Struct, frozen=True, rename="camel"):
    """Joints, and what brings the mesh into the space of each."""

    joints: list[Whole]
    inverse_bind_matrices: Whole | None = None


class SceneRoots(msgspec.Struct, frozen=True, rename="camel"):
    """The nodes that a scene shows, with all below them."""

    nodes: list[Whole] = []


class Document(msgspec.Struct, frozen=True, rename="camel"):
    """A glTF document."""

    nodes: list[Node] = []
    meshes: list[Mesh] = []
    skins: list[Skin] = []
    scenes: list[SceneRoots] = []
    scene: Whole = 0
    accessors: list[Accessor] = []
    buffer_views: list[View] = []
    buffers: list[Buffer] = []
    extensions_required: list[str] = []
    extensions: Any = None


D = TypeVar("D", bound=Document)


def parse_document(text: bytes, /) -> Document:
    """Parses and validates the JSON of a GLB's first chunk; ValueError for an invalid document."""
    return parse_document_as(Document, text)


def parse_document_as(kind: type[D], text: bytes, /) -> D:
    """Parses and validates the JSON as a document of which more is described; ValueError for an invalid one.

    kind: the class of the document; text: its JSON.
    """
    if len(text) > LARGEST_JSON:
        raise ValueError(f"the file's JSON has {len(text)} bytes; expected {LARGEST_JSON} at most")
    try:
        return msgspec.json.decode(strip_mark(text), type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"the file's JSON is no glTF document ({explain_error(error)}); export it anew") from error


def split_gltf(data: bytes, /) -> tuple[bytes, bytes]:
    """The JSON of a glTF file, binary (.glb) or text (.gltf), and the binary chunk; ValueError for an invalid one."""
    return (data, b"") if strip_mark(data[:64]).lstrip()[:1] == b"{" else split_glb(data)


def split_glb(data: bytes, /) -> tuple[bytes, bytes]:
    """The JSON and the binary chunk of a GLB; ValueError for an invalid one."""
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
    chunks = list[tuple[int, bytes]]()
    at = 12
    while at < len(data):
        if at + 8 > len(data) or at + 8 + struct.unpack_from("<I", data, at)[0] > len(data):
            raise ValueError(f"the chunk at byte {at} reaches beyond the file; export it anew")
        size, kind = struct.unpack_from("<II", data, at)
        chunks.append((kind, data[at + 8 : at + 8 + size]))
        at += 8 + size
    if chunks[0][0] != JSON_CHUNK:
        raise ValueError("the file's first chunk is no JSON; export it anew")
    return chunks[0][1], next((body for kind, body in chunks[1:2] if kind == BIN_CHUNK), b"")


class AccessorReader:
    """Reads the accessors of a document from its buffers."""

    def __init__(self, document: Document, buffers: Sequence[bytes]) -> None:
        self.document = document
        self.buffers = buffers

    def numbers(
        self, index: int, columns: int, what: str, most: int = MOST_VERTICES, *, finite: bool = True,
        normalized: bool = False,
    ) -> Values:  # fmt: skip
        """The values (count, columns) of an accessor, its sparse ones in place.

        index: the accessor's; columns: numbers of each value; what: its name in a message; most: values; finite:
        whether one that is no finite number is refused; normalized: whole numbers are parts of one whatever it says.
        """
        accessor = entry(self.document.accessors, index, "accessor")
        if _COLUMNS.get(accessor.type) != columns or not 0 < accessor.count <= most:
            raise ValueError(
                f"{what} is {accessor.count} of {accessor.type[:20]!r}; expected 1 to {most} of {columns} numbers each"
            )
        if normalized and not accessor.normalized:
            accessor = msgspec.structs.replace(accessor, normalized=True)
        if accessor.buffer_view is None:
            values = np.zeros((accessor.count, columns))
        else:
            values = self._read_view(accessor.buffer_view, accessor, accessor.byte_offset, accessor.count, columns)
        if accessor.sparse is not None:
            self._place_sparse(accessor, accessor.sparse, values)
        if finite and not np.isfinite(values).all():
            bad = int((~np.isfinite(values)).any(axis=1).argmax())
            raise ValueError(f"{what} {bad} is {values[bad].tolist()}; expected finite numbers: export it anew")
        return values

    def _place_sparse(self, accessor: Accessor, sparse: Sparse, values: Values) -> None:
        if not 0 < sparse.count <= accessor.count or sparse.indices.component_type not in (5121, 5123, 5125):
            raise ValueError(f"a sparse accessor has {sparse.count} values of {accessor.count}; export it anew")
        kind = Accessor(sparse.count, "SCALAR", sparse.indices.component_type)
        at = self._read_view(sparse.indices.buffer_view, kind, sparse.indices.byte_offset, sparse.count, 1)[:, 0]
        if (np.diff(at) <= 0).any() or at[-1] >= accessor.count:
            raise ValueError("the places of a sparse accessor do not rise within its vertices; export it anew")
        kept = sparse.values
        values[at.astype(np.int64)] = self._read_view(
            kept.buffer_view, accessor, kept.byte_offset, sparse.count, values.shape[1]
        )

    def _read_view(self, view: int, accessor: Accessor, offset: int, count: int, columns: int) -> Values:
        """Numbers (count, columns) from a view, of the accessor's kind."""
        buffer_view = entry(self.document.buffer_views, view, "buffer view")
        buffer = self.buffers[buffer_view.buffer] if buffer_view.buffer < len(self.buffers) else b""
        if accessor.component_type not in _COMPONENTS:
            raise ValueError(f"numbers of kind {accessor.component_type} are none of glTF's; export it anew")
        kind = np.dtype(_COMPONENTS[accessor.component_type])
        stride = buffer_view.byte_stride or kind.itemsize * columns
        begin = buffer_view.byte_offset
        end = buffer_view.byte_offset + buffer_view.byte_length
        last = begin + offset + stride * (count - 1) + kind.itemsize * columns
        if end > len(buffer) or last > end or stride < kind.itemsize * columns:
            raise ValueError(
                f"buffer view {view} does not hold the {count} values that are read from it; export it anew"
            )
        laid = np.ndarray((count, columns), kind, buffer, begin + offset, (stride, kind.itemsize))
        with np.errstate(invalid="ignore"):  # of numbers that are none, which are refused by who asks
            values = laid.astype(np.float64)
        if accessor.normalized and kind.kind in "iu":
            values = np.maximum(values / np.iinfo(kind).max, -1.0)
        return values


def node_places(document: Document, /) -> dict[int, Values]:
    """Where each node stands, (4, 4): the nodes are walked from those that are nobody's child."""
    children = {child for node in document.nodes for child in node.children}
    waiting = [(at, np.eye(4)) for at in range(len(document.nodes)) if at not in children]
    places: dict[int, Values] = {}
    while waiting:
        at, above = waiting.pop()
        node = entry(document.nodes, at, "node")
        if at in places:
            raise ValueError(f"node {at} hangs under two others; export the scene anew")
        places[at] = above @ _transform(node)
        if len(rows_out_of_reach(places[at])):
            raise ValueError(f"node {at} stands nowhere: its place is out of all reach; export the scene anew")
        waiting += [(child, places[at]) for child in node.children]
    return dict(sorted(places.items()))


def shown_nodes(document: Document, /) -> set[int]:
    """The nodes of the scene that viewers show; all where the document has no scenes."""
    if not document.scenes:
        return set(range(len(document.nodes)))
    shown = set[int]()
    waiting = list(document.scenes[min(document.scene, len(document.scenes) - 1)].nodes)
    while waiting:
        at = waiting.pop()
        if at not in shown and at < len(document.nodes):
            shown.add(at)
            waiting += document.nodes[at].children
    return shown


def _transform(node: Node) -> Values:
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T
    length = math.hypot(*node.rotation)
    unit = length if 0.0 < length < FARTHEST else 1.0
    x, y, z, w = (part / unit for part in node.rotation)
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


def entry(entries: Sequence[T], index: int, what: str, /) -> T:
    """The entry that a document names; ValueError where it has none of this number.

    entries: of one kind; index: from 0; what: the kind's name in a message.
    """
    if not 0 <= index < len(entries):
        raise ValueError(f"the file speaks of {what} {index} and has {len(entries)}; export it anew")
    return entries[index]
