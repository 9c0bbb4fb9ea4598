"""The part of a glTF document that describes vertices and morph targets; everything else is ignored."""

from __future__ import annotations

from typing import Annotated, Any, TypeVar

import msgspec

from omote.interchange.formats.error_reasons import explain_error

Whole = Annotated[int, msgspec.Meta(ge=0, le=2**31)]
Quad = tuple[float, float, float, float]
Triple = tuple[float, float, float]

LARGEST = 64 * 2**20
"""Bytes of JSON at most."""


class Buffer(msgspec.Struct, frozen=True, rename="camel"):
    """Bytes, in the file or elsewhere (uri)."""

    byte_length: Whole
    uri: str | None = None


class View(msgspec.Struct, frozen=True, rename="camel"):
    """A stretch of a buffer."""

    buffer: Whole
    byte_length: Whole
    byte_offset: Whole = 0
    byte_stride: Whole = 0


class Places(msgspec.Struct, frozen=True, rename="camel"):
    """Where the vertices of a sparse accessor lie."""

    buffer_view: Whole
    component_type: Whole
    byte_offset: Whole = 0


class Kept(msgspec.Struct, frozen=True, rename="camel"):
    """Where the values of a sparse accessor lie."""

    buffer_view: Whole
    byte_offset: Whole = 0


class Sparse(msgspec.Struct, frozen=True, rename="camel"):
    """Values of some vertices in place of what the accessor has there."""

    count: Whole
    indices: Places
    values: Kept


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
    """Vertices by attribute, and what each target adds to them."""

    attributes: dict[str, Whole]
    targets: list[dict[str, Whole]] = []


class Extras(msgspec.Struct, frozen=True, rename="camel"):
    """What programs agree to write beside the format: the targets' names."""

    target_names: list[str] = []


class Mesh(msgspec.Struct, frozen=True, rename="camel"):
    """A mesh of primitives."""

    primitives: list[Primitive]
    name: str = ""
    extras: Extras | None = None


class Node(msgspec.Struct, frozen=True, rename="camel"):
    """A place in the scene, by a matrix or by translation, rotation and scale, and what stands there."""

    name: str = ""
    mesh: Whole | None = None
    children: list[Whole] = []
    matrix: Annotated[list[float], msgspec.Meta(min_length=16, max_length=16)] | None = None
    translation: Triple = (0.0, 0.0, 0.0)
    rotation: Quad = (0.0, 0.0, 0.0, 1.0)
    scale: Triple = (1.0, 1.0, 1.0)


class Document(msgspec.Struct, frozen=True, rename="camel"):
    """A glTF document."""

    nodes: list[Node] = []
    meshes: list[Mesh] = []
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
    """Parses and validates the JSON as a document of which more is described; ValueError for an invalid one."""
    if len(text) > LARGEST:
        raise ValueError(f"the file's JSON has {len(text)} bytes; expected {LARGEST} at most")
    try:
        return msgspec.json.decode(text, type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"the file's JSON is no glTF document ({explain_error(error)}); export it anew") from error
