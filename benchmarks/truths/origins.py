"""The package's units as its artist made them for three origins, on the heads of these origins.

MakeHuman's heads are its sliders at one origin, half female and half male, age young (`Build`); the package does not
say which heads a unit was sculpted on. Many units are copies: what is the same for all three says that the artist
added deltas, not what another person would do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.random_faces import PeopleMaker
from benchmarks.truths.pair import Pair
from omote.model.cast import Cast
from omote.model.known_names import GENERIC
from omote.model.space.face import Face
from omote.model.transfer.paper_map import compile_expression, displace_generic
from tools.baking.expressions import MAKEHUMAN
from tools.baking.heads.basemesh import read_target
from tools.baking.heads.moves import ORIGINS
from tools.baking.heads.person import Build, Person

Values = NDArray[np.float64]
Moves = Mapping[str, Values]


class Origins:
    """Heads of the three origins and their units on the base mesh (n, 3), metres."""

    def __init__(self, cast: Cast, units: Sequence[str] = tuple(MAKEHUMAN)) -> None:
        maker = PeopleMaker(cast)
        self.cast = cast
        self.head = maker.head
        self.faces: dict[str, Face] = {
            origin: maker.make(origin, Person(look={}, build=Build(gender=0.5, age=0.5, race={origin: 1.0})))
            for origin in ORIGINS
        }
        self.moves: dict[str, Moves] = {
            origin: {
                unit: self.head.unit_metres * read_target(maker.read_unit(origin, unit), maker.count) for unit in units
            }
            for origin in ORIGINS
        }

    def pairs(self) -> Iterator[Pair]:
        """Each origin to each other; the generic head to each origin, its units as the cast has them (the mean of all
        three, corrected), and as the mean of the other two, which knows nothing of the third."""
        for face in ORIGINS:
            for source in ORIGINS:
                if source != face:
                    yield self._pair(f"{source} to {face}", self.faces[source], self.moves[source], face)
            others = [self.moves[origin] for origin in ORIGINS if origin != face]
            mean = {unit: np.mean([moves[unit] for moves in others], axis=0) for unit in others[0]}
            generic = self.cast.faces[GENERIC]
            pair = self._pair(f"generic, of the others, to {face}", generic, mean, face)
            yield pair
            yield Pair(
                f"generic, of the cast, to {face}", pair.space, generic, pair.face, self._cast_moves(), pair.true, {}
            )

    def copies(self) -> int:
        """How many units are the same for all three origins."""
        first, *rest = (self.moves[origin] for origin in ORIGINS)
        return sum(all(np.array_equal(first[unit], moves[unit]) for moves in rest) for unit in first)

    def _pair(self, name: str, source: Face, moves: Moves, face: str) -> Pair:
        rows = self.head.skin.vertices
        parts = self.head.parts
        true = {unit: move[rows] for unit, move in self.moves[face].items()}
        with_parts = {
            unit: {part: move[piece.vertices] for part, piece in parts.items()} for unit, move in moves.items()
        }
        given = {unit: move[rows] for unit, move in moves.items()}
        return Pair(name, self.cast.space, source, self.faces[face], given, true, with_parts)

    def _cast_moves(self) -> Moves:
        space = self.cast.space
        fields = self.cast.expressions
        return {
            unit: displace_generic(space, compile_expression(space, fields[unit])) for unit in self.moves[ORIGINS[0]]
        }
