"""Sums of three units on one face: what they fold, cross and pierce, and none of the three does alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.inside.piercing import TEETH, balls_of, teeth_on, teeth_out
from benchmarks.maps.measures import find_folds
from benchmarks.maps.methods import OURS
from benchmarks.maps.source import Source
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.lid_lip_lines import Line
from omote.model.transfer.corrective_regions import find_corrective_regions
from omote.perform.blending.correctives import Eyeballs, correct_combination, measure_allowance

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]
Triple = tuple[str, str, str]

# What two lids or lips may cross more than each alone, metres, before it counts.
SEEN = 0.0004


@dataclass
class SumFigures:
    """All triples on one face: triangles turned over that are not on the source's sum, those that no summand turns over
    alone (by triple in folded); how far lids and lips cross, skin lies in eyeballs, and teeth stand out of the skin,
    more than the summands allow together, metres."""

    triples: int
    folds: int = 0
    new_folds: int = 0
    folded: dict[Triple, int] = field(default_factory=dict)
    crossed: list[float] = field(default_factory=list)
    eyes: list[float] = field(default_factory=list)
    teeth: list[float] = field(default_factory=list)


class Sums:
    """The source's own sums, and the measure of any face against them."""

    def __init__(self, source: Source) -> None:
        self._source = source
        rest = source.positions
        sheet = source.sheet
        self._folded = [
            find_folds(rest, rest + sum(source.moves[unit] for unit in triple), sheet) for triple in source.triples
        ]
        self._skin = np.unique(sheet)

    def measure(self, method: str, face: Face, moves: Mapping[str, Values]) -> SumFigures:
        """The figures of a map on a face: moves (V, 3) by unit."""
        source = self._source
        rest = face.positions.astype(np.float64)
        add = (
            self._corrected_sums(face, moves) if method == OURS else lambda triple: rest + sum(moves[u] for u in triple)
        )
        alone = {unit: find_folds(rest, rest + move, source.sheet) for unit, move in moves.items()}
        crossed = {unit: self.find_crossed(rest, rest + move) for unit, move in moves.items()}
        deep = {unit: self.measure_deep(face, rest, rest + move) for unit, move in moves.items()}
        teeth_in_sums = self._teeth_in_sums(face, rest, moves)
        found = SumFigures(len(source.triples))
        for triple, folded in zip(source.triples, self._folded, strict=True):
            now = add(triple)
            over = find_folds(rest, now, source.sheet)
            found.folds += int((over & ~folded).sum())
            new = int((over & ~np.any([alone[unit] for unit in triple], axis=0)).sum())
            found.new_folds += new
            if new:
                found.folded[triple] = new
            found.crossed.append(float((self.find_crossed(rest, now) - sum(crossed[unit] for unit in triple)).max()))
            found.teeth.append(teeth_in_sums(triple, now))
            found.eyes.append(float((self.measure_deep(face, rest, now) - sum(deep[unit] for unit in triple)).max()))
        return found

    def _corrected_sums(self, face: Face, moves: Mapping[str, Values]) -> Callable[[Triple], Values]:
        """The engine's own way with sums, on this face."""
        fitted = fit(self._source.space, face)
        regions = find_corrective_regions(self._source.space)
        if regions is None:
            raise ValueError("the cast's space names no line of lids or lips; expected the built-in cast")
        expressions = self._source.cast.expressions
        worn = {unit: (fitted.positions + move).astype(np.float32) for unit, move in moves.items()}
        allowed = {unit: measure_allowance(regions, fitted, expressions[unit], worn[unit]) for unit in moves}

        def add(triple: Triple) -> Values:
            balls = Eyeballs.of(fitted, regions.eyes, np.sum([expressions[unit].eyes for unit in triple], axis=0))
            mixed = (fitted.positions + sum(moves[unit] for unit in triple)).astype(np.float32)
            together = np.sum([allowed[unit] for unit in triple], axis=0)
            return correct_combination(regions, fitted.positions, mixed, together, balls).astype(np.float64)

        return add

    def _teeth_in_sums(
        self, face: Face, rest: Values, moves: Mapping[str, Values]
    ) -> Callable[[Triple, Values], float]:
        """How far teeth stand out of the skin (V, 3) of a sum more than the summands allow together, metres."""
        source = self._source
        teeth = np.concatenate([fit(source.space, face).parts[name] for name in TEETH]).astype(np.float64)
        own = {unit: teeth_on(source, face, rest + move, unit) - teeth for unit, move in moves.items()}
        alone = {unit: teeth_out(rest + moves[unit], source.sheet, teeth + move) for unit, move in own.items()}

        def measure(triple: Triple, now: Values) -> float:
            out = teeth_out(now, source.sheet, teeth + sum(own[unit] for unit in triple))
            return out - sum(alone[unit] for unit in triple)

        return measure

    def find_crossed(self, rest: Values, now: Values) -> Values:
        """How far both sides of each line have passed each other, rung by rung, metres, more than at rest."""
        return np.concatenate([crossing(line, rest, now) for line in self._source.lines])

    def measure_deep(self, face: Face, rest: Values, now: Values) -> Values:
        """How much deeper than at rest each skin vertex lies in an eyeball, (s,) metres."""
        deep = [
            np.maximum(radius - np.linalg.norm(now[self._skin] - centre, axis=1), 0.0)
            - np.maximum(radius - np.linalg.norm(rest[self._skin] - centre, axis=1), 0.0)
            for centre, radius in balls_of(self._source, face)
        ]
        result: Values = np.maximum(np.max(deep, axis=0), 0.0)
        return result


def crossing(line: Line, rest: Values, now: Values) -> Values:
    """How far the two sides of a line have passed each other, rung by rung, (RUNGS,) metres, more than at rest."""
    still = line.rungs(rest)
    moved = line.rungs(now)
    along = np.array([0.0, 1.0, 0.0]) if line.kind == "lips" else still / np.linalg.norm(still, axis=1, keepdims=True)
    result: Values = np.maximum(np.minimum((along * still).sum(axis=1), 0.0) - (along * moved).sum(axis=1), 0.0)
    return result
