"""The surface of a jaw's teeth, gums and palate or floor in the cage of the cast's row of teeth.

The cast has a row of teeth as a strip of 17 columns of four vertices: at the gum and halfway on the outer side, at the
edge, and behind. A vertex of the sheet is a sum of those with weights of sum 1, so that whatever moves the rows moves
the sheet: a face, and each target. Stages draw the same (web/src/face/head/teeth_sheet.ts).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Indices, Points, Values
from omote.interchange.part_textures import ARCH
from omote.interchange.tooth_profiles import BEYOND, JAWS, RIBS, TEETH, ToothRow, outline
from omote.model.cast import Look

COLUMN_ROWS = 4
COLUMNS = 17
ACROSS_FRONT = (-1.0, -0.82, -0.45, 0.0, 0.45, 0.82)
ACROSS_BACK = (-1.0, -0.6, 0.0, 0.6)
"""Places across a front tooth and one further back, -1..1; the last is the next one's first."""
FRONT_TEETH = 2
"""Teeth of a half that show most."""
STEPS = 16 * (COLUMNS - 1)
"""Steps along the cage in which its arch is measured."""
Station = tuple[tuple[int, float, bool], ...]
"""Where a column of the sheet is: its tooth, its place across it (beyond -1 or 1: behind the last), and whether to the
left; two where two teeth meet."""


@dataclass(frozen=True, eq=False)
class TeethSheet:
    """A jaw's surface, whatever face wears it.

    weights (n, 68): what each vertex takes of each row of the cast's teeth; triangles (t, 3): facing outwards; heights
    (n,): 0 at the gum line, 1 at the edge, less than 0 on gum; numbers (n,): the tooth's running number from the right
    end, whose fraction is the place across.
    """

    weights: Values
    triangles: Indices
    heights: Values
    numbers: Values


def cage_columns(points: Points, *, upper: bool) -> Indices | None:
    """The columns (17, 4) of a row of teeth at points (n, 3), from the right end to the left: gum, middle, edge,
    behind; None where it is no such strip.

    Those behind lie nearest to the arch's middle, the others in threes at one angle. upper: whether it is the
    upper one.
    """
    if len(points) != COLUMNS * COLUMN_ROWS:
        return None
    across, up, ahead = points.T
    back = ahead - (ahead.max() - ARCH)
    angle = np.arctan2(across, back)
    outwards = np.argsort(np.hypot(across, back), kind="stable")
    behind, outer = (part[np.argsort(angle[part], kind="stable")] for part in np.split(outwards, [COLUMNS]))
    threes = outer.reshape(COLUMNS, 3)
    order = np.argsort((-1.0 if upper else 1.0) * up[threes], axis=1, kind="stable")
    columns: Indices = np.column_stack([np.take_along_axis(threes, order, axis=1), behind]).astype(np.int32)
    return columns


def cage_weights(columns: Indices, places: Values) -> Values:
    """The weights (n, 68) of places (n, 3) in the cage: column (0..16), steps from edge to gum, steps from outside to
    behind. A spline along the arch (E. Catmull and R. Rom, 1974) of what stands between a column's rows.

    columns (17, 4): of the cage.
    """
    column, up, inward = places.T
    first = np.minimum(column.astype(np.int64), COLUMNS - 2)
    t = column - first
    shares = np.stack([
        t * (-0.5 + t * (1 - 0.5 * t)), 1 + t * t * (1.5 * t - 2.5),
        t * (0.5 + t * (2 - 1.5 * t)), t * t * (0.5 * t - 0.5),
    ])  # fmt: skip
    parts = np.stack([up, -inward, 1.0 - up, inward])
    beside = np.clip(first + np.arange(-1, 3)[:, None], 0, COLUMNS - 1)
    weights = np.zeros((len(places), columns.size))
    which = np.broadcast_to(np.arange(len(places)), (4, 4, len(places)))
    np.add.at(weights, (which, columns[beside].transpose(0, 2, 1)), shares[:, None] * parts)
    return weights


def teeth_sheet(points: Points, *, upper: bool, look: Look) -> TeethSheet | None:
    """The sheet in the cage of a row of teeth; None where it is no such strip.

    points (68, 3): of the generic face, metres; upper: whether it is the upper one; look: whose, by `milk` a baby's and
    by `fur` a carnivore's.
    """
    columns = cage_columns(points, upper=upper)
    if columns is None:
        return None
    rows = JAWS["upper" if upper else "lower"]
    arch = _Arch(columns, points)
    stations = _stations()
    person, milk, carnivore = (
        np.concatenate([_column(at, rows[whose], arch) for at in stations]) for whose in ("person", "milk", "carnivore")
    )
    places = _mixed(_mixed(person, milk, look.milk), carnivore, look.fur)
    marks, milk_marks = (np.concatenate([_marks(at, rows[whose]) for at in stations]) for whose in ("person", "milk"))
    own = cage_weights(columns, places)
    other = cage_weights(columns, places * [-1.0, 1.0, 1.0] + [COLUMNS - 1.0, 0.0, 0.0])
    weights = own + marks[:, 2:] * (other - own)
    heights = _mixed(marks[:, 0], milk_marks[:, 0], look.milk * (1.0 - look.fur))
    return TeethSheet(weights, _grid(len(stations), upper=upper), heights, marks[:, 1])


