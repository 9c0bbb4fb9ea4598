"""The base colours of the materials of glTF documents, from pictures in the file, in data URIs or beside it."""

from __future__ import annotations

import base64
import binascii
import re

from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.gltf_accessors import AccessorReader, entry
from omote.interchange.scans.atlas import Picture, plain_picture
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf.gltf_scene import Image, Material, SceneDocument
from omote.interchange.scans.picture_reader import MOST_PIXELS, read_picture

MOST_MATERIALS = 256
WEBP = "EXT_texture_webp"


def read_uri(uri: str, beside: Companions, /) -> bytes | None:
    """The bytes that a URI holds (data:...;base64,...) or names; None where nothing of its name lies beside the file.

    ValueError for one that holds none.
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
        rb"%([0-9A-Fa-f]{2})", lambda found: bytes.fromhex(found[1].decode()), uri.encode("utf-8", "replace")
    )
    return plain.decode("utf-8", "replace")


def material_pictures(document: SceneDocument, reader: AccessorReader, beside: Companions) -> list[Picture]:
    """The picture of each material: its texture, or its plain colour."""
    read: dict[int, Picture | None] = {}
    pictures, pixels = [], 0
    for material in document.materials[:MOST_MATERIALS]:
        info = material.pbr_metallic_roughness.base_color_texture
        source = None if info is None else _source(document, info.index)
        if source is not None and source not in read and pixels < MOST_PIXELS:
            read[source] = _picture(document, source, reader, beside)
            pixels += 0 if (new := read[source]) is None else new.size // 3
        found = None if source is None else read.get(source)
        pictures.append(plain_picture(_colour(material)) if found is None else found)
    return pictures


def _colour(material: Material) -> tuple[float, ...]:
    return material.pbr_metallic_roughness.base_color_factor[:3]


def _source(document: SceneDocument, index: int) -> int | None:
    texture = entry(document.textures, index, "texture")
    webp = texture.extensions.get(WEBP)
    other = webp.get("source") if isinstance(webp, dict) else None
    return other if isinstance(other, int) and other >= 0 else texture.source


def _picture(document: SceneDocument, source: int, reader: AccessorReader, beside: Companions) -> Picture | None:
    try:
        data = _bytes(entry(document.images, source, "image"), reader, beside)
        if data is None:
            beside.note("a texture that it names does not lie beside it: give both together")
            return None
        return read_picture(data)
    except (ValueError, OSError) as error:
        beside.note(f"a texture of it cannot be read ({explain_error(error)})")
        return None


def _bytes(image: Image, reader: AccessorReader, beside: Companions) -> bytes | None:
    if image.buffer_view is None:
        return read_uri(image.uri or "", beside)
    view = entry(reader.document.buffer_views, image.buffer_view, "buffer view")
    buffer = entry(reader.buffers, view.buffer, "buffer")
    return buffer[view.byte_offset : view.byte_offset + view.byte_length]
