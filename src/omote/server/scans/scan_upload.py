"""Receives the files of a scan: the scan's own, and materials and pictures that lie beside it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from aiohttp import BodyPartReader, MultipartReader, web

from omote.interchange.scans.scan_parts import LARGEST
from omote.interchange.scans.scan_reader import ADVICE, READERS

COMPANIONS = (".mtl", ".bin", ".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tga", ".tif", ".tiff", ".gif")
"""Suffixes of what may lie beside a scan."""
MOST_FILES = 40
CHUNK = 2**18


def clean_name(file: str, /) -> str:
    """The name under which a file is kept: printable, no folder, not hidden."""
    return "".join(each for each in Path(file.replace("\\", "/")).name if each.isprintable())[-80:].lstrip("-.")


def choose_scan(names: Sequence[str], /) -> str:
    """The scan among the names of files that came together; ValueError with a sentence for none, and for several."""
    strange = [name for name in names if Path(name).suffix.lower() not in (*READERS, *COMPANIONS)]
    scans = [name for name in names if Path(name).suffix.lower() in READERS]
    if strange:
        suffix = Path(strange[0]).suffix.lower()
        advice = ADVICE.get(suffix, f"export it as one of {', '.join(READERS)}")
        raise ValueError(f"{strange[0]!r} is no scan that is read here; {advice}.")
    if not scans:
        raise ValueError(
            f"{', '.join(names) or 'nothing'} came without a scan; bring the scan ({', '.join(READERS)}) and what lies "
            "beside it together."
        )
    if len(scans) > 1:
        raise ValueError(f"{scans[0]!r} and {scans[1]!r} are two scans; bring one at a time.")
    return scans[0]


async def receive_files(request: web.Request, folder: Path, /, *, most: int | None = None) -> None:
    """Writes the files of a form into a folder; ValueError with a sentence where they are too large or too many.

    most: bytes of all of them, None: as many as of a scan.
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
