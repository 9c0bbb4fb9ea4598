"""The sidecar of a picture: a JSON document beside it with every parameter, so that it can be made again.

It also says whether a picture that is there already is the one that is asked for, and whether Omote drew it at all.
Its `request` alone says what is drawn again; the rest records what was drawn, under a checksum.
"""

from __future__ import annotations

import hashlib
import itertools
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import msgspec

from omote.interchange.formats.atomic_file import write_whole
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.file_names import KINDS
from omote.stage_data.picture_request import Request
from omote.stage_data.picture_setting import Clipped, Setting

if TYPE_CHECKING:
    from omote.stage_data.picture_grid import PictureGrid

LARGEST_SIDECAR = 16_000_000


class Sidecar(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Everything that a picture was made from.

    request: what was asked for, as it is typed (a show file by its path from the sidecar's folder); pictures: the table
    that was drawn, with every weight and angle (radians); cast and pages: digests of the faces and of what draws them;
    checksum: of all these but the request; picture: the hash of the file itself; clipped: what of it was cut off to
    match its luminance and contrast, None where neither was asked for.
    """

    format: Literal["omote-picture"] = "omote-picture"
    version: Literal[1] = 1
    omote: str
    request: Request
    cast: str
    pages: str
    setting: dict[str, Any]
    pictures: dict[str, Any]
    checksum: str
    picture: str = ""
    clipped: Clipped | None = None

    @property
    def record(self) -> bytes:
        """What the bytes of a picture follow from, as JSON in one order."""
        parts = {"cast": self.cast, "pages": self.pages, "setting": self.setting, "pictures": self.pictures}
        return msgspec.json.encode(msgspec.json.decode(msgspec.json.encode(parts)), order="sorted")


PictureState = Literal["missing", "foreign", "former", "drawn"]


def sidecar_path(picture: Path) -> Path:
    """Where the sidecar of a picture lies."""
    return picture.with_name(f"{picture.name}.json")


def find_sidecar(path: Path) -> Path:
    """The sidecar that a person means who names it, or the picture that it is of; FileNotFoundError for the latter
    without one."""
    beside = sidecar_path(path)
    if path.suffix.lower() not in KINDS:
        return path
    if not beside.is_file():
        raise FileNotFoundError(f"no {beside.name} lies beside {path}; only from that a picture is drawn again")
    return beside


def describe(request: Request, sheet: PictureGrid, setting: Setting, made_by: tuple[str, str, str]) -> Sidecar:
    """The sidecar of a picture that is not drawn yet; made_by: Omote's version, the digests of cast and pages.

    request: as it was typed; sheet: the pictures in rows and columns; setting: size, background, quality.
    """
    version, cast, pages = made_by
    drawn = msgspec.to_builtins(sheet)
    chosen = msgspec.to_builtins(setting)
    open_sidecar = Sidecar(
        omote=version, request=request, cast=cast, pages=pages, setting=chosen, pictures=drawn, checksum=""
    )
    return msgspec.structs.replace(open_sidecar, checksum=checksum_of(open_sidecar))


def checksum_of(sidecar: Sidecar) -> str:
    """The checksum of what a sidecar records, hexadecimal."""
    return hashlib.blake2b(sidecar.record, digest_size=12).hexdigest()


def move_request(request: Request, old: Path, new: Path) -> Request:
    """The request with its show file, named from the folder `old`, named from the folder `new` instead."""
    if not request.show or Path(request.show).is_absolute():
        return request
    path = os.path.relpath((old / request.show).absolute(), new.absolute())
    return msgspec.structs.replace(request, show=Path(path).as_posix())


def encode_sidecar(sidecar: Sidecar, picture: bytes) -> bytes:
    """The document for a picture's bytes, indented for people.

    sidecar: without the picture's hash; picture: the bytes of its file.
    """
    whole = msgspec.structs.replace(sidecar, picture=hash_picture(picture))
    return msgspec.json.format(msgspec.json.encode(whole), indent=2) + b"\n"


def read_sidecar(path: Path) -> Sidecar:
    """Reads a sidecar; OSError where there is none, ValueError with a message where it is none of ours."""
    if path.stat().st_size > LARGEST_SIDECAR:
        raise ValueError(f"{path} is no sidecar of a picture: it is larger than {LARGEST_SIDECAR / 1e6:.0f} MB")
    try:
        return msgspec.json.decode(path.read_bytes(), type=Sidecar)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ValueError(
            f"{path} is no sidecar of a picture ({explain_error(error)}); give the .json that lies beside one, as "
            "smile.png.json"
        ) from None


def read_record(path: Path) -> Sidecar:
    """Reads a sidecar that a picture is drawn again from; errors as `read_sidecar`.

    ValueError too where what it records was edited: only its request counts, and nobody shall believe otherwise.
    """
    sidecar = read_sidecar(path)
    if sidecar.checksum != checksum_of(sidecar):
        raise ValueError(
            f"{path}: cast, pages, setting or pictures were edited, and these only record what was drawn; undo that, "
            "and change the words under request instead: they alone say what is drawn"
        )
    return sidecar


def is_drawn(picture: Path, wanted: Sidecar) -> bool:
    """Whether a whole picture of exactly these parameters lies there: its sidecar says so, not its name.

    picture: the path of its file; wanted: what its sidecar has to record.
    """
    return picture_state(picture, wanted) == "drawn"


def picture_state(picture: Path, wanted: Sidecar) -> PictureState:
    """What lies where a picture is to be.

    "drawn": this very picture; "former": one that Omote drew from other parameters, and nobody changed since;
    "foreign": any other file with something in it; "missing": none. OSError where it cannot be read.

    wanted: what its sidecar has to record.
    """
    if not picture.exists() or (picture.is_file() and picture.stat().st_size == 0):
        return "missing"
    try:
        sidecar = read_sidecar(sidecar_path(picture))
    except (OSError, ValueError):
        return "foreign"
    if sidecar.picture != hash_picture(picture.read_bytes()):
        return "foreign"
    return "drawn" if sidecar.record == wanted.record else "former"


def keep_former(picture: Path, wanted: Sidecar) -> Path | None:
    """Copies the sidecar that another picture's takes the place of, so that the one before can be drawn again.

    `smile.png.json` is kept as `smile.before-1.png.json`; gives where, None where nothing would be lost. OSError where
    it cannot be written.

    wanted: the sidecar that takes its place.
    """
    try:
        sidecar = read_sidecar(sidecar_path(picture))
    except (OSError, ValueError):
        return None
    if sidecar.record == wanted.record:
        return None
    data = sidecar_path(picture).read_bytes()
    for number in itertools.count(1):
        former = picture.with_name(f"{picture.stem}.before-{number}{picture.suffix}")
        kept = sidecar_path(former)
        if kept.is_file() and kept.read_bytes() == data:
            return kept
        if not kept.exists() and not former.exists():
            break
    write_whole(kept, data)
    return kept


def hash_picture(data: bytes) -> str:
    """The hash of a picture's file, as its sidecar holds it."""
    return hashlib.sha256(data).hexdigest()


def explain_difference(former: Sidecar, wanted: Sidecar) -> str:
    """Why two sidecars do not describe one picture, as a clause: "with another cast".

    former: the sidecar that lies there; wanted: the one that was expected.
    """
    if former.cast != wanted.cast:
        return "with another cast than this one: its faces may differ"
    if former.record == wanted.record:
        return "with another browser or graphics driver"
    if former.pages != wanted.pages:
        return "by other pages than these: the look may differ"
    return "from other parameters"
