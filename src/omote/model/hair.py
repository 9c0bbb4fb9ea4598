"""A hair style: strands on the generic head, bound to the skin beneath them and so retargeted to every face."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats, Indices, Values

LINKS = 6
"""Vertices of the skin that carry one place of a strand."""
STRETCH = 0.75
"""How far one piece of a strand may be turned or stretched by a face, of its own length."""
_SUM = 1e-4  # weights are stored as float32


@dataclass(frozen=True, eq=False)
class HairStyle:
    """Strands (n of k places, root to tip) on the generic face.

    points (n, k, 3) metres;  rows (n, k, LINKS) and weights (n, k, LINKS): the skin's vertices that carry each place;
    anchors (n,): the vertex at each root, whose expressions the whole strand follows;  facing (n, k, 3): unit vectors
    away from the head;  light (n, k): open sky, 0..1;  fullness (n,): of `width`, 0..1: hair is finer towards its
    edges;  width: of a strand's ribbon, metres;  scalp: the shade on the skin that goes with it, 0..1. The first few
    strands cover the head as evenly as all of them do. Raises ValueError on arrays that do not belong together.
    """

    name: str
    points: Floats
    rows: Indices
    weights: Floats
    anchors: Indices
    facing: Floats
    light: Floats
    fullness: Floats
    width: float
    scalp: float = 1.0

    def __post_init__(self) -> None:
        count, places = self.points.shape[:2]
        expected = {
            "points": (count, places, 3),
            "rows": (count, places, LINKS),
            "weights": (count, places, LINKS),
            "anchors": (count,),
            "facing": (count, places, 3),
            "light": (count, places),
            "fullness": (count,),
        }
        for name, shape in expected.items():
            values = getattr(self, name)
            if values.shape != shape:
                raise ValueError(f"{name} of hair style {self.name!r} has shape {values.shape}; expected {shape}")
            values.setflags(write=False)
        if np.abs(self.weights.sum(axis=2) - 1.0).max() > _SUM:
            raise ValueError(f"the weights of hair style {self.name!r} do not sum to one; carry its strands again")

    @property
    def arrays(self) -> tuple[NDArray[Any], ...]:
        """All arrays of a style."""
        numbers = np.array([self.width, self.scalp])
        return self.points, self.rows, self.weights, self.anchors, self.facing, self.light, self.fullness, numbers


def place_strands(style: HairStyle, generic: Values, positions: Values, /) -> Values:
    """Places the strands (n, k, 3) of a style on a face with positions (V, 3); generic (V, 3): where they were made.

    Linear in the positions, so that a mix of faces wears the mix of their hair, until a piece of a strand would change
    by more than STRETCH of its length: neighbouring vertices of an ear that hangs go far apart and would knot it.
    """
    moves = np.asarray(positions, np.float64) - generic
    carried_by = np.einsum("skl,skld->skd", style.weights.astype(np.float64), moves[style.rows])
    return style.points + _keep_pieces(carried_by, style.points.astype(np.float64))


def _keep_pieces(moves: Values, points: Values) -> Values:
    """Moves (n, k, 3) of strands (n, k, 3), from the root on no faster along the strand than STRETCH."""
    kept = moves.copy()
    most = STRETCH * np.linalg.norm(np.diff(points, axis=1), axis=2)
    for place in range(1, moves.shape[1]):
        step = moves[:, place] - kept[:, place - 1]
        size = np.linalg.norm(step, axis=1)
        share = np.minimum(1.0, most[:, place - 1] / np.maximum(size, 1e-12))
        kept[:, place] = kept[:, place - 1] + share[:, None] * step
    return kept
