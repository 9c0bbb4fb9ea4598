"""Identity modes: the directions in which heads differ most, and the heads that they make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Values
from omote.model.space.parameter_space import ParameterSpace


@dataclass(frozen=True, eq=False)
class IdentityModes:
    """What heads differ by, on the generic head's topology.

    skin (V, 3): the mean head, metres; moves (m, V, 3): one standard deviation of each mode, the largest mode first;
    parts, part_moves: the same of each part, by name.
    """

    skin: Values
    moves: Values
    parts: Mapping[str, Values]
    part_moves: Mapping[str, Values]

    def shape_skin(self, weights: Values, /) -> Values:
        """The skin (V, 3) of the head with weights (m,) of the modes, in standard deviations."""
        return self.skin + np.tensordot(weights, self.moves, 1)

    def shape_parts(self, weights: Values, /) -> dict[str, Values]:
        """The parts of that head."""
        return {name: self.parts[name] + np.tensordot(weights, moves, 1) for name, moves in self.part_moves.items()}


def refuse_other_topology(space: ParameterSpace, modes: IdentityModes, /) -> None:
    """Raises ValueError where modes were made for another head than the space's."""
    if len(modes.skin) != space.vertex_count:
        raise ValueError(
            f"the identity modes are of {len(modes.skin)} vertices, the space's head has {space.vertex_count}; "
            "expected the built-in cast's space"
        )
