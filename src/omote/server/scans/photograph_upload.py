"""What a page sends of photographs: their files and the landmarks that it found in them, validated here alone."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import msgspec
from aiohttp import web

from omote.model.fitting.photographs.landmark_table import LANDMARKS
from omote.server.workers.photograph_jobs import SeenPhotograph

MOST_PHOTOGRAPHS = 8
LARGEST_PHOTOGRAPH = 16 * 2**20
"""Bytes of one."""
SMALLEST_SIDE, LARGEST_SIDE = 64, 4096
"""Pixels; pages make photographs smaller before they send them."""
BESIDE = 0.5
"""Parts of a picture that a landmark may lie outside it: of a face that is cut off."""
SUFFIXES = (".jpg", ".jpeg", ".png")
POINTS_FILE = "landmarks.json"
LARGEST_POINTS = 2**20
"""Bytes of the landmarks of all."""
CHUNK = 2**16

_decode: msgspec.json.Decoder[list[SeenPhotograph]] = msgspec.json.Decoder(list[SeenPhotograph])


def read_photographs(data: bytes, sizes: Mapping[str, int], /) -> list[SeenPhotograph]:
    """The photographs that a page describes (JSON); sizes: bytes of each file that came, by its name.

    ValueError with a sentence where they are none or too many, too small or too large, where one is named twice or did
    not come, and where landmarks are missing, not finite or far outside their picture.
    """
    try:
        found = _decode.decode(data)
    except msgspec.DecodeError as error:
        raise ValueError(f"the landmarks of these photographs cannot be read ({error}); bring them again.") from error
    if not 1 <= len(found) <= MOST_PHOTOGRAPHS:
        raise ValueError(f"{len(found)} photographs with a face came; expected 1 to {MOST_PHOTOGRAPHS} of one person.")
    if len({each.file for each in found}) < len(found):
        raise ValueError("one photograph came twice; bring each once.")
    for each in found:
        _refuse_file(each, sizes)
        _refuse_points(each)
    return [msgspec.structs.replace(each, name=_plain_name(each.name)) for each in found]


async def receive_points(request: web.Request, /) -> bytes:
    """The body of a request with landmarks alone; ValueError where it is too large."""
    data = bytearray()
    async for chunk in request.content.iter_chunked(CHUNK):  # more than a body of another request may have
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
    return "".join(each for each in name if each.isprintable())[-80:] or "a photograph"
