"""What every map starts from: the generic face wearing each unit, its lines, and random sums of units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

import omote
from omote.model.cast import Cast
from omote.model.known_names import GENERIC
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound
from omote.model.transfer.paper_map import Compiled, compile_expression, displace_generic

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

KINDS = ("arkit", "makehuman")
PLAYED = ("arkit", "makehuman", "performed")
SEED = 1993
TRIPLES = 200
# Faces of the cast that nobody would call a person; all others are human.
NOT_HUMAN = frozenset({"doll", "goblin", "alien", "dog", "cat", "noh"})


@dataclass(frozen=True, eq=False)
class Source:
    """The generic face with positions (V, 3) and sheet (T, 3), its lines, and what each unit does to it.

    compiled: each unit located on S, once for all faces; moves: what it does here, displacement (V, 3), by the paper's
    map; triples: three units each, drawn with SEED.
    """

    cast: Cast
    positions: Values
    sheet: Indices
    lines: tuple[Line, ...]
    compiled: Mapping[str, Compiled]
    moves: Mapping[str, Values]
    triples: tuple[tuple[str, str, str], ...]

    @property
    def space(self) -> ParameterSpace:
        """The parameter space of the cast."""
        return self.cast.space

    def wear(self, unit: str, weight: float) -> Values:
        """The generic face (V, 3) wearing a unit's field at a weight."""
        return compound(self.space, self.cast.faces[GENERIC], self.cast.expressions[unit], weight).astype(np.float64)


def load_source(
    units: int | None = None, *, kinds: tuple[str, ...] = KINDS, seed: int = SEED, count: int = TRIPLES
) -> Source:  # fmt: skip
    """The built-in cast as a source; units: how many of these kinds, spread over all, where fewer are enough; as many
    triples as counted, drawn with the seed."""
    cast = omote.load_cast()
    names = [name for name, title in cast.titles.items() if title.kind in kinds]
    if units is not None:
        names = [names[i] for i in np.linspace(0, len(names) - 1, units).astype(int)]
    space = cast.space
    # Only a face with a gain for its ears turns them, and gains do not count here; how far they turn is no fold.
    still = {name: replace(cast.expressions[name], ears=np.zeros((2, 3))) for name in names}
    compiled = {name: compile_expression(space, still[name]) for name in names}
    moves = {name: displace_generic(space, compiled[name]) for name in names}
    sheet = space.sheet_triangles
    draw = np.random.default_rng(seed)
    added = [name for name in names if cast.titles[name].kind in KINDS]  # performed ones are mixed, never added up
    triples = tuple(tuple(draw.choice(added, 3, replace=False).tolist()) for _ in range(count))
    positions = cast.faces[GENERIC].positions.astype(np.float64)
    return Source(cast, positions, sheet, space.lines, compiled, moves, triples)
