"""The jobs of scans and photographs that a page brings: a face is fitted to them for a look; then it is taken.

Between the two the fitted face lies in the preview's folder, packed as the show file keeps faces.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
from msgspec import structs

from omote.builtin import load_cast
from omote.edit.compute.face_previews import show_photographs, show_scan
from omote.edit.protocol.messages import PhotographPreview, ScanPreview
from omote.edit.store.import_items import ImportedItem
from omote.model.appearance.look_suggestion import wear_hair
from omote.model.fitting.landmarks import SEVEN
from omote.model.fitting.photographs.photograph import Photograph
from omote.server.sandbox.child_task import Tell
from omote.server.sandbox.scan_faces import fit_in_child, fit_photographs_in_child
from omote.server.sandbox.scan_files import read_picture_in_sandbox, read_scan_in_sandbox
from omote.server.workers.job_server import Follow
from omote.showfile.contents import pack_face, unpack_face

FILES = "files"
FACE = "face.omoc"
ORIGIN = "origin.txt"
"""What lies in a preview's folder: what was sent, the fitted face, where it came from."""
SCAN_READ = 5
PHOTOGRAPHS_READ = 20
MADE = 97
"""Parts of a hundred of the whole that are done once a scan is read, photographs are, and the face has its look."""


class FitScan(msgspec.Struct, frozen=True, tag=True):
    """The scan in a preview's folder with its fitted face, by points that people gave in the scan's own frame; shut:
    whether its eyes are, None: look. Made: a `ScanPreview`, encoded."""

    folder: str
    file: str
    token: str
    points: dict[str, tuple[float, float, float]] = {}
    shut: bool | None = None


class SeenPhotograph(msgspec.Struct, frozen=True):
    """A photograph in a preview's folder as the page saw it: its file there, its name on the desk, its size in pixels,
    and landmarks (478 of x, y and depth, in parts of its width, height and width)."""

    file: str
    name: str
    width: int
    height: int
    points: list[tuple[float, float, float]]


class FitPhotographs(msgspec.Struct, frozen=True, tag=True):
    """The photographs in a preview's folder with the face fitted to them. Made: a `PhotographPreview`, encoded."""

    folder: str
    token: str
    photographs: list[SeenPhotograph]


class ShowPhotograph(msgspec.Struct, frozen=True, tag=True):
    """A photograph that a browser does not decode (HEIC), as a JPEG whose longer side is no longer than so many
    pixels."""

    path: str
    longest: int


class TakeScan(msgspec.Struct, frozen=True, tag=True):
    """The face fitted in a preview's folder as an item beside those of a show file, with a hair style and its colour;
    wall: seconds since 1970. Made: `Imported`, encoded."""

    show: str
    folder: str
    label: str
    hair_style: str
    hair: str
    wall: float


def run_fit(wanted: FitScan, follow: Follow, /) -> ScanPreview:
    """Fits a scan and keeps its face in the folder; follow: told of parts of a hundred.

    ValueError with a sentence for what cannot be read, or takes too much.

    wanted: the scan and what was said of it.
    """
    unknown = [name for name in wanted.points if name not in SEVEN]
    if unknown:
        raise ValueError(f"there is no point {unknown[0][:80]!r}; expected some of {', '.join(SEVEN)}.")
    folder = Path(wanted.folder)
    follow(0, 100, "the file is read")
    read = read_scan_in_sandbox(folder / FILES / wanted.file)
    cast = load_cast()
    scan_face = fit_in_child(
        cast, read.scan, name=Path(wanted.file).stem, landmarks=wanted.points, shut=wanted.shut,
        follow=_between(SCAN_READ, MADE, follow),
    )  # fmt: skip
    follow(MADE, 100, "it is shown")
    preview = structs.replace(
        show_scan(cast, read, scan_face, wanted.points), token=wanted.token, file=wanted.file, shut=wanted.shut
    )
    if scan_face.fit is None or scan_face.look is None:
        (folder / FACE).unlink(missing_ok=True)
        return preview
    (folder / FACE).write_bytes(pack_face(scan_face.fit.face, scan_face.look))
    (folder / ORIGIN).write_text(describe_origin(preview), encoding="utf-8")
    return structs.replace(preview, notes=[*preview.notes, *_describe_shapes(len(read.scan.shapes))])


