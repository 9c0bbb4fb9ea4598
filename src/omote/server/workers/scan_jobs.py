"""The jobs of a scan that a page brings: it is read, its head found and fitted for a look; then its face is taken.

Between the two the fitted face lies in the preview's folder, packed as the show file keeps faces.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from omote.builtin import load_cast, load_head_kinds, load_identity_modes, load_mask, load_meshes
from omote.edit.compute.scan_preview import thin_scan
from omote.edit.protocol.messages import ScanDoubt, ScanFigures, ScanPreview
from omote.edit.store.import_items import ImportedItem
from omote.interchange.formats.png import read_png
from omote.interchange.scan_look import suggest_scan_look
from omote.interchange.scans.scan_reader import ScanFile
from omote.interchange.skin_texture import build_canvas
from omote.model.appearance.look_suggestion import wear_hair
from omote.model.cast import Cast, Look
from omote.model.fitting.doubt import PLACE, Doubt, join_doubts
from omote.model.fitting.find_head import HeadPlacement, find_head
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.fit_kinds import fit_kinds
from omote.model.fitting.landmarks import FEWEST_LANDMARKS, SEVEN
from omote.model.fitting.scan import Scan
from omote.model.fitting.shape.head_zones import head_zones
from omote.model.space.similarity import Similarity
from omote.server.sandbox.scan_files import read_scan_in_sandbox
from omote.server.workers.job_server import Follow
from omote.show.wire import le_bytes
from omote.showfile.contents import pack_face, unpack_face
from omote.stage_data.assets import rest_positions

FILES, FACE, ORIGIN = "files", "face.omoc", "origin.txt"
"""What lies in a preview's folder: what was sent, the fitted face, where it came from."""
AROUND = 0.12
"""Metres around the head that are shown of a scan."""
READ, FOUND, FITTED, WORN = 5, 40, 70, 97
"""Parts of a hundred of the whole that are done by then."""


class FitScan(msgspec.Struct, frozen=True, tag=True):
    """The scan in a preview's folder with its fitted face, by points that people gave in the scan's own frame; shut:
    whether its eyes are, None: look. Made: a `ScanPreview`, encoded."""

    folder: str
    file: str
    token: str
    points: dict[str, tuple[float, float, float]] = {}
    shut: bool | None = None


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
    """Fits a scan and keeps its face in the folder; ValueError with a sentence for what cannot be read or fitted."""
    unknown = [name for name in wanted.points if name not in SEVEN]
    if unknown:
        raise ValueError(f"there is no point {unknown[0][:80]!r}; expected some of {', '.join(SEVEN)}.")
    folder = Path(wanted.folder)
    follow(0, 100, "the file is read")
    read = read_scan_in_sandbox(folder / FILES / wanted.file)
    cast = load_cast()
    follow(READ, 100, "the head is sought")
    found = _find(cast, read.scan, wanted)
    fitted, doubted = _fit(cast, read.scan, found, wanted, follow)
    doubts = [ScanDoubt(doubt.kind, str(doubt)) for doubt in doubted]
    if fitted is None:
        (folder / FACE).unlink(missing_ok=True)
        whole = _place_unfound(cast, read.scan, wanted, doubted)
        return structs.replace(_describe_scan(cast, read, whole, whole.similarity, wanted), doubts=doubts)
    follow(FITTED, 100, "its colours")
    canvas = build_canvas(read_png(load_mask()), load_meshes()[0], cast.space.points)
    look, notes = suggest_scan_look(cast, canvas, fitted, read.scan)
    frame = describe_frame(found.unit, fitted.placement)
    (folder / FACE).write_bytes(pack_face(fitted.face, look))
    (folder / ORIGIN).write_text(describe_origin(wanted, frame, figures_of(cast, fitted)), encoding="utf-8")
    follow(WORN, 100, "it is shown")
    preview = _describe_scan(cast, read, found, fitted.placement, wanted)
    notes = [*read.notes, *notes, *_describe_shapes(read.scan)]
    return _add_face(cast, structs.replace(preview, doubts=doubts, notes=notes), fitted, look)


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


def figures_of(cast: Cast, fitted: Fit, /) -> ScanFigures:
    """How far a fitted face is from what the scan shows of it."""
    face = fitted.residual[head_zones(cast.space).face]
    seen = face[np.isfinite(face)]
    if not seen.size:
        return ScanFigures(0.0, 0.0, 0.0)
    return ScanFigures(float(np.median(seen)), float(np.percentile(seen, 95)), len(seen) / len(face))


def _describe_shapes(scan: Scan, /) -> list[str]:
    """That a scan has shapes of its own, of which its face takes none."""
    count = len(scan.shapes)
    shapes = "one shape" if count == 1 else f"{count} shapes"
    return [f"it brings {shapes} of its own: import it as expressions, too, and all faces wear them"] if count else []


