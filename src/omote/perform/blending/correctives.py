"""Sums settle: what several compounds together fold or pierce, and none alone, is put right on the way out.

One compound on one face is never changed: each brings along how much it uses up by itself (`allowance`), weighted like
the mix. The stage's GPU does the same, pass by pass (web/src/stage/settle_shaders.ts). All of it is continuous in
the weights: lids and lips that cross give way by half each; lids leave the eyeball, whose cornea bulges where it looks;
triangles about to turn over are kept from it by projecting their vertices (position based dynamics: Mueller et al.
2007, section 3.3, all constraints at once).
"""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.model.space.expression import Expression
from omote.model.space.face_fit import FittedFace
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.space.parts import eye_rotation
from omote.model.transfer.corrective_regions import Crossing, Settling
from omote.perform.blending.orientation import keep_upright, rest_normals, shares

Floats = NDArray[np.float32]
Values = NDArray[np.float64]
Indices = NDArray[np.int32]

ROUNDS = 16
"""How often triangles are projected; half of them before lids and lips are parted for the last time."""
UPRIGHT = 0.1
"""A triangle keeps this share of its area at rest, seen along its normal at rest."""
BULGE, CORNEA = 0.035, 0.6
"""How far the cornea stands out of the ball, in radii, and where it ends, radians from the line of sight."""
AREA_SLACK, LENGTH_SLACK = 1e-3, 1e-6
"""What rounding may use up: share of a triangle's area, and metres."""


@dataclass(frozen=True, eq=False)
class Balls:
    """Both eyeballs as mixed: centres (2, 3) and radii (2,) metres, angles (2, 2): yaw and pitch, radians."""

    centres: Values
    radii: Values
    angles: Values

    @property
    def sights(self) -> Values:
        """Where each eye looks, unit vectors (2, 3)."""
        return np.stack([eye_rotation(*angles)[:, 2] for angles in self.angles])

    @staticmethod
    def of(face: FittedFace, eyes: tuple[str, ...], angles: Values) -> Balls:
        """The eyeballs of a face, by their parts' names, turned by angles (2, 2)."""
        radii = [face.ball_radius(eye) for eye in eyes]
        return Balls(np.array([face.centres[eye] for eye in eyes]).reshape(-1, 3), np.array(radii), angles)

    def ahead(self) -> Balls:
        """The same balls looking straight ahead."""
        return Balls(self.centres, self.radii, np.zeros((2, 2)))


def allowance(settling: Settling, face: FittedFace, expression: Expression, worn: Floats, /) -> Floats:
    """What one compound alone uses up: (settling.size,), of triangles, rungs (metres) and lids (metres), never
    negative.

    worn (V, 3): the compound of face and expression.
    """
    still = _still_of(settling, face)
    balls = Balls(still.balls.centres, still.balls.radii, expression.eyes)
    here, there = still.points, worn[settling.rows].astype(np.float64)
    areas = UPRIGHT + AREA_SLACK - shares(there, still.normals, still.sizes, settling.triangles)
    rungs = []
    for crossing in settling.crossings:
        _, least, now = _openings(crossing, here, there)
        rungs.append(least - now + LENGTH_SLACK)
    lids = _depths(settling, there, balls) - still.depths + LENGTH_SLACK
    result = np.concatenate([areas, *rungs, lids])
    return np.where(_beyond_slack(settling, result), result, 0.0).astype(np.float32)


@dataclass(frozen=True, eq=False)
class _Still:
    """What is the same for all compounds of one face: rows (m, 3) at rest, triangles' normals and their squared
    lengths, eyeballs, and how deep lids lie in them."""

    points: Values
    normals: Values
    sizes: Values
    balls: Balls
    depths: Values


_stills: WeakKeyDictionary[FittedFace, tuple[Settling, _Still]] = WeakKeyDictionary()


def _still_of(settling: Settling, face: FittedFace) -> _Still:
    known = _stills.get(face)
    if known is None or known[0] is not settling:
        points = face.positions[settling.rows].astype(np.float64)
        balls = Balls.of(face, settling.eyes, np.zeros((2, 2)))
        normals, sizes = rest_normals(points, settling.triangles)
        known = (settling, _Still(points, normals, sizes, balls, _depths(settling, points, balls)))
        _stills[face] = known
    return known[1]


def _beyond_slack(settling: Settling, values: Values) -> NDArray[np.bool_]:
    slack = np.full(settling.size, LENGTH_SLACK)
    slack[: len(settling.triangles)] = 0.0
    result: NDArray[np.bool_] = values > slack
    return result


