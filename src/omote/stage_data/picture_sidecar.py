"""The sidecar of a picture: a JSON document beside it with every parameter, so that it can be made again.

It also says whether a picture that is there already is the one that is asked for.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any, Literal

import msgspec

from omote.stage_data.picture_grid import PictureGrid, Setting
from omote.stage_data.picture_request import Request

LARGEST_SIDECAR = 16_000_000


class Sidecar(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Everything that a picture was made from.

    request: what was asked for, as it is typed; pictures: the table that was drawn, with every weight and angle
    (radians); cast and pages: digests of the faces and of what draws them; picture: the hash of the file itself.
    """

    format: Literal["omote-picture"] = "omote-picture"
    version: Literal[1] = 1
    omote: str
    request: Request
    cast: str
    pages: str
    setting: dict[str, Any]
    pictures: dict[str, Any]
    picture: str = ""


def sidecar_path(picture: Path) -> Path:
    """Where the sidecar of a picture lies."""
    return picture.with_name(f"{picture.name}.json")


def describe(request: Request, sheet: PictureGrid, setting: Setting, made_by: tuple[str, str, str]) -> Sidecar:
    """The sidecar of a picture that is not drawn yet; made_by: Omote's version, the digests of cast and pages."""
    version, cast, pages = made_by
    drawn, chosen = msgspec.to_builtins(sheet), msgspec.to_builtins(setting)
    return Sidecar(omote=version, request=request, cast=cast, pages=pages, setting=chosen, pictures=drawn)


def encode_sidecar(sidecar: Sidecar, picture: bytes) -> bytes:
    """The document for a picture's bytes, indented for people."""
    whole = msgspec.structs.replace(sidecar, picture=hashlib.sha256(picture).hexdigest())
    return msgspec.json.format(msgspec.json.encode(whole), indent=2) + b"\n"


def read_sidecar(path: Path) -> Sidecar:
    """Reads a sidecar; OSError where there is none, ValueError with a message where it is none of ours."""
    if path.stat().st_size > LARGEST_SIDECAR:
        raise ValueError(f"{path} is no sidecar of a picture: it is larger than {LARGEST_SIDECAR / 1e6:.0f} MB")
    try:
        return msgspec.json.decode(path.read_bytes(), type=Sidecar)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ValueError(
            f"{path} is no sidecar of a picture ({error}); give the .json that lies beside one, as smile.png.json"
        ) from None


def is_drawn(picture: Path, wanted: Sidecar) -> bool:
    """Whether a whole picture of exactly these parameters lies there: its sidecar says so, not its name."""
    try:
        found, data = read_sidecar(sidecar_path(picture)), picture.read_bytes()
    except (OSError, ValueError):
        return False
    return _matter(found) == _matter(wanted) and found.picture == hashlib.sha256(data).hexdigest()


def _matter(sidecar: Sidecar) -> tuple[object, ...]:
    """What the bytes of a picture follow from, as JSON knows it."""
    parts = (sidecar.cast, sidecar.pages, sidecar.setting, sidecar.pictures)
    return tuple(msgspec.json.decode(msgspec.json.encode(part)) for part in parts)
