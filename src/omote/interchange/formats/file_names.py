"""The files that commands write and read, by the suffix of their names; looks into none of them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Literal

from omote.interchange.formats.file_kinds import Content, advise, may_be, suffixes_of

Kind = Literal["image/png", "image/jpeg"]

KINDS: dict[str, Kind] = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg"}
GLB = ".glb"
VRM = ".vrm"
DOCUMENT = ".json"
SHOW = ".omote"
CUES = ".toml"
RUNNING_ORDER = ".csv"
NUMBERS = (".npz", ".csv")
USD = (".usdc", ".usda", ".usdz")
OBJ = ".obj"
EXPORTS = (GLB, VRM, *USD, OBJ, *NUMBERS)
"""What an export writes: heads, and tables of numbers."""
CONTENTS: dict[str, tuple[Content, ...]] = {"expression": ("document", "shape"), "face": ("shape",)}
"""What a file holds that is taken in as a kind."""
IMPORTS = {kind: suffixes_of(*contents) for kind, contents in CONTENTS.items()}
"""The suffixes of files that are taken in, by kind."""
AS = {"expression": "an expression", "face": "a face"}


def picture_kind(path: Path) -> Kind:
    """The media type of a file name's suffix; ValueError for an unknown one."""
    refuse_folder(path)
    kind = KINDS.get(path.suffix.lower())
    if kind is None:
        raise ValueError(f"{path.name!r} is no name of a picture; end it with {' or '.join(KINDS)}")
    return kind


def refuse_folder(path: Path) -> None:
    """Raises IsADirectoryError for a folder, where the name of a file is wanted."""
    if path.name and path.is_dir():
        raise IsADirectoryError(f"{path} is a folder; give the name of a file in it")


def check_export_name(path: Path) -> None:
    """Raises ValueError for a name that says no kind of file that is exported."""
    refuse_folder(path)
    if path.suffix.lower() not in EXPORTS:
        heads = ", ".join((GLB, VRM, *USD, OBJ))
        numbers = " or ".join(NUMBERS)
        raise ValueError(f"{path.name!r} is no name of an exported face; end it with {heads}, or {numbers} for numbers")


def check_document_name(path: Path) -> None:
    """Raises ValueError for a name that does not say that it is a document's."""
    refuse_folder(path)
    if path.suffix.lower() != DOCUMENT:
        raise ValueError(f"{path.name!r} is no name of a document; end it with {DOCUMENT}")


def require_imports(paths: Iterable[Path], kind: str = "expression") -> None:
    """Raises FileNotFoundError, with the one that may be meant, for a file that is not there; ValueError where its
    name does not say that a file can be of a kind ("expression", "face"), with what to do.

    paths: the files; kind: as what they are brought.
    """
    read = IMPORTS[kind]
    for path in paths:
        if path.is_dir():
            raise IsADirectoryError(f"{path} is a folder; name the files in it, as in {path / '*.json'}")
        if not path.is_file():
            near = [candidate for ending in read if (candidate := path.with_name(path.name + ending)).is_file()]
            what = f"did you mean {near[0]}?" if near else "name one that is there"
            raise FileNotFoundError(f"there is no file {path}; {what}")
        if not path.suffix:
            raise ValueError(f"what {path} holds is told by its name; end that with {', '.join(read)}")
        if path.suffix.lower() not in read:
            raise ValueError(f"{path.name} cannot be taken in as {AS[kind]}: {advise_import(path.name, kind)}")


def advise_import(name: str, kind: str) -> str:
    """What to do with a file that cannot be taken in as a kind ("expression", "face"), as a clause.

    name: the file's; kind: as what it is brought.
    """
    if may_be(name, "document") and kind == "face":
        return "it is a document of expressions; leave out --as face, or drop it on the list of expressions"
    return advise(name, *CONTENTS[kind])