def describe_origin(wanted: FitScan, frame: str, figures: ScanFigures, /) -> str:
    """Where a face comes from, for its revision: the file, its unit, the points that were given, how near it lies."""
    count = len(wanted.points)
    points = f"{count or 'no'} point{'' if count < 2 else 's'} given"
    near = f"half of the face within {figures.median:.2f} mm, 95 % within {figures.p95:.2f} mm"
    return f"from {wanted.file} ({frame}), {points}; {near}"


def describe_frame(unit: str, placement: Similarity, /) -> str:
    """The unit and the axes of a scan that was placed, in words."""
    return f"{unit}, {_describe_axis(placement.rotation[1])} up, facing {_describe_axis(placement.rotation[2])}"


def _describe_axis(axis: NDArray[np.float64]) -> str:
    """The axis of a scan nearest to a direction in its frame."""
    at = int(np.abs(axis).argmax())
    return f"{'-' if axis[at] < 0.0 else ''}{'xyz'[at]}"


def _find(cast: Cast, scan: Scan, wanted: FitScan) -> HeadPlacement:
    """Where the head is: by its shape, or by points once these say enough; where no head is, a look at all of it."""
    landmarks = wanted.points if len(wanted.points) >= FEWEST_LANDMARKS else None
    try:
        return find_head(cast.space, load_identity_modes(), scan, landmarks=landmarks)
    except ValueError as error:
        return _place_unfound(cast, scan, wanted, [Doubt(f"{error}.", PLACE)])


def _place_unfound(cast: Cast, scan: Scan, wanted: FitScan, doubts: Sequence[Doubt]) -> HeadPlacement:
    """The whole scan as large as a head, as upright as it is, with no other points than those given."""
    middle = (scan.positions.min(axis=0) + scan.positions.max(axis=0)) / 2
    size = float(np.ptp(cast.space.points[:, 1])) / max(float(np.ptp(scan.positions, axis=0).max()), 1e-9)
    place = Similarity(size, np.eye(3), cast.space.points.mean(axis=0) - size * middle)
    everything = np.ones(len(scan.positions), np.bool_)
    given = {name: np.array(point) for name, point in wanted.points.items()}
    return HeadPlacement(place, everything, np.inf, "an unknown unit", given, tuple(doubts))


def _fit(
    cast: Cast, scan: Scan, found: HeadPlacement, wanted: FitScan, follow: Follow
) -> tuple[Fit | None, Sequence[Doubt]]:  # fmt: skip
    """The fit of a scan whose head was found, None where none can be made, and all doubts."""

    def tell(done: float, what: str) -> None:
        follow(round(FOUND + (FITTED - FOUND) * done), 100, what)

    if not np.isfinite(found.residual):
        return None, found.doubts
    try:
        fitted = fit_kinds(
            cast.space, load_head_kinds(), scan, found, landmarks=wanted.points,
            name=Path(wanted.file).stem, shut=wanted.shut, follow=tell,
        )  # fmt: skip
    except ValueError as error:
        return None, found.doubts or [Doubt(f"No face could be fitted: {error}.", PLACE)]
    return fitted, join_doubts(found.doubts, fitted.doubts)


def _describe_scan(
    cast: Cast, read: ScanFile, found: HeadPlacement, placement: Similarity, wanted: FitScan
) -> ScanPreview:  # fmt: skip
    corners = np.stack([cast.space.points.min(axis=0) - AROUND, cast.space.points.max(axis=0) + AROUND])
    thin = thin_scan(read.scan, placement, None if found.doubts else corners)  # what is not sure may be elsewhere
    return ScanPreview(
        token=wanted.token,
        file=wanted.file,
        placement=[float(placement.scale), *placement.rotation.reshape(-1).tolist(), *placement.shift.tolist()],
        unit=describe_frame(found.unit, placement),
        doubts=[],
        notes=list(read.notes),
        given={name: list(point) for name, point in wanted.points.items()},
        found={name: np.asarray(point).tolist() for name, point in found.landmarks.items()},
        positions=le_bytes(thin.positions, "<f4"),
        triangles=le_bytes(thin.triangles, "<u4"),
        colours=b"" if thin.colours is None else le_bytes(thin.colours, "u1"),
        shut=wanted.shut,
    )


def _add_face(cast: Cast, preview: ScanPreview, fitted: Fit, look: Look) -> ScanPreview:
    return structs.replace(
        preview,
        face=le_bytes(rest_positions(cast, fitted.face), "<f4"),
        residual=le_bytes(fitted.residual, "<f4"),
        figures=figures_of(cast, fitted),
        hair_style=look.hair_style,
        hair=look.hair,
    )
