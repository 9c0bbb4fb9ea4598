"""Puts together a scan from what files of all formats hold: polygons, colours, texture coordinates, doubled points."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Rows, Values
from omote.geometry.mesh import FARTHEST
from omote.interchange.scans.companions import Companions
from omote.model.fitting.scan import FEWEST_POINTS, Scan

LARGEST = 512 * 2**20
"""Bytes of a file at most."""
MOST_POINTS = 5_000_000
MOST_TRIANGLES = 10_000_000
MOST_NUMBERS = 40_000_000
"""Of one scan; numbers: of all its blendshapes together."""
ROUNDED = 1.0 / 255.0
"""By how much less than nothing a colour may be, of one; what is less is no colour but a direction."""
_MULTIPLIERS = np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9], np.uint64)  # odd, bits mixed


def refuse_many(count: int, what: str, most: int, /) -> None:
    """Raises ValueError where a file holds more than can be read, before memory is allocated.

    count: how many; what: their name in a message; most: how many may be.
    """
    if count > most:
        raise ValueError(f"the file has {count} {what}; expected {most} at most: export it with fewer")


def fan_polygons(counts: Rows, /) -> Rows:
    """Splits polygons into fans of triangles: the places (t, 3) of their corners in a row of all polygons' corners.

    counts (p,): corners of each polygon; those with fewer than three make no triangle.
    """
    starts = np.cumsum(counts) - counts
    pieces = np.maximum(counts - 2, 0)
    refuse_many(int(pieces.sum()), "triangles", MOST_TRIANGLES)
    of = np.repeat(np.arange(len(counts)), pieces)
    step = np.arange(len(of)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    places: Rows = starts[of][:, None] + np.stack([np.zeros_like(step), step + 1, step + 2], axis=1)
    return places


def make_scan(
    points: Values,
    triangles: Rows | None = None,
    colours: NDArray[np.uint8] | None = None,
    texture: NDArray[np.uint8] | None = None,
    texcoords: Values | None = None,
    shapes: Mapping[str, Values] | None = None,
    *,
    beside: Companions | None = None,
) -> Scan:
    """Makes a scan of what a file holds; parameters as of `Scan`.

    Triangles without area by their corners go; so do points that are no numbers (scanners write them for what they did
    not see) or that a shape moves by none, with their triangles; a texture without coordinates, or coordinates without
    a texture, go. ValueError with a sentence for what cannot be a scan.

    points (n, 3), triangles (t, 3), colours (n, 3), texture, texcoords (t, 3, 2), shapes: as of `Scan`; beside: is told
    what goes.
    """
    refuse_many(len(points), "points", MOST_POINTS)
    if triangles is None or not len(triangles):
        kept = _finite(points, {}, beside)
        return _checked(points[kept], None, None if colours is None else colours[kept], None, None, {})
    if not np.issubdtype(triangles.dtype, np.integer) or triangles.min() < 0 or triangles.max() >= len(points):
        raise ValueError(
            f"a triangle names points {triangles.min()} to {triangles.max()}, and the file has {len(points)}; expected "
            f"0 to {len(points) - 1}: export it anew"
        )
    kept = _finite(points, shapes or {}, beside)
    if not kept.all():
        whole = kept[triangles].all(axis=1)
        place = np.cumsum(kept) - 1
        points = points[kept]
        triangles = place[triangles[whole]]
        colours = None if colours is None else colours[kept]
        texcoords = None if texcoords is None else texcoords[whole]
        shapes = {name: moves[kept] for name, moves in (shapes or {}).items()}
    a, b, c = triangles.T
    kept = (a != b) & (b != c) & (c != a)
    if texture is None or texcoords is None:
        texture = texcoords = None
    else:
        texcoords = _wrap(texcoords[kept])
    return _checked(points, triangles[kept] if kept.any() else None, colours, texture, texcoords, shapes or {})


def _finite(points: Values, shapes: Mapping[str, Values], beside: Companions | None) -> NDArray[np.bool_]:
    """Which points (n,) are numbers and are moved by numbers; says how many are not."""
    finite = np.ones(len(points), np.bool_)
    for values in (points, *shapes.values()):
        finite &= np.isfinite(values).all(axis=1)
    lost = len(points) - int(finite.sum())
    if lost and beside is not None:
        first = int(np.flatnonzero(~finite)[0])
        beside.note(
            f"{lost} of its {len(points)} points are no numbers (the first is point {first}): they are left out"
        )
    return finite


def _checked(
    points: Values,
    triangles: Rows | None,
    colours: NDArray[np.uint8] | None,
    texture: NDArray[np.uint8] | None,
    texcoords: Values | None,
    shapes: Mapping[str, Values],
) -> Scan:
    if len(points) < FEWEST_POINTS:
        raise ValueError(
            f"the file has {len(points)} usable points; expected at least {FEWEST_POINTS}: export the whole head"
        )
    far = ~(np.abs(points) <= FARTHEST).all(axis=1)
    if far.any():
        at = int(far.argmax())
        raise ValueError(
            f"point {at} lies at {points[at].tolist()}; expected finite numbers up to {FARTHEST:g}: move the scan to "
            "the origin and export it anew"
        )
    if triangles is None:
        return Scan(points, None, colours)
    return Scan(points, triangles, colours, texture, texcoords, shapes)


def _wrap(texcoords: Values) -> Values:
    """Texture coordinates (t, 3, 2) moved by whole repetitions of the texture into 0 to 1, each triangle as one."""
    finite = np.where(np.isfinite(texcoords), np.clip(texcoords, -FARTHEST, FARTHEST), 0.0)
    middle = finite.mean(axis=1, keepdims=True)
    moved = finite - np.where((middle < 0.0) | (middle > 1.0), np.floor(middle), 0.0)
    wrapped: Values = np.clip(moved, 0.0, 1.0)
    return wrapped


def bytes_of_colours(values: NDArray[np.generic], /) -> NDArray[np.uint8] | None:
    """Colours (n, 3) as uint8, whatever numbers a file has them in: whole ones to 255 or 65535, or parts of one; white
    where a row is no colour.

    None where they are no colours.
    """
    if values.dtype == np.uint8:
        return np.asarray(values, np.uint8)
    numbers = np.asarray(values, np.float64)
    coloured: NDArray[np.bool_] = np.all(np.isfinite(numbers), axis=1)
    if not coloured.any() or numbers[coloured].min() < -ROUNDED:
        return None
    highest = float(numbers[coloured].max())
    parts = highest <= 1.0 or (highest <= 2.0 and (numbers[coloured] != np.rint(numbers[coloured])).any())
    scale = 255.0 if parts else 1.0 if highest <= 255.0 else 1.0 / 257.0
    tones = np.where(coloured[:, None], np.clip(numbers * scale, 0.0, 255.0), 255.0)
    return np.asarray(np.rint(tones), np.uint8)


def find_doubles(*columns: NDArray[np.generic]) -> tuple[Rows, Rows]:
    """The first rows of all that differ, in their order, and for each row which of those it is.

    columns: arrays (n, any) that belong together row by row; equal to the last bit is the same, and -0 is 0.
    """
    parts = [_bits(column) for column in columns]
    keys = np.zeros(len(parts[0]), np.uint64)
    for part in parts:
        for at in range(part.shape[1]):
            keys = (keys ^ part[:, at]) * _MULTIPLIERS[at % 3]
            keys ^= keys >> np.uint64(29)
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    if not all((part[first][inverse] == part).all() for part in parts):  # two that differ have one key
        _, first, inverse = np.unique(np.concatenate(parts, axis=1), axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    return first[order], place[inverse.reshape(-1)]


def _bits(values: NDArray[np.generic]) -> NDArray[np.uint64]:
    plain = np.ascontiguousarray(np.asarray(values, np.float64).reshape(len(values), -1) + 0.0)
    return plain.view(np.uint64)


def weld_scan(scan: Scan, /) -> Scan:
    """Joins points at exactly the same place that move alike, as formats double them along a texture's seams."""
    if scan.triangles is None:
        return scan
    rows, place = find_doubles(scan.positions, *scan.shapes.values())
    triangles = place[scan.triangles]
    shapes = {name: moves[rows] for name, moves in scan.shapes.items()}
    colours = None if scan.colours is None else scan.colours[rows]
    return make_scan(scan.positions[rows], triangles, colours, scan.texture, scan.texcoords, shapes)
