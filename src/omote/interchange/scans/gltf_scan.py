"""Parses untrusted glTF files (.glb, .gltf, .vrm) into one scan: every mesh that a viewer shows, at rest, joined."""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture, Rows, Values
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.file_content import describe_content
from omote.interchange.formats.glb_reader import MOST_TARGETS
from omote.interchange.formats.gltf_document import (
    AccessorReader,
    Document,
    Mesh,
    Node,
    Primitive,
    Whole,
    entry,
    node_places,
    parse_document_as,
    split_glb,
)
from omote.interchange.scans.atlas import join_textures, plain_picture
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.picture_reader import MOST_PIXELS, read_picture
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

NodePlaces = Mapping[int, Values]

TRIANGLES = 4
STRIP = 5
FAN = 6
POINTS = 0
"""Modes of primitives; the others are lines."""
MOST_MATERIALS = 256
WEBP = "EXT_texture_webp"
_MOST_JOINTS = 4096
_SHOWN = (TRIANGLES, STRIP, FAN, POINTS)
_COMPRESSED = ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression")


class SurfacePrimitive(Primitive, frozen=True, rename="camel"):
    """A primitive with its triangles and its material."""

    indices: Whole | None = None
    mode: Whole = TRIANGLES
    material: Whole | None = None
    extras: Any = None


class SurfaceMesh(Mesh, frozen=True, rename="camel"):
    """A mesh of such primitives."""

    primitives: list[SurfacePrimitive]  # type: ignore[assignment]


class SkinnedNode(Node, frozen=True, rename="camel"):
    """A node whose mesh a skin may place."""

    skin: Whole | None = None


class Skin(msgspec.Struct, frozen=True, rename="camel"):
    """Joints, and what brings the mesh into the space of each."""

    joints: list[Whole]
    inverse_bind_matrices: Whole | None = None


class TextureInfo(msgspec.Struct, frozen=True, rename="camel"):
    """Which texture, by which set of coordinates."""

    index: Whole
    tex_coord: Whole = 0


class Metallic(msgspec.Struct, frozen=True, rename="camel"):
    """The colour of a material."""

    base_color_texture: TextureInfo | None = None
    base_color_factor: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)


class SurfaceMaterial(msgspec.Struct, frozen=True, rename="camel"):
    """A material."""

    pbr_metallic_roughness: Metallic = Metallic()


class Texture(msgspec.Struct, frozen=True, rename="camel"):
    """A texture: a picture, or one in a format that an extension adds."""

    source: Whole | None = None
    extensions: dict[str, Any] = {}


class Image(msgspec.Struct, frozen=True, rename="camel"):
    """A picture in the file or elsewhere."""

    uri: str | None = None
    buffer_view: Whole | None = None


class SceneRoots(msgspec.Struct, frozen=True, rename="camel"):
    """The nodes that a scene shows, with all below them."""

    nodes: list[Whole] = msgspec.field(default_factory=list)


class SceneDocument(Document, frozen=True, rename="camel"):
    """A document with what a viewer shows."""

    nodes: list[SkinnedNode] = msgspec.field(default_factory=list)  # type: ignore[assignment]
    meshes: list[SurfaceMesh] = msgspec.field(default_factory=list)  # type: ignore[assignment]
    skins: list[Skin] = msgspec.field(default_factory=list)
    materials: list[SurfaceMaterial] = msgspec.field(default_factory=list)
    textures: list[Texture] = msgspec.field(default_factory=list)
    images: list[Image] = msgspec.field(default_factory=list)
    scenes: list[SceneRoots] = msgspec.field(default_factory=list)
    scene: Whole = 0


def shown_nodes(document: SceneDocument, /) -> set[int]:
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


