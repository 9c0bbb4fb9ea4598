"""What the extensions that a glTF document needs mean for reading its shape: read, harmless, unknown or refused."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from omote.interchange.formats.gltf_document import Document, Primitive, entry

DRACO = "KHR_draco_mesh_compression"
MESHOPT = (
    "meshopt",
    "unpack it with Node.js, `npx gltfpack -noq -i packed.glb -o plain.glb`, or export it without compression",
)
COMPRESSED: Mapping[str, tuple[str, str]] = {
    DRACO: ("Draco", "export it without compression: in Blender, switch Compression off as you export it"),
    "EXT_meshopt_compression": MESHOPT,
    "KHR_meshopt_compression": MESHOPT,
}
"""What packs the numbers of a shape, by its extension: its name, and how people come to a file without it."""
READ = frozenset(
    {"KHR_mesh_quantization", "KHR_texture_transform", "EXT_texture_webp", "EXT_texture_avif", "VRM", "VRMC_vrm"}
)
_COLOURS = ("KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_lights_", "EXT_texture_", "MSFT_texture_", "VRMC_")
"""Beginnings of the names of extensions that change no shape; what they do to a picture its reader says."""


def judge_extensions(document: Document, note: Callable[[str], None], /) -> None:
    """Raises ValueError where a document needs an extension that packs its numbers; says of others that are not read.

    document: the glTF; note: takes a sentence.
    """
    required = document.extensions_required
    for name in required:
        if name in COMPRESSED:
            raise refusal_of(name)
    unknown = sorted({name for name in required if name not in READ and not name.startswith(_COLOURS)})
    if unknown:
        note(f"it needs {', '.join(unknown)[:200]}, which is not read here: its shape may lack what that adds")


def refusal_of(name: str, /) -> ValueError:
    """The error of a file whose numbers this extension packs."""
    packed, advice = COMPRESSED[name]
    return ValueError(f"the file needs {name}: its numbers are compressed ({packed}), which is not read here; {advice}")


def refuse_packed(document: Document, primitives: Sequence[Primitive], /) -> None:
    """Raises ValueError where primitives lie in the file in a compressed form alone, though it does not say that this
    is needed.

    document: the glTF; primitives: those that are read.
    """
    for primitive in primitives:
        index = primitive.attributes.get("POSITION")
        if index is None or not extends(primitive.extensions, DRACO):
            continue
        if entry(document.accessors, index, "accessor").buffer_view is None:
            raise refusal_of(DRACO)


def extends(extensions: object, name: str, /) -> dict[str, Any] | None:
    """What an extension says of an object, None where it says nothing.

    extensions: of the object, any JSON; name: the extension's.
    """
    found = extensions.get(name) if isinstance(extensions, dict) else None
    return found if isinstance(found, dict) else None