def run_photograph_fit(wanted: FitPhotographs, follow: Follow, /) -> PhotographPreview:
    """Fits photographs and keeps their face in the folder; follow: told of parts of a hundred.

    ValueError with a sentence where that fails.

    wanted: the photographs and their landmarks.
    """
    folder = Path(wanted.folder)
    cast = load_cast()
    photographs = []
    for number, seen in enumerate(wanted.photographs):
        follow(PHOTOGRAPHS_READ * number // len(wanted.photographs), 100, f"photograph {number + 1} is read")
        photographs.append(_read(folder, seen))
    face = fit_photographs_in_child(
        cast, photographs, name="photograph", follow=_between(PHOTOGRAPHS_READ, MADE, follow)
    )
    follow(MADE, 100, "it is shown")
    preview = structs.replace(show_photographs(cast, face), token=wanted.token)
    (folder / FACE).write_bytes(pack_face(face.fit.face, face.look))
    (folder / ORIGIN).write_text(describe_photographs(wanted, preview.seen), encoding="utf-8")
    return preview


def _between(begin: int, end: int, follow: Follow) -> Tell:
    """Follows work that takes a hundred parts from one on to another."""
    return lambda done, what: follow(round(begin + (end - begin) * done), 100, what)


def face_to_take(wanted: TakeScan, /) -> Iterator[tuple[ImportedItem, str]]:
    """The fitted face as an item to import; ValueError where none has been fitted."""
    folder = Path(wanted.folder)
    if not (folder / FACE).exists():
        raise ValueError("no face has been fitted to this scan yet; set the points that are missing and fit again.")
    if wanted.hair_style not in ("", *load_cast().hair):
        raise ValueError(f"there is no hair {wanted.hair_style[:80]!r}; choose one of {', '.join(load_cast().hair)}.")
    face, look = unpack_face((folder / FACE).read_bytes(), wanted.label)
    worn = wear_hair(replace(look, hair=wanted.hair), wanted.hair_style)
    note = (folder / ORIGIN).read_text(encoding="utf-8")
    yield ImportedItem(wanted.label, (face, worn), note=note), f"{wanted.label}, {note}"


def describe_origin(preview: ScanPreview, /) -> str:
    """Where a face comes from, for its revision: the file, its unit, the points that were given, how near it lies."""
    assert preview.figures is not None  # a face was fitted
    count = len(preview.given)
    points = f"{count or 'no'} point{'' if count < 2 else 's'} given"
    near = f"half of the face within {preview.figures.median:.2f} mm, 95 % within {preview.figures.p95:.2f} mm"
    return f"from {preview.file} ({preview.unit}), {points}; {near}"


def describe_photographs(wanted: FitPhotographs, seen: float, /) -> str:
    """Where a face comes from, for its revision: the photographs, and how much of the skin they show (seen, 0 to 1).

    wanted: the job; seen: the share that is shown, 0 to 1.
    """
    count = len(wanted.photographs)
    names = ", ".join(photograph.name for photograph in wanted.photographs)
    return f"from {count} photograph{'' if count == 1 else 's'} ({names}); {seen:.0%} of the skin was seen"


def _describe_shapes(count: int) -> list[str]:
    """That a scan has so many shapes of its own, of which its face takes none."""
    shapes = "one shape" if count == 1 else f"{count} shapes"
    return [f"it brings {shapes} of its own: import it as expressions, too, and all faces wear them"] if count else []


def _read(folder: Path, seen: SeenPhotograph) -> Photograph:
    """A photograph and its landmarks in pixels; ValueError where the page saw another size."""
    try:
        picture = read_picture_in_sandbox(folder / FILES / seen.file)
    except ValueError as error:
        raise ValueError(f"{seen.name}: {str(error).removeprefix(f'{seen.file}: ')}") from error
    height, width = picture.shape[:2]
    if (width, height) != (seen.width, seen.height):
        raise ValueError(
            f"{seen.name} has {width} x {height} pixels, and the page saw {seen.width} x {seen.height}; bring it again"
        )
    return Photograph(np.array(seen.points) * [width, height, width], width, height, picture=picture)
