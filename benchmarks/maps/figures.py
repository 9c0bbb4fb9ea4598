"""Measures one map on one face: every unit, every triple, and how long a compound takes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import thread_time

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.inside.inner import Mouth, Sockets, more
from benchmarks.maps.inside.piercing import balls_of, depth_in_balls, teeth_on, teeth_out
from benchmarks.maps.measures import Creases, closure_errors, find_folds
from benchmarks.maps.source import Source
from benchmarks.maps.sums import SumFigures, Sums
from omote.model.known_names import GENERIC
from omote.model.space.face import Face

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]

LEVELS = (0.2, 0.4, 0.6, 0.8, 1.0)
# Lids that have gone this far on the source have come out of the corner where they were hidden, metres.
HIDDEN = 0.003


@dataclass
class Worst:
    """The largest value met, and the unit in which."""

    value: float = 0.0
    unit: str = ""

    def meet(self, value: float, unit: str) -> None:
        """Keeps the larger of two."""
        if value > self.value:
            self.value = value
            self.unit = unit


@dataclass(frozen=True, eq=False)
class Known:
    """What the source does in a unit: folded triangles (T,), roughness in radians, eyes, teeth, bag and sockets in
    metres, positions (V, 3) at each level."""

    folded: Mask
    rough: float
    eyes: Values
    teeth: float
    bag: Values
    sockets: Values
    levels: tuple[Values, ...]


@dataclass
class Figures:
    """One map on one face. Folds are counts, by unit in folded; lids and lips: mean and along; eyes, teeth, bag and
    sockets: metres more than on the source; rough: all units' roughness over the source's; times: seconds of this
    thread per compound."""

    units: int
    folds: int = 0
    folded: dict[str, int] = field(default_factory=dict)
    sums: SumFigures = field(default_factory=lambda: SumFigures(0))
    lids: tuple[Worst, Worst] = field(default_factory=lambda: (Worst(), Worst()))
    lips: tuple[Worst, Worst] = field(default_factory=lambda: (Worst(), Worst()))
    eyes: Worst = field(default_factory=Worst)
    eyes_most: Worst = field(default_factory=Worst)
    teeth: Worst = field(default_factory=Worst)
    bag: Worst = field(default_factory=Worst)
    sockets: Worst = field(default_factory=Worst)
    rough: float = 0.0
    times: list[float] = field(default_factory=list)


class Comparison:
    """The source's own figures, and the measures of any face against them."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self._creases = Creases.of(source.sheet)
        self._skin = np.unique(source.sheet)
        self._mouth = Mouth(source.space)
        self._sockets = Sockets(source.space)
        self.known = {unit: self._measure_source(unit) for unit in source.moves}
        self._roughest = sum(known.rough for known in self.known.values())
        self._sums = Sums(source)

    def _measure_source(self, unit: str) -> Known:
        source = self.source
        face = self.source.cast.faces[GENERIC]
        rest = source.positions
        now = source.positions + source.moves[unit]
        return Known(
            find_folds(rest, now, source.sheet),
            self._rough(rest, now),
            self._in_eyes(face, rest, now, unit),
            teeth_out(now, source.sheet, teeth_on(source, face, now, unit)),
            self._mouth.out(now),
            self._sockets.out(now),
            tuple(source.wear(unit, level) for level in LEVELS),
        )

    def _rough(self, rest: Values, now: Values) -> float:
        """How much more edges are bent than at rest, root mean square, long edges counting more."""
        bent = self._creases.bent(rest, now)
        return float(np.sqrt(np.average(bent**2, weights=self._creases.lengths(rest))))

    def _in_eyes(self, face: Face, rest: Values, now: Values, unit: str) -> Values:
        gone = np.linalg.norm(self.source.moves[unit][self._skin], axis=1)
        still = np.maximum(1.0 - gone / HIDDEN, 0.0)
        return depth_in_balls(balls_of(self.source, face), now[self._skin], rest[self._skin], still)

    def measure(self, method: str, face: Face, worn: Callable[[str], Values]) -> Figures:
        """The figures of a map by name, prepared for a face, over all units and triples."""
        found = Figures(len(self.known))
        rest = face.positions.astype(np.float64)
        found.sockets.meet(float(self._sockets.out(rest).max(initial=0.0)), "at rest")
        moves = {}
        for unit in self.known:
            begin = thread_time()
            now = worn(unit)
            found.times.append(thread_time() - begin)
            moves[unit] = now - rest
            self._add(found, face, rest, now, unit)
        found.sums = self._sums.measure(method, face, moves)
        return found

    def _add(self, found: Figures, face: Face, rest: Values, now: Values, unit: str) -> None:
        known = self.known[unit]
        sheet = self.source.sheet
        over = int((find_folds(rest, now, sheet) & ~known.folded).sum())
        found.folds += over
        if over:
            found.folded[unit] = over
        for line in self.source.lines:
            means, alongs = found.lips if line.kind == "lips" else found.lids
            for level, there in zip(LEVELS, known.levels, strict=True):
                here = rest + level * (now - rest)
                mean, along = closure_errors(line, (self.source.positions, there), (rest, here))
                means.meet(mean, unit)
                alongs.meet(along, unit)
        eyes = self._in_eyes(face, rest, now, unit)
        found.eyes.meet(float(eyes.max() - known.eyes.max()), unit)
        found.eyes_most.meet(_most(eyes) - _most(known.eyes), unit)
        teeth = teeth_out(now, sheet, teeth_on(self.source, face, now, unit))
        found.teeth.meet(teeth - known.teeth, unit)
        found.bag.meet(more(self._mouth.out(now), known.bag), unit)
        found.sockets.meet(more(self._sockets.out(now), known.sockets), unit)
        found.rough += self._rough(rest, now) / self._roughest


def _most(depths: Values) -> float:
    """The 95th percentile of what pierces at all."""
    piercing = depths[depths > 0]
    return float(np.quantile(piercing, 0.95)) if len(piercing) else 0.0
