"""Lids lie no deeper in an eyeball than on the generic face (docs/method.md, "Eyeball clearance")."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Indices, Values
from omote.geometry.laplacian import smoothing_matrix

# Vertices within so many radii of the eyeball's centre may be pushed.
PUSHED_RADII = 1.8
# A push spreads over so many rings, from one to the next this share of it, so that no single vertex stands out.
RINGS = 5
SHARE = 0.6
# A vertex that has gone this far on the source has come out of the corner where it was hidden at rest, metres.
HIDDEN_METRES = 0.003


@dataclass(frozen=True, eq=False)
class Eyeball:
    """An eyeball: its centre (3,) and radius, metres. Raises ValueError where it is none."""

    centre: Values
    radius: float

    def __post_init__(self) -> None:
        if np.shape(self.centre) != (3,) or not np.isfinite(self.centre).all():
            raise ValueError(f"the centre of an eyeball is {self.centre}; expected three finite numbers, metres")
        if not (np.isfinite(self.radius) and self.radius > 0):
            raise ValueError(f"the radius of an eyeball is {self.radius}; expected a positive number of metres")


@dataclass(frozen=True, eq=False)
class Clearance:
    """The lids around one eyeball of a face.

    near (m,): the sheet's vertices around it; starts (m,), neighbours: the rings around each, itself among them; rest
    (m, 3): on the generic face at rest; deeper (m,): how much deeper in the ball than there they lie here, metres,
    negative where less deep.
    """

    near: Indices
    starts: Indices
    neighbours: Indices
    source: Eyeball
    ball: Eyeball
    rest: Values
    deeper: Values


def build_clearance(
    generic: Values, positions: Values, triangles: Indices, source: Eyeball, ball: Eyeball, /
) -> Clearance:
    """The clearance of an eyeball on a face with positions (V, 3).

    ball: that on this face.

    generic (V, 3) with its eyeball, source: the face on which expressions are defined; triangles (T, 3): the sheet's.
    """
    used = np.unique(triangles)
    near = used[np.linalg.norm(positions[used] - ball.centre, axis=1) < PUSHED_RADII * ball.radius].astype(np.int32)
    rings = smoothing_matrix(triangles, len(positions))[near][:, near]
    deeper = measure_depth(ball, positions[near]) - measure_depth(source, generic[near])
    return Clearance(near, rings.indptr[:-1], rings.indices, source, ball, generic[near], deeper)


def measure_depth(ball: Eyeball, points: Values, /) -> Values:
    """How deep points (n, 3) lie in a ball, (n,) metres, zero outside."""
    return np.maximum(ball.radius - np.linalg.norm(points - ball.centre, axis=1), 0.0)


def clear_eyeball(clearance: Clearance, positions: Values, moved: Values, /) -> bool:
    """Pushes the lids of positions (V, 3) out of the ball, in place; says whether anything had to go.

    clearance: of this eyeball on this face.

    moved (V, 3): the generic face wearing the expression. A vertex may lie as deep as it does there, and one that stays
    where it was at rest as much deeper, or less deep, as at rest; what is too deep goes out along the ball's normal,
    its neighbours with it, so that no dent is left.
    """
    points = positions[clearance.near]
    there = moved[clearance.near]
    still = np.maximum(1.0 - np.linalg.norm(there - clearance.rest, axis=1) / HIDDEN_METRES, 0.0)
    allowed = np.maximum(measure_depth(clearance.source, there) + still * clearance.deeper, 0.0)
    push = np.maximum(measure_depth(clearance.ball, points) - allowed, 0.0)
    if not push.any():
        return False
    for _ in range(RINGS):
        push = np.maximum(push, np.maximum.reduceat(SHARE * push[clearance.neighbours], clearance.starts))
    outward = points - clearance.ball.centre
    outward /= np.maximum(np.linalg.norm(outward, axis=1, keepdims=True), 1e-9)
    positions[clearance.near] = points + push[:, None] * outward
    return True
