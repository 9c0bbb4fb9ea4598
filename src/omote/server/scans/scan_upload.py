"""Receives what a page sends: a scan and what lies beside it, or photographs and the landmarks found in them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec
from aiohttp import BodyPartReader, MultipartReader, web

from omote.interchange.formats.file_kinds import advise, may_be, suffixes_of
from omote.interchange.scans.scan_parts import LARGEST
from omote.model.fitting.photographs.landmark_table import LANDMARKS
from omote.server.workers.scan_jobs import SeenPhotograph

MOST_PHOTOGRAPHS = 8
LARGEST_PHOTOGRAPH = 16 * 2**20
"""Bytes of one."""
SMALLEST_SIDE = 64
LARGEST_SIDE = 4096
"""Pixels; pages make photographs smaller before they send them."""
BESIDE = 0.5
"""Parts of a picture that a landmark may lie outside it: of a face that is cut off."""
SUFFIXES = (".jpg", ".jpeg", ".png")
"""Of photographs as pages save them anew."""
POINTS_FILE = "landmarks.json"
LARGEST_POINTS = 2**20
"""Bytes of the landmarks of all."""
POINTS_CHUNK = 2**16
_decode: msgspec.json.Decoder[list[SeenPhotograph]] = msgspec.json.Decoder(list[SeenPhotograph])
MOST_FILES = 40
CHUNK = 2**18
"""Bytes that are read at once."""


def read_photographs(data: bytes, sizes: Mapping[str, int], /) -> list[SeenPhotograph]:
    """The photographs that a page describes (JSON); sizes: bytes of each file that came, by its name.

    ValueError with a sentence where they are none or too many, too small or too large, where one is named twice or did
    not come, and where landmarks are missing, not finite or far outside their picture.

    data: JSON; sizes: bytes by file name.
    """
    try:
        photographs = _decode.decode(data)
    except msgspec.DecodeError as error:
        raise ValueError(f"the landmarks of these photographs cannot be read ({error}); bring them again.") from error
    if not 1 <= len(photographs) <= MOST_PHOTOGRAPHS:
        raise ValueError(
            f"{len(photographs)} photographs with a face came; expected 1 to {MOST_PHOTOGRAPHS} of one person."
        )
    if len({photograph.file for photograph in photographs}) < len(photographs):
        raise ValueError("one photograph came twice; bring each once.")
    for photograph in photographs:
        _refuse_file(photograph, sizes)
        _refuse_points(photograph)
    return [msgspec.structs.replace(photograph, name=_plain_name(photograph.name)) for photograph in photographs]


async def receive_points(request: web.Request, /) -> bytes:
    """The body of a request with landmarks alone; ValueError where it is too large."""
    data = bytearray()
    async for chunk in request.content.iter_chunked(POINTS_CHUNK):  # more than a body of another request may have
        data += chunk
        if len(data) > LARGEST_POINTS:
            raise ValueError(f"the landmarks are too large: {LARGEST_POINTS >> 10} kB are read at most.")
    return bytes(data)


def _refuse_file(seen: SeenPhotograph, sizes: Mapping[str, int]) -> None:
    name = _plain_name(seen.name)
    if seen.file not in sizes or Path(seen.file).suffix.lower() not in SUFFIXES:
        raise ValueError(f"{name!r} did not come as JPEG or PNG; bring it again.")
    if sizes[seen.file] > LARGEST_PHOTOGRAPH:
        raise ValueError(f"{name!r} is too large: {LARGEST_PHOTOGRAPH >> 20} MB are read at most; save a smaller one.")
    if not (SMALLEST_SIDE <= seen.width <= LARGEST_SIDE and SMALLEST_SIDE <= seen.height <= LARGEST_SIDE):
        raise ValueError(
            f"{name!r} has {seen.width} x {seen.height} pixels; expected {SMALLEST_SIDE} to {LARGEST_SIDE} a side."
        )


def _refuse_points(seen: SeenPhotograph) -> None:
    name = _plain_name(seen.name)
    if len(seen.points) != LANDMARKS:
        raise ValueError(f"{name!r} came with {len(seen.points)} landmarks; expected {LANDMARKS}.")
    if not all(math.isfinite(part) for point in seen.points for part in point):
        raise ValueError(f"landmarks of {name!r} are no finite numbers; look for them again.")
    if not all(-BESIDE <= part <= 1.0 + BESIDE for point in seen.points for part in point[:2]):
        raise ValueError(f"landmarks of {name!r} lie outside the picture; put them where they belong.")


def _plain_name(name: str) -> str:
    """A name for sentences and notes."""
    return "".join(letter for letter in name if letter.isprintable())[-80:] or "a photograph"


def clean_name(file: str, /) -> str:
    """The name under which a file is kept: printable, no folder, not hidden."""
    return "".join(letter for letter in Path(file.replace("\\", "/")).name if letter.isprintable())[-80:].lstrip("-.")


def choose_scan(names: Sequence[str], /) -> str:
    """The scan among the names of files that came together; ValueError with a sentence for none, and for several."""
    strange = [name for name in names if not may_be(name, "head", "companion")]
    scans = [name for name in names if may_be(name, "head")]
    if strange:
        raise ValueError(f"{strange[0]!r} is no scan that is read here; {advise(strange[0], 'head')}.")
    if not scans:
        raise ValueError(
            f"{', '.join(names) or 'nothing'} came without a scan; bring the scan ({', '.join(suffixes_of('head'))}) "
            "and what lies beside it together."
        )
    if len(scans) > 1:
        raise ValueError(f"{scans[0]!r} and {scans[1]!r} are two scans; bring one at a time.")
    return scans[0]


async def receive_files(request: web.Request, folder: Path, /, *, most: int | None = None) -> None:
    """Writes the files of a form into a folder; ValueError with a sentence where they are too large or too many.

    most: bytes of all of them, None: as many as of a scan.

    request: with a form; folder: where the files go; most: bytes.
    """
    room = most = LARGEST if most is None else most
    try:
        form = await request.multipart()
        for _ in range(MOST_FILES + 1):
            part = await form.next()
            if part is None:
                return
            if isinstance(part, MultipartReader) or not clean_name(part.filename or ""):
                raise ValueError("what came holds something that is no file; bring the files anew.")
            room = await _write(part, folder / clean_name(part.filename or ""), room, most)
    except (AssertionError, ValueError) as error:
        raise error if str(error).endswith(".") else ValueError("what came is no form with files.") from error
    raise ValueError(f"more than {MOST_FILES} files came; bring the scan and its own pictures alone.")


async def _write(part: BodyPartReader, path: Path, room: int, most: int) -> int:
    """Writes one file; returns for how many bytes more there is room."""
    with path.open("wb") as file:
        while chunk := await part.read_chunk(CHUNK):
            room -= len(chunk)
            if room < 0:
                raise ValueError(f"{path.name} is too large: {most >> 20} MB are read at most; export a smaller one.")
            file.write(chunk)
    return room
