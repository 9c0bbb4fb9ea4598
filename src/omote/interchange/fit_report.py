"""A report of how far faces are from their scans: a table (CSV), and a sheet of three views each, drawn in software."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from anyascii import anyascii
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from omote.arrays import Picture, Values

VIEWS = (-40.0, 0.0, 40.0)
"""Degrees that the head is turned to its left."""
TALL = 300
WIDE = 240
BAND = 28
"""Pixels of a view, and of the line of text above a face's views."""
FARTHEST = 2.0
"""Millimetres that the hottest colour stands for."""
KEY = (
    f"blue: it lies on its scan; red: {FARTHEST:g} mm off, or more; grey: the scan shows nothing there, it is made up",
    "doubtful: look at it, it is stored only with --accept; failed: there is no face; scans.csv says why",
)
"""What colours and states mean, above a sheet."""
_DARK = (16, 16, 16)
_LIGHT = (230, 230, 230)
_STOPS = np.array([[70, 110, 170], [120, 180, 150], [230, 200, 90], [210, 60, 40]], np.float64)
_UNSEEN = np.array([150.0, 150.0, 150.0])
_BACK = 32


@dataclass(frozen=True, eq=False)
class SheetRow:
    """A face of a sheet: positions (V, 3) metres, residual (V,) millimetres, nan: unseen; neither of a failed one."""

    label: str
    state: str
    positions: NDArray[np.floating] | None = None
    residual: Values | None = None


def describe_distances(residual: Values, /) -> tuple[str, str]:
    """Within how many millimetres half of what was seen lies, and 95 % of it; empty where nothing was."""
    seen = residual[np.isfinite(residual)]
    if not len(seen):
        return "", ""
    middle, most = np.percentile(seen, [50, 95])
    return f"{middle:.2f}", f"{most:.2f}"


def table_of(rows: Sequence[Mapping[str, object]], /) -> bytes:
    """Rows as CSV with a line of names; a cell that a spreadsheet would run as a formula is quoted as text."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(rows[0].keys() if rows else [])
    for row in rows:
        cells = [str(value) for value in row.values()]
        writer.writerow([f"'{cell}" if cell[:1] in ("=", "+", "-", "@", "\t") else cell for cell in cells])
    return text.getvalue().encode()


def heat_colours(residual: Values, /) -> Values:
    """Colours (n, 3), 0 to 255: blue where a face lies on its scan, red from 2 mm on, grey where nothing was seen."""
    share = np.clip(np.nan_to_num(residual) / FARTHEST, 0.0, 1.0) * (len(_STOPS) - 1)
    below = np.minimum(share.astype(int), len(_STOPS) - 2)
    mixed = _STOPS[below] + (share - below)[:, None] * (_STOPS[below + 1] - _STOPS[below])
    return np.where(np.isfinite(residual)[:, None], mixed, _UNSEEN)


def contact_sheet(triangles: NDArray[np.integer], faces: Sequence[SheetRow], /) -> Picture:
    """A picture (height, width, 3): what its colours mean, then a row for each face: its name and three views, coloured
    by the distance; of a failed one its name alone.

    triangles (F, 3).

    triangles (F, 3): of all faces; faces: a row each.
    """
    rows = [_write(line) for line in KEY]
    for face in faces:
        if face.positions is None or face.residual is None:
            rows.append(_write(f"{face.label[:40]}   {face.state}"))
            continue
        points = np.asarray(face.positions, np.float64)
        colours = heat_colours(face.residual)
        middle = describe_distances(face.residual)[0]
        near = f"half of it within {middle} mm" if middle else "unseen"
        views = [draw_view(points, triangles, colours, turn) for turn in VIEWS]
        rows += [_write(f"{face.label[:40]}   {face.state}   {near}"), np.concatenate(views, axis=1)]
    sheet: Picture = np.concatenate(rows, axis=0)
    return sheet


def _write(text: str) -> Picture:
    """A line of text, as wide as the views, in letters that Pillow's own font has."""
    band = Image.new("RGB", (WIDE * len(VIEWS), BAND), _DARK)
    ImageDraw.Draw(band).text((8, 8), anyascii(text), fill=_LIGHT)
    return np.asarray(band)


def draw_view(positions: Values, triangles: NDArray[np.integer], colours: Values, turn: float, /) -> Picture:
    """One view (TALL, WIDE, 3) from the front of a head turned by some degrees, lit from the camera, without depth.

    positions (V, 3): metres; triangles (F, 3): rows of them; colours (V, 3): 0 to 255; turn: degrees to its left.
    """
    angle = np.radians(turn)
    spin = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    points = (positions - (positions.min(axis=0) + positions.max(axis=0)) / 2.0) @ spin.T
    scale = 0.9 * min(
        TALL / max(np.ptp(positions[:, 1]), 1e-9), WIDE / max(np.ptp(positions[:, [0, 2]], axis=0).max(), 1e-9)
    )
    screen = np.stack([WIDE / 2 + scale * points[:, 0], TALL / 2 - scale * points[:, 1]], axis=1)
    corners = points[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = 0.25 + 0.75 * np.clip(across[:, 2] / np.maximum(np.linalg.norm(across, axis=1), 1e-30), 0.0, 1.0)
    shades = np.clip(light[:, None] * colours[triangles].mean(axis=1), 0, 255).astype(np.uint8).tolist()
    image = Image.new("RGB", (WIDE, TALL), (_BACK,) * 3)
    draw = ImageDraw.Draw(image)
    flat = [tuple(corner) for corner in screen.tolist()]
    for row in np.argsort(corners[..., 2].mean(axis=1), kind="stable"):  # the farthest first
        draw.polygon([flat[corner] for corner in triangles[row]], fill=tuple(shades[row]))
    return np.asarray(image)
