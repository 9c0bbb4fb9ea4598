"""The base colours of glTF materials: their pictures wherever they lie, and how texture coordinates lie on them."""

from __future__ import annotations

from typing import Annotated, Any

import msgspec
import numpy as np

from omote.arrays import Picture, Values
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.gltf_document import AccessorReader, Document, Whole, entry
from omote.interchange.formats.gltf_extensions import extends
from omote.interchange.formats.gltf_scene import read_uri
from omote.interchange.scans.atlas import plain_picture
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.picture_reader import MOST_PIXELS, read_picture
from omote.model.albedo import decode_light, encode_light

MOST_MATERIALS = 256
WEBP = "EXT_texture_webp"
OTHER_PICTURES = (WEBP, "EXT_texture_avif")
"""Extensions of textures whose pictures are read as PNG and JPEG are."""
UNREAD_PICTURES = {"KHR_texture_basisu": "KTX2", "MSFT_texture_dds": "DDS"}
"""Extensions of textures whose pictures are not read, and their format."""
SPECULAR = "KHR_materials_pbrSpecularGlossiness"
TRANSFORM = "KHR_texture_transform"
CLAMPED = 33071
MIRRORED = 33648

Pair = tuple[float, float]
Colour = Annotated[list[float], msgspec.Meta(min_length=4, max_length=4)]


class TextureInfo(msgspec.Struct, frozen=True, rename="camel"):
    """Which texture, by which set of coordinates."""

    index: Whole
    tex_coord: Whole = 0
    extensions: Any = None


class Metallic(msgspec.Struct, frozen=True, rename="camel"):
    """The colour of a material."""

    base_color_texture: TextureInfo | None = None
    base_color_factor: Colour = msgspec.field(default_factory=lambda: [1.0] * 4)


class Specular(msgspec.Struct, frozen=True, rename="camel"):
    """The colour of a material of the older kind."""

    diffuse_texture: TextureInfo | None = None
    diffuse_factor: Colour = msgspec.field(default_factory=lambda: [1.0] * 4)


class SurfaceMaterial(msgspec.Struct, frozen=True, rename="camel"):
    """A material."""

    pbr_metallic_roughness: Metallic = Metallic()
    name: str = ""
    extensions: Any = None


class Texture(msgspec.Struct, frozen=True, rename="camel"):
    """A texture: a picture, or one in a format that an extension adds; sampler: what is beyond its edges."""

    source: Whole | None = None
    sampler: Whole | None = None
    extensions: Any = None


class Sampler(msgspec.Struct, frozen=True, rename="camel"):
    """What a texture shows beyond its edges; by itself it repeats."""

    wrap_s: int = 0
    wrap_t: int = 0


class Image(msgspec.Struct, frozen=True, rename="camel"):
    """A picture in the file or elsewhere."""

    uri: str | None = None
    buffer_view: Whole | None = None


class TextureTransform(msgspec.Struct, frozen=True, rename="camel"):
    """How texture coordinates are moved before they look a picture up (KHR_texture_transform)."""

    offset: Pair = (0.0, 0.0)
    rotation: float = 0.0
    scale: Pair = (1.0, 1.0)
    tex_coord: Whole | None = None


class SceneDocument(Document, frozen=True, rename="camel"):
    """A document with what a viewer shows."""

    materials: list[SurfaceMaterial] = msgspec.field(default_factory=list)
    textures: list[Texture] = msgspec.field(default_factory=list)
    images: list[Image] = msgspec.field(default_factory=list)
    samplers: list[Sampler] = msgspec.field(default_factory=list)


def base_colour(material: SurfaceMaterial, /) -> tuple[TextureInfo | None, list[float]]:
    """The texture of a material's colour, and what it is multiplied by (4,), linear."""
    older = extends(material.extensions, SPECULAR)
    if older is None:
        return material.pbr_metallic_roughness.base_color_texture, material.pbr_metallic_roughness.base_color_factor
    try:
        specular = msgspec.convert(older, Specular)
    except msgspec.ValidationError:
        return None, [1.0] * 4
    return specular.diffuse_texture, specular.diffuse_factor


