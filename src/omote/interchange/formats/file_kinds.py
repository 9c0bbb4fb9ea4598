"""What files of strangers can hold, by the suffix of their names: the one list that every door reads.

`omote face`, `omote file import`, `omote play-take`, uploads of pages and the pages themselves (`FILE_CONTENTS` in
`web/src/link/constants.ts`) take their suffixes from here, so that what one of them reads is known to all others.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePath
from typing import Literal

Content = Literal["head", "shape", "document", "take", "capture", "photograph", "companion"]
"""head: a head at rest, of any topology; shape: a head whose points keep their order, with or without morph targets, so
that it can be an expression; document: an expression of ours; take: a recording of a tracker as a table; capture: one
as packets; photograph: a picture of a person; companion: what lies beside a head."""

FILE_CONTENTS: Mapping[str, tuple[Content, ...]] = {
    ".ply": ("head", "shape"),
    ".obj": ("shape", "head"),
    ".stl": ("head",),
    **dict.fromkeys((".glb", ".gltf", ".vrm"), ("shape", "head")),
    **dict.fromkeys((".xyz", ".pts", ".txt", ".asc"), ("head",)),
    ".csv": ("head", "take"),
    ".json": ("document", "capture"),
    **dict.fromkeys((".pcap", ".pcapng", ".cap"), ("capture",)),
    **dict.fromkeys((".jpg", ".jpeg", ".png", ".heic", ".heif", ".webp", ".avif"), ("photograph", "companion")),
    **dict.fromkeys((".bmp", ".tif", ".tiff", ".gif"), ("photograph", "companion")),
    **dict.fromkeys((".mtl", ".bin", ".tga"), ("companion",)),
}
"""What a file may be, by its suffix; the first is what a page takes it for where nothing else says so."""
_FITTED = "a face is made of it: omote face {name} -o show.omote, or drop it on the editor"
_UNREAD: Mapping[str, str] = {
    ".omote": "`omote show` opens it; `omote file import` takes all of it into another show file, which no show plays",
    ".blend": "in Blender, File > Export > glTF 2.0 (.glb) or Stanford PLY (.ply)",
    **dict.fromkeys((".bvh", ".vrma"), "it is the motion of a body: `omote clip import` takes it into a show file"),
    ".fbx": "export it as .glb or .obj, or open it in Blender and export it from there",
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), "export it as .glb or .obj; scanning apps offer that too"),
    **dict.fromkeys((".zip", ".rar", ".7z", ".gz"), "unpack it and give the .obj, .ply or .glb that is in it"),
    **dict.fromkeys((".las", ".laz", ".e57", ".pcd"), "export the cloud as .ply or .xyz, in CloudCompare for example"),
    **dict.fromkeys(
        (".dae", ".3ds", ".max", ".ma", ".mb", ".abc", ".ztl", ".3mf", ".x3d"), "export it as .glb or .obj"
    ),
}
"""What to do with files that nothing here reads."""
_READ: Mapping[Content, str] = {
    "photograph": (
        "a photograph has no shape; drop it on the editor, which makes faces of photographs too, or give a scan"
    ),
    "shape": "take it in with omote file import show.omote {name}, --as face for a face, or drop it on the editor",
    "head": "it has no shapes that could be expressions, and " + _FITTED,
    "document": "it is a document of expressions or a recording: omote file import show.omote {name} takes expressions "
    "in, omote play-take {name} plays a recording",
    "capture": "it is a recording of a tracker: omote play-take {name} plays it into a running show",
    "companion": "it belongs to a head and is read where that is given: the .obj or .gltf that names it",
}
"""What to do with files that another door reads, by what they hold."""


def suffixes_of(*contents: Content) -> tuple[str, ...]:
    """The suffixes of files that can hold one of these."""
    return tuple(suffix for suffix, held in FILE_CONTENTS.items() if any(content in held for content in contents))


def may_be(name: str, *contents: Content) -> bool:
    """Whether a file of this name can hold one of these.

    name: the file's; contents: what it may hold.
    """
    return any(content in FILE_CONTENTS.get(suffix_of(name), ()) for content in contents)


def suffix_of(name: str, /) -> str:
    """The suffix of a file's name, in small letters."""
    return PurePath(name).suffix.lower()


def advise(name: str, *wanted: Content) -> str:
    """What to do with a file that a door does not take, as a clause.

    name: the file's, or its suffix; wanted: what the door takes.
    """
    suffix = suffix_of(name) or name.lower()
    if suffix in _UNREAD:
        return _UNREAD[suffix]
    held = next((content for content in FILE_CONTENTS.get(suffix, ()) if content in _READ), None)
    if held is not None and held not in wanted:
        return _READ[held].format(name=name if suffix_of(name) else f"FILE{suffix}")
    return f"export it as one of {', '.join(suffixes_of(*wanted))}"
