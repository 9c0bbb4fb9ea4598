"""Smoothing brushes: places of the skin where a sculpt keeps the form and removes detail, such as the folds of an
ear."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.geometry.laplacian import smoothing_matrix
from omote.model.space.eye_socket import fall_off
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

MOST_ROUNDS = 200
# Up to this share of its reach a brush works in full; from there it works less and less.
_CORE = 0.5


@dataclass(frozen=True)
class Brush:
    """Smooths the skin within `reach` metres of a point of the generic head, `rounds` times, softly at its rim.

    Raises ValueError on a reach that is not above zero and on rounds that are no whole number from 1 to MOST_ROUNDS.
    """

    at: tuple[float, float, float]
    reach: float
    rounds: int

    def __post_init__(self) -> None:
        if len(self.at) != 3 or not np.isfinite(self.at).all():
            raise ValueError(f"a brush is at {self.at!r}; expected three finite numbers, metres")
        if not 0.0 < self.reach < np.inf:
            raise ValueError(f"a brush reaches {self.reach!r} m; expected a distance above zero")
        if isinstance(self.rounds, bool) or not isinstance(self.rounds, int) or not 1 <= self.rounds <= MOST_ROUNDS:
            raise ValueError(
                f"a brush goes {self.rounds!r} rounds; expected a whole number of them, from 1 to {MOST_ROUNDS}"
            )

    def strength(self, points: Values) -> Values:
        """How much of a round reaches each point (n, 3) of the generic head: (n,), 1 in the core, 0 beyond."""
        away = np.linalg.norm(points - self.at, axis=1) / self.reach
        return fall_off((away - _CORE) / (1.0 - _CORE))


def apply_brushes(
    space: ParameterSpace, skin: Values, brushes: Sequence[Brush], /, *, symmetric: bool = True
) -> Values:
    """Smooths the skin (V, 3) under each brush by the mean of its one-rings (Laplacian smoothing); the rest stays.

    symmetric: a brush works at its mirror image too.
    """
    result = skin.copy()
    mean = smoothing_matrix(space.skin_triangles, space.vertex_count)
    mirror = np.array([-1.0, 1.0, 1.0])
    for brush in brushes:
        strength = brush.strength(space.points)
        if symmetric:
            strength = np.maximum(strength, brush.strength(space.points * mirror))
        for _ in range(brush.rounds):
            result += strength[:, None] * (mean @ result - result)
    return result