def _mixed(one: Values, other: Values, share: float) -> Values:
    mixed: Values = one + share * (other - one)
    return mixed


def _stations() -> list[Station]:
    order = [*((tooth, False) for tooth in reversed(range(TEETH))), *((tooth, True) for tooth in range(TEETH))]
    last = TEETH - 1
    stations: list[Station] = [((last, -t, False),) for t in reversed(BEYOND)]
    for at, (tooth, left) in enumerate(order):
        for t in ACROSS_FRONT if tooth < FRONT_TEETH else ACROSS_BACK:
            before = ((order[at - 1][0], 1.0, order[at - 1][1]),) if t == -1.0 and at else ()
            stations.append((*before, (tooth, t, left)))
    return [*stations, *(((last, t, True),) for t in (1.0, *BEYOND))]


def _column(station: Station, row: ToothRow, arch: _Arch) -> Values:
    """The places (RIBS, 3) of one column of the sheet, from outer gum to the middle of palate or floor."""
    at = arch.column_at(_arch_place(station[0], row))
    reach = arch.reach_at(at)
    thick = arch.thick_at(at)
    mean = np.mean([outline(row.teeth[tooth], row, t, reach)[:, :2] for tooth, t, _ in station], axis=0)
    return np.column_stack([np.full(RIBS, at), mean[:, 0] / reach, mean[:, 1] / thick])


def _arch_place(place: tuple[int, float, bool], row: ToothRow) -> float:
    """Millimetres along the arch from its middle, + to the character's left."""
    tooth, t, left = place
    widths = [each.width for each in row.teeth]
    outward = t if left else -t  # `t` runs from the character's right to its left
    return (1.0 if left else -1.0) * (sum(widths[:tooth]) + (0.5 + 0.5 * outward) * widths[tooth])


def _marks(station: Station, row: ToothRow) -> Values:
    """Height, running number and share of the other side of a column, (RIBS, 3)."""
    tooth, t, left = station[0]
    number = (TEETH + tooth if left else TEETH - 1 - tooth) + 0.5 + 0.5 * min(max(t, -1.0), 1.0)
    ribs = np.mean([outline(row.teeth[n], row, place, 16.0) for n, place, _ in station], axis=0)
    return np.column_stack([ribs[:, 2], np.full(RIBS, number), ribs[:, 3]])


class _Arch:
    """How long the arch is to a column, and how high and thick the cage is there."""

    def __init__(self, columns: Indices, points: Points) -> None:
        self._columns = columns
        self._rows = 1000.0 * np.asarray(points, np.float64)
        self._at = np.arange(STEPS + 1) * ((COLUMNS - 1) / STEPS)
        half = self._points(np.column_stack([self._at, np.full(STEPS + 1, 0.5), np.zeros(STEPS + 1)]))
        self._lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(half, axis=0), axis=1))])

    def _points(self, places: Values) -> Values:
        found: Values = cage_weights(self._columns, places) @ self._rows
        return found

    def _between(self, one: tuple[float, float, float], other: tuple[float, float, float]) -> float:
        from_, to = self._points(np.array([one, other]))
        return float(np.linalg.norm(to - from_))

    def column_at(self, millimetres: float) -> float:
        """The column so far along the arch from its middle, + to the character's left."""
        return float(np.interp(self._lengths[STEPS // 2] + millimetres, self._lengths, self._at))

    def reach_at(self, column: float) -> float:
        """Millimetres from the edge to the gum."""
        return self._between((column, 0.0, 0.0), (column, 1.0, 0.0))

    def thick_at(self, column: float) -> float:
        """Millimetres from outside to behind."""
        return self._between((column, 0.5, 0.0), (column, 0.5, 1.0))


def _grid(columns: int, *, upper: bool) -> NDArray[np.int32]:
    """Triangles of a grid of so many columns of RIBS vertices, facing outwards on the face."""
    a = (np.arange(columns - 1)[:, None] * RIBS + np.arange(RIBS - 1)).ravel()
    b, c, d = a + 1, a + RIBS, a + RIBS + 1
    corners = [[a, b, c], [b, d, c]] if upper else [[a, c, b], [b, c, d]]
    return np.concatenate([np.stack(each, axis=1) for each in corners]).astype(np.int32)