def settled(settling: Settling, rest: Floats, positions: Floats, allowed: Floats, balls: Balls, /) -> Floats:
    """The skin (V, 3) of a mix put right; rest (V, 3): the mixed face without expression.

    allowed (settling.size,): the sum of the compounds' allowances, each times the size of its weight. Where nothing is
    beyond it, the positions come back as they were.
    """
    here, points = rest[settling.rows].astype(np.float64), positions[settling.rows].astype(np.float64)
    mixed = points.copy()
    areas, rungs, lids = _split(settling, allowed)
    normals, sizes = rest_normals(here, settling.triangles)
    goals = UPRIGHT - areas
    lids = lids + _depths(settling, here, balls.ahead())
    for half in range(2):
        for _ in range(2 - half):
            _part(settling, here, points, rungs)
        if half == 0:
            _leave(settling, points, lids, balls)
        keep_upright(points, normals, sizes, settling.triangles, goals, ROUNDS // 2)
    _leave(settling, points, lids, balls)
    move = points - mixed
    if not move.any():
        return positions
    out = positions.copy()
    out[settling.rows] = points
    out[settling.followers] += np.einsum("fk,fkc->fc", settling.weights, move[settling.anchors]).astype(np.float32)
    return out


def _split(settling: Settling, allowed: Floats) -> tuple[Values, Values, Values]:
    first = len(settling.triangles)
    second = first + RUNGS * len(settling.crossings)
    values = allowed.astype(np.float64)
    return values[:first], values[first:second].reshape(-1, RUNGS), values[second:]


# ---- lids and lips


def _openings(crossing: Crossing, rest: Values, points: Values) -> tuple[Values, Values, Values]:
    """Directions (RUNGS, 3) along which a line opens, the least opening (RUNGS,) and the present one, metres.

    The least is none, or what crosses at rest already.
    """
    still = np.einsum("rk,rkc->rc", crossing.weights, rest[crossing.vertices])
    now = np.einsum("rk,rkc->rc", crossing.weights, points[crossing.vertices])
    if crossing.kind == "lips":
        along = np.zeros((RUNGS, 3))
        along[:, 1] = 1.0
    else:
        along = still / np.maximum(np.linalg.norm(still, axis=1, keepdims=True), 1e-9)
    return along, np.minimum((along * still).sum(axis=1), 0.0), (along * now).sum(axis=1)


def _part(settling: Settling, rest: Values, points: Values, allowed: Values) -> None:
    """Opens every line where it crosses, in place: either side by half, the skin around it less and less."""
    for crossing, own in zip(settling.crossings, allowed, strict=True):
        along, least, now = _openings(crossing, rest, points)
        lack = np.maximum(least - own - now, 0.0)
        if not lack.any():
            continue
        half = 0.5 * lack[:, None] * along
        place = np.minimum(np.maximum(crossing.share * RUNGS - 0.5, 0.0), RUNGS - 1.0)
        first = np.minimum(place.astype(np.int32), RUNGS - 2)
        after = (place - first)[:, None]
        points[crossing.near] += crossing.side[:, None] * ((1.0 - after) * half[first] + after * half[first + 1])


# ---- lids and eyeballs


def _depths(settling: Settling, points: Values, balls: Balls) -> Values:
    """How deep each lid vertex lies in its ball, (r,) metres, zero outside."""
    depth, _ = _in_balls(settling, points, balls)
    result: Values = np.maximum(depth, 0.0)
    return result


def _in_balls(settling: Settling, points: Values, balls: Balls) -> tuple[Values, Values]:
    """Depth (r,), negative outside, and the outward direction (r, 3)."""
    outward = points[settling.lids] - balls.centres[settling.eye]
    distance = np.maximum(np.linalg.norm(outward, axis=1), 1e-9)
    outward = outward / distance[:, None]
    end = np.cos(CORNEA)
    cosine = (outward * balls.sights[settling.eye]).sum(axis=1)
    up = np.maximum((cosine - end) / (1.0 - end), 0.0)
    radius = balls.radii[settling.eye] * (1.0 + BULGE * up * up * (3.0 - 2.0 * up))
    return radius - distance, outward


def _leave(settling: Settling, points: Values, allowed: Values, balls: Balls) -> None:
    """Pushes lids out of the eyeballs, in place, as far as they lie deeper than allowed (r,)."""
    depth, outward = _in_balls(settling, points, balls)
    push = np.maximum(depth - allowed, 0.0)
    points[settling.lids] += push[:, None] * outward