def material_pictures(document: SceneDocument, reader: AccessorReader, beside: Companions) -> list[Picture]:
    """The picture of each material: its texture in its colour, or its plain colour.

    document, reader: the glTF and its numbers; beside: what lies beside the file.
    """
    read: dict[int, Picture | None] = {}
    pictures = []
    pixels = 0
    for material in document.materials[:MOST_MATERIALS]:
        info, colour = base_colour(material)
        source = None if info is None else _source(document, info.index, beside)
        if source is not None and source not in read and pixels < MOST_PIXELS:
            read[source] = _picture(document, source, reader, beside)
            pixels += 0 if (new := read[source]) is None else new.size // 3
        picture = None if source is None else read.get(source)
        pictures.append(plain_picture(colour) if picture is None else _tinted(picture, colour))
    return pictures


def _tinted(picture: Picture, colour: list[float]) -> Picture:
    """A picture multiplied by a colour, linear, as viewers show it."""
    if all(part == 1.0 for part in colour[:3]):
        return picture
    levels = decode_light(np.arange(256, dtype=np.uint8))
    by_level = [encode_light(np.clip(levels * part, 0.0, 1.0)) for part in colour[:3]]
    return np.stack([table[picture[..., at]] for at, table in enumerate(by_level)], axis=-1)


def _source(document: SceneDocument, index: int, beside: Companions) -> int | None:
    texture = entry(document.textures, index, "texture")
    for name in OTHER_PICTURES:
        other = (extends(texture.extensions, name) or {}).get("source")
        if isinstance(other, int) and not isinstance(other, bool) and other >= 0:
            return other
    unread = next((name for name in UNREAD_PICTURES if extends(texture.extensions, name)), "")
    if unread and texture.source is None:
        beside.note(
            f"a texture of it is {UNREAD_PICTURES[unread]} ({unread}), which is not read here: export it with PNG or "
            "JPEG pictures"
        )
    return texture.source


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
        return read_uri(image.uri or "", beside.find)
    view = entry(reader.document.buffer_views, image.buffer_view, "buffer view")
    buffer = entry(reader.buffers, view.buffer, "buffer")
    return buffer[view.byte_offset : view.byte_offset + view.byte_length]


def texture_layout(document: SceneDocument, material: int | None, /) -> tuple[int, TextureTransform, Sampler]:
    """The set of coordinates by which a material's colour is looked up, how they are moved, and what is beyond its
    edges.

    document: the glTF; material: its number, None for none.
    """
    materials = document.materials
    info = base_colour(materials[material])[0] if material is not None and material < len(materials) else None
    if info is None:
        return 0, TextureTransform(), Sampler()
    moved = TextureTransform()
    if (said := extends(info.extensions, TRANSFORM)) is not None:
        try:
            moved = msgspec.convert(said, TextureTransform)
        except msgspec.ValidationError as error:
            raise ValueError(f"{TRANSFORM} of a texture is wrong ({explain_error(error)}); export it anew") from error
    sampler = entry(document.textures, info.index, "texture").sampler
    wraps = Sampler() if sampler is None else entry(document.samplers, sampler, "sampler")
    return info.tex_coord if moved.tex_coord is None else moved.tex_coord, moved, wraps


def place_texcoords(texcoords: Values, moved: TextureTransform, wraps: Sampler, /) -> Values:
    """Texture coordinates (n, 2) where they look a picture up: scaled, turned, shifted; at edges that do not repeat
    brought back into the picture.

    texcoords: v down; moved, wraps: of `texture_layout`.
    """
    sine = np.sin(moved.rotation)
    cosine = np.cos(moved.rotation)
    turn = np.array([[cosine, sine], [-sine, cosine]]) * moved.scale
    placed: Values = texcoords @ turn.T + moved.offset
    for at, wrap in enumerate((wraps.wrap_s, wraps.wrap_t)):
        if wrap == CLAMPED:
            placed[:, at] = np.clip(placed[:, at], 0.0, 1.0)
        if wrap == MIRRORED:
            placed[:, at] = 1.0 - np.abs(np.mod(placed[:, at], 2.0) - 1.0)
    return placed