def read_uri(uri: str, beside: Companions, /) -> bytes | None:
    """The bytes that a URI holds (data:...;base64,...) or names; None where nothing of its name lies beside the file.

    ValueError for one that holds none.

    uri: as the document has it; beside: what lies beside the file.
    """
    if not uri.startswith("data:"):
        return beside.find(_unquote(uri))
    head, comma, body = uri.partition(",")
    if not comma or not head.endswith(";base64"):
        raise ValueError(f"the file holds bytes as {head[:80]!r}; expected base64: export it as .glb")
    try:
        return base64.b64decode(body, validate=True)
    except (binascii.Error, ValueError):
        raise ValueError("the file holds bytes in base64 that is damaged; export it anew, as .glb") from None


def _unquote(uri: str) -> str:
    """A name without percent signs for its blanks and letters (RFC 3986, section 2.1)."""
    plain = re.sub(
        rb"%([0-9A-Fa-f]{2})", lambda match: bytes.fromhex(match[1].decode()), uri.encode("utf-8", "replace")
    )
    return plain.decode("utf-8", "replace")


def material_pictures(document: SceneDocument, reader: AccessorReader, beside: Companions) -> list[Picture]:
    """The picture of each material: its texture, or its plain colour.

    document, reader: the glTF and its numbers; beside: what lies beside the file.
    """
    read: dict[int, Picture | None] = {}
    pictures = []
    pixels = 0
    for material in document.materials[:MOST_MATERIALS]:
        info = material.pbr_metallic_roughness.base_color_texture
        source = None if info is None else _source(document, info.index)
        if source is not None and source not in read and pixels < MOST_PIXELS:
            read[source] = _picture(document, source, reader, beside)
            pixels += 0 if (new := read[source]) is None else new.size // 3
        picture = None if source is None else read.get(source)
        pictures.append(plain_picture(_base_colour(material)) if picture is None else picture)
    return pictures


def _base_colour(material: SurfaceMaterial) -> tuple[float, ...]:
    return material.pbr_metallic_roughness.base_color_factor[:3]


def _source(document: SceneDocument, index: int) -> int | None:
    texture = entry(document.textures, index, "texture")
    webp = texture.extensions.get(WEBP)
    other = webp.get("source") if isinstance(webp, dict) else None
    return other if isinstance(other, int) and other >= 0 else texture.source


def _picture(document: SceneDocument, source: int, reader: AccessorReader, beside: Companions) -> Picture | None:
    try:
        data = _image_bytes(entry(document.images, source, "image"), reader, beside)
        if data is None:
            beside.note("a texture that it names does not lie beside it: give both together")
            return None
        return read_picture(data)
    except (ValueError, OSError) as error:
        beside.note(f"a texture of it cannot be read ({explain_error(error)})")
        return None


