"""Where skin folds: how far the expressions of a cast press each place of the head together at most.

The amounts differ tenfold over a face (74 % between the brows, 13 % on the forehead), so a fold's depth is by the share
of what is the most at its place (docs/method.md, "Folds").
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.geometry.strain import compression, fans_of, vertex_strain
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import compile_expression, displace_generic

FARTHEST_ANGLE = 1.45
"""Radians from straight ahead up to which skin is asked: what lies behind has no folds, nor have ears."""
LIDS = (
    *("eyeBlinkLeft", "eyeBlinkRight"),
    *("eyeLookDownLeft", "eyeLookDownRight", "eyeLookInLeft", "eyeLookInRight"),
    *("eyeLookOutLeft", "eyeLookOutRight", "eyeLookUpLeft", "eyeLookUpRight"),
)
"""Units whose pressing counts as rest: crow's feet must not flash with each blink, nor with a look."""
LOWEST_PLACE = -0.15
"""Metres; what lies below is the neck."""
RANGE = (0.08, 0.62)
"""What the most is held in: 0 and 255 stand for none asked and for the end of it."""
ROUNDS = 3
"""How often the most is averaged with the vertices around."""


def asked_of(space: ParameterSpace, /) -> NDArray[np.bool_]:
    """Which vertices of the skin (V,) may fold: those of the sheet that lie in front, above the neck."""
    return space.on_sheet & (np.abs(space.theta) < FARTHEST_ANGLE) & (space.h > LOWEST_PLACE)


def most_compression(space: ParameterSpace, expressions: Iterable[Expression], /) -> NDArray[np.uint8]:
    """How far expressions press each vertex of the generic head together at most (V,), of 255 and the end of `RANGE`; 0
    where none is asked.

    space: of the generic head; expressions: all that count.
    """
    asked = asked_of(space)
    triangles = fans_of(space.triangles, asked)
    rest = space.points
    most: Values = np.zeros(len(rest))
    for expression in expressions:
        worn = rest + displace_generic(space, compile_expression(space, expression))
        most = np.maximum(most, compression(vertex_strain(rest, worn, triangles)))
    for _ in range(ROUNDS):
        most = _averaged(most, triangles)
    low, high = RANGE
    held = np.clip(most, low, high) / high * 255.0
    return np.where(asked, np.rint(held), 0.0).astype(np.uint8)


def _averaged(values: Values, triangles: NDArray[np.int32]) -> Values:
    total = values.copy()
    count = np.ones(len(values))
    for corner in range(3):
        for other in (1, 2):
            np.add.at(total, triangles[:, corner], values[triangles[:, (corner + other) % 3]])
            np.add.at(count, triangles[:, corner], 1.0)
    return np.asarray(total / count)
