"""The file formats of pictures, by file name suffix."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

Kind = Literal["image/png", "image/jpeg"]

KINDS: dict[str, Kind] = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg"}


def picture_kind(path: Path) -> Kind:
    """The media type of a file name's suffix; ValueError for an unknown one."""
    kind = KINDS.get(path.suffix.lower())
    if kind is None:
        raise ValueError(f"{path.name!r} is no name of a picture; end it with {' or '.join(KINDS)}")
    return kind