def _image_bytes(image: Image, reader: AccessorReader, beside: Companions) -> bytes | None:
    if image.buffer_view is None:
        return read_uri(image.uri or "", beside)
    view = entry(reader.document.buffer_views, image.buffer_view, "buffer view")
    buffer = entry(reader.buffers, view.buffer, "buffer")
    return buffer[view.byte_offset : view.byte_offset + view.byte_length]


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
                points = points + count
                targets = targets + count * 3 * len(primitive.targets)
                corners += self._count(primitive.indices)
        refuse_many(points, "points", MOST_POINTS)
        refuse_many(targets, "numbers of morph targets", MOST_NUMBERS)
        refuse_many(corners // 3, "triangles", MOST_TRIANGLES)

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

    def _piece(self, mesh: SurfaceMesh, primitive: SurfacePrimitive, at: int, places: NodePlaces) -> ScenePiece:
        node = self.document.nodes[at]
        place = places[at]
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
        column = self.numbers(index, columns, what, MOST_POINTS)
        if len(column) != count:
            raise ValueError(f"{what} has {len(column)} rows and its mesh {count} vertices; export it anew")
        return column

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
        has_material = primitive.material is not None and primitive.material < len(materials)
        info = materials[primitive.material or 0].pbr_metallic_roughness.base_color_texture if has_material else None
        index = primitive.attributes.get(f"TEXCOORD_{0 if info is None else info.tex_coord}")
        return None if index is None else self._column(index, 2, "TEXCOORD", count)

    def _skin(self, primitive: SurfacePrimitive, node: SkinnedNode, count: int, places: NodePlaces) -> Values | None:
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


def _turned(points: Values, turn: Values) -> Values:
    """Points (n, 3) by one matrix (3, 3), or each by its own (n, 3, 3)."""
    turned: Values = points @ turn.T if turn.ndim == 2 else np.einsum("nij,nj->ni", turn, points)
    return turned


def _target_names(mesh: SurfaceMesh, primitive: SurfacePrimitive) -> list[str]:
    """The targets' names, in order; a name that is there twice gets a number."""
    count = len(primitive.targets)
    refuse_many(count, "morph targets of one mesh", MOST_TARGETS)
    target_names = mesh.extras.target_names if mesh.extras else []
    if not target_names and isinstance(primitive.extras, dict):  # where VRM 0 has them
        own = primitive.extras.get("targetNames")
        target_names = [name for name in own if isinstance(name, str)] if isinstance(own, list) else []
    names = list[str]()
    for at in range(count):
        name = target_names[at] if at < len(target_names) and target_names[at] else f"target_{at}"
        names.append(name if name not in names else f"{name} {at}")
    return names


def read_gltf(data: bytes, beside: Companions, /) -> Scan:
    """The scan in a glTF file, binary or text; beside: reads the buffers and pictures that lie beside it.

    ValueError for an invalid file.

    data: the file.
    """
    refuse_many(len(data), "bytes", LARGEST)
    text, binary = (data, b"") if data.lstrip()[:1] == b"{" else split_glb(data)
    document = parse_document_as(SceneDocument, text)
    squeezed = [name for name in document.extensions_required if name in _COMPRESSED]
    if squeezed:
        raise ValueError(f"the file is compressed ({squeezed[0]}); export it without compression")
    buffers = _buffers(document, binary, beside)
    reader = SceneReader(document, buffers)
    places = node_places(document)
    shown = shown_nodes(document)
    reader.refuse_costly([document.nodes[at] for at in places if at in shown])
    pieces = [piece for at in places if at in shown for piece in reader.pieces(at, places)]
    if not pieces:
        raise ValueError(f"the file shows no mesh of triangles ({describe_content(data)}); export the head as a mesh")
    return _join(pieces, material_pictures(document, reader, beside))


def _buffers(document: SceneDocument, binary: bytes, beside: Companions) -> list[bytes]:
    bodies = []
    for place, buffer in enumerate(document.buffers[:256]):
        body = binary if buffer.uri is None and place == 0 else read_uri(buffer.uri or "", beside)
        if body is None:
            name = (buffer.uri or f"buffer {place}")[-80:]
            raise ValueError(f"{name!r}, which holds its numbers, does not lie beside it; export one .glb of all")
        if buffer.byte_length > len(body):
            raise ValueError(
                f"buffer {place} has {buffer.byte_length} bytes, and the file holds {len(body)}; export it anew"
            )
        bodies.append(body)
    return bodies


def _join(pieces: list[ScenePiece], pictures: list[Picture]) -> Scan:
    """One scan of all pieces, doubled points joined."""
    begins = np.cumsum([0, *(len(piece.points) for piece in pieces)])
    points = np.concatenate([piece.points for piece in pieces])
    triangles = np.concatenate([piece.triangles + begin for piece, begin in zip(pieces, begins[:-1], strict=True)])
    of = np.repeat([piece.material for piece in pieces], [len(piece.triangles) for piece in pieces])
    texcoords = np.concatenate([_texcoords(piece)[piece.triangles] for piece in pieces])
    if (of < 0).any():  # what has no material is grey in the picture of all
        of = np.where(of < 0, len(pictures), of)
    texture, moved = join_textures([*pictures, None], texcoords, of) if len(of) else (None, None)
    return weld_scan(make_scan(points, triangles, _colours(pieces), texture, moved, _shapes(pieces, begins)))


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
