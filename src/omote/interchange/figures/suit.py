"""A body in a garment, as stages draw it: cloth spans what lies hidden under it, and shoes round off toes.

The same steps as web/src/face/figure/suit.ts and body_shaders.ts.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import repeat

import numpy as np
from scipy.sparse import csr_array

from omote.arrays import Points, Values
from omote.geometry.ramp import clamp_unit, smooth_ramp
from omote.model.body.body import Body
from omote.model.body.figure_space import FigureSpace
from omote.model.body.garment import Garment

INWARD = 0.6
OUTWARD = -0.62
ROUNDS = 48
"""Steps towards the middle of the neighbours, each with one out a little farther, which keeps the volume."""
FLAT_ROUNDS = 60
CLOSE = 0.008
APART = 0.012
"""Steps in which rows that lie closer than others become flat; metres between neighbours up to which all of them do,
and from which on none."""
SHOE_ROUNDS = 16
SPANNED = ("root", "spine", "pelvis", "upperleg01")
TOES = ("toes",)
SHOE = ("foot", "toes")
"""What the names of bones begin with: of trunk and hips, whose relief cloth spans; of toes and shoes."""
LEATHER = 0.003
"""How far shoes stand off what is under them, metres."""
ROLL = 0.016
ROUND = 0.006
"""Where a garment ends around the neck, metres above the head's rim; it is round within the last of them."""


@dataclass(frozen=True, eq=False)
class SuitParts:
    """thick (V + B,): how far the garment stands off each row, metres; shoe (V + B,): how much each row is of a shoe,
    0..1; height (V + B,): metres above the plane of the head's rim."""

    thick: Values
    shoe: Values
    height: Values

    @property
    def rolled(self) -> Values:
        """How far each row is into the round end at the neck, 0..1."""
        return clamp_unit((self.height - ROLL + ROUND) / ROUND)

    @property
    def cloth(self) -> Values:
        """How far garment and shoes lie on each row, metres."""
        thick = self.thick + LEATHER * smooth_ramp(0.3, 0.7, self.shoe)
        return np.asarray(thick * (1.0 - 0.75 * self.rolled**2))


def suit_parts(space: FigureSpace, body: Body, face: Points, garment: Garment, /) -> SuitParts:
    """How garment and shoes lie on rows, and how high these lie above the rim. space: of bodies; body, face (V, 3): the
    generic ones."""
    places = np.concatenate([face, body.positions])
    rim = places[space.rim_rows]
    slope, level = np.polyfit(rim[:, 2], rim[:, 1], 1)
    return SuitParts(
        garment.thick.astype(np.float64), _moved_by(space, SHOE), places[:, 1] - level - slope * places[:, 2]
    )


def wear_suit(space: FigureSpace, first: Body, body: Body, /) -> Body:
    """The body as a suit and shoes cover it, cloth and leather themselves left out.

    space: of bodies; first: the body that others are shaped from, which says where rows lie close.

    References
    ----------
    G. Taubin, 1995: A signal processing approach to fair surface design.
    """
    middles = _middles(space)
    trunk, toes = (_body_share(space, names) for names in (SPANNED, TOES))
    close = trunk * clamp_unit((APART - _spacing(middles, first.positions.astype(np.float64))) / (APART - CLOSE))
    points = body.positions.astype(np.float64)
    points = _smooth(points, close, middles, repeat(INWARD, FLAT_ROUNDS))
    points = _smooth(points, trunk, middles, (INWARD, OUTWARD) * ROUNDS)
    return replace(body, positions=_smooth(points, toes, middles, repeat(INWARD, SHOE_ROUNDS)).astype(np.float32))


def _moved_by(space: FigureSpace, names: tuple[str, ...]) -> Values:
    """How much of each row (V + B,) bones move whose names begin so, 0..1."""
    chosen = np.array([name.startswith(names) for name in space.skeleton.names])
    return np.asarray((space.weights * chosen[space.bones]).sum(axis=1), np.float64)


def _body_share(space: FigureSpace, names: tuple[str, ...]) -> Values:
    """The same of the body's rows (B,), nothing of those of a skirt or that follow a head."""
    share = _moved_by(space, names)[space.head_rows :]
    share[space.joined] = 0.0
    share[space.first_of_skirt - space.head_rows :] = 0.0
    return share


def _middles(space: FigureSpace) -> csr_array:
    """The matrix (B, B) that takes rows to the middle of their neighbours in the body."""
    edges = np.concatenate([space.triangles[:, [0, 1]], space.triangles[:, [1, 2]], space.triangles[:, [2, 0]]])
    edges = edges[(edges >= space.head_rows).all(axis=1)] - space.head_rows
    pairs = np.unique(np.concatenate([edges, edges[:, ::-1]]), axis=0)
    count = np.maximum(np.bincount(pairs[:, 0], minlength=space.body_rows), 1)
    return csr_array((1.0 / count[pairs[:, 0]], (pairs[:, 0], pairs[:, 1])), shape=(space.body_rows, space.body_rows))


def _spacing(middles: csr_array, points: Points) -> Values:
    """The mean distance (B,) of each row from its neighbours, metres."""
    near = middles.tocoo()
    lengths = np.linalg.norm(points[near.row] - points[near.col], axis=1)
    return np.asarray(np.bincount(near.row, near.data * lengths, minlength=len(points)), np.float64)


def _smooth(points: Points, shares: Values, middles: csr_array, steps: Iterable[float]) -> Points:
    for step in steps:
        points = points + step * shares[:, None] * (middles @ points - points)
    return points
