"""Correctives of combinations: what several compounds together fold or pierce, and none alone, is repaired.

A fold is a triangle that is turned over. Each frame, after the blend (docs/method.md, "Correctives of combinations").
Artists sculpt such fixes by hand and call them correctives or combination shapes; here they are computed. One compound
on one face keeps its shape: each has an allowance of what it uses up by itself (`measure_allowance`), weighted like the
mix; but it folds nothing. The GPU of a stage does the same (web/src/face/blend/corrective_shaders.ts). All of it is
continuous in the weights: lids and lips that cross move apart by half each; lids are pushed out of the eyeball, whose
cornea bulges where it looks; triangles about to fold are projected (`omote.geometry.orientation`). Rejected: smoothing
displacements, which folded more than it repaired.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Floats, Values
from omote.geometry.orientation import area_shares, repair_triangles, rest_normals
from omote.model.space.expression import Expression
from omote.model.space.face_fit import FittedFace
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.space.parts import eye_rotation
from omote.model.transfer.corrective_regions import CorrectiveRegions, Crossing
from omote.model.weak_cache import weakly_cached_with

# Areas are shares of a triangle's own area at rest, seen along its normal at rest.
ROUNDS = (8, 8, 32)
"""Rounds of fold repair, block by block; before each lids and lips are separated, and lids leave the eyeballs."""
LEAST_AREA = 0.1
"""The area that a triangle keeps; less where a compound alone leaves less."""
FLOOR = 0.02
"""The area that it keeps whatever the compounds do alone: what each one leaves of it does not add."""
MOMENTUM = 0.5
"""The share of its last step that a vertex goes on, round by round (`omote.geometry.orientation`)."""
MARGIN = 0.5
FARTHEST = 0.03
"""The goal lies beyond the area that is kept by this share of what lacks, and by this area at most: what a few rounds
leave lacking folds nothing."""
DEEP = 0.4
KEPT = 0.3
"""A sum is damped where a triangle lacks more than this area beside what it keeps; the least share of a sum that is
left."""
SLIVER = 1e-7
"""Twice the area (square metres) under which a triangle damps a sum the less, the smaller it is: the smallest of the
built-in cast has as much, mixes of its faces leave a sixteenth of it, and a tenth of a millimetre turns that over."""
BULGE = 0.035
CORNEA = 0.6
"""How far the cornea stands out of the ball, in radii, and where it ends, radians from the line of sight."""
AREA_SLACK = 1e-3
LENGTH_SLACK = 1e-6
"""What rounding may use up: share of a triangle's area, and metres."""


@dataclass(frozen=True, eq=False)
class Eyeballs:
    """Both eyeballs as mixed: centres (2, 3) and radii (2,) metres, angles (2, 2): yaw and pitch, radians."""

    centres: Values
    radii: Values
    angles: Values

    @property
    def sights(self) -> Values:
        """Where each eye looks, unit vectors (2, 3)."""
        return np.stack([eye_rotation(*angles)[:, 2] for angles in self.angles])

    @staticmethod
    def of(face: FittedFace, eyes: tuple[str, ...], angles: Values) -> Eyeballs:
        """The eyeballs of a face, eyes: their parts' names, turned by angles (2, 2): yaw and pitch, radians."""
        centres = np.array([face.centres[eye] for eye in eyes]).reshape(-1, 3)
        return Eyeballs(centres, np.array([face.ball_radius(eye) for eye in eyes]), angles)


def measure_allowance(regions: CorrectiveRegions, face: FittedFace, expression: Expression, skin: Floats, /) -> Floats:
    """What one compound alone uses up: (regions.size,), of triangles, rungs (metres) and lids (metres), never
    negative.

    regions: of the face's space; skin (V, 3): the compound of face and expression, metres.
    """
    still = _at_rest(regions, face)
    here = still.points
    there = skin[regions.rows].astype(np.float64)
    shares = area_shares(there, still.normals, still.sizes, regions.triangles)
    kept = np.where(shares < 0.0, AREA_SLACK, np.minimum(AREA_SLACK, shares))  # what it does not fold is not to fold
    rungs = []
    for crossing in regions.crossings:
        _, least, now = _openings(crossing, here, there)
        rungs.append(least - now + LENGTH_SLACK)
    balls = replace(still.balls, angles=expression.eyes)
    lids = _lid_depths(regions, there, balls) - still.depths + LENGTH_SLACK
    result = np.concatenate([LEAST_AREA + kept - shares, *rungs, lids])
    slack = np.where(np.arange(regions.size) < len(regions.triangles), 0.0, LENGTH_SLACK)
    return np.where(result > slack, result, 0.0).astype(np.float32)


@dataclass(frozen=True, eq=False)
class _AtRest:
    """What is the same for all compounds of one face: rows (m, 3) at rest, triangles' normals and their squared
    lengths, eyeballs, and how deep lids lie in them."""

    points: Values
    normals: Values
    sizes: Values
    balls: Eyeballs
    depths: Values


@weakly_cached_with
def _at_rest(regions: CorrectiveRegions, face: FittedFace) -> _AtRest:
    points = face.positions[regions.rows].astype(np.float64)
    balls = Eyeballs.of(face, regions.eyes, np.zeros((2, 2)))
    normals, sizes = rest_normals(points, regions.triangles)
    return _AtRest(points, normals, sizes, balls, _lid_depths(regions, points, balls))


def correct_combination(
    regions: CorrectiveRegions, rest: Floats, positions: Floats, allowed: Floats, balls: Eyeballs, /, *,
    rounds: tuple[int, ...] = ROUNDS, damped: bool = True,
) -> Floats:  # fmt: skip
    """The skin of a mix with its folds damped and repaired, lids and lips apart; the positions as they were where
    nothing is beyond what is allowed.

    regions: what may be corrected; rest (V, 3): the mixed face without expression, metres; positions (V, 3): the mix;
    allowed (regions.size,): the sum of the compounds' allowances, each times the size of its weight; balls: as mixed;
    rounds: of fold repair, block by block; damped: whether folds are damped first (the built-in cast is baked without).
    """
    here = rest[regions.rows].astype(np.float64)
    blended = positions[regions.rows].astype(np.float64)
    normals, sizes = rest_normals(here, regions.triangles)
    first = len(regions.triangles)
    second = first + RUNGS * len(regions.crossings)
    areas, rungs, lids = np.split(allowed.astype(np.float64), [first, second])
    rungs = rungs.reshape(-1, RUNGS)
    points = blended.copy()
    if damped:
        deep = DEEP * np.maximum(SLIVER / np.maximum(np.sqrt(sizes), 1e-12), 1.0)
        points = _damp_folds(regions, here, points, normals, sizes, LEAST_AREA - areas - deep)
    goals = np.maximum(LEAST_AREA - areas, FLOOR)
    lids = lids + _lid_depths(regions, here, replace(balls, angles=np.zeros((2, 2))))
    _open_crossings(regions, here, points, rungs)
    for block, count in enumerate(rounds):
        _open_crossings(regions, here, points, rungs)
        _push_out_of_eyeballs(regions, points, lids, balls)
        if block == 0:
            lacking = np.maximum(goals - area_shares(points, normals, sizes, regions.triangles), 0.0)
            goals += np.minimum(MARGIN * lacking, FARTHEST)
        repair_triangles(points, normals, sizes, regions.triangles, goals, count, MOMENTUM)
    move = points - blended
    if not move.any():
        return positions
    out = positions.copy()
    out[regions.rows] = points
    out[regions.followers] += np.einsum("fk,fkc->fc", regions.weights, move[regions.anchors]).astype(np.float32)
    return out


def _damp_folds(
    regions: CorrectiveRegions, rest: Values, points: Values, normals: Values, sizes: Values, goals: Values
) -> Values:
    """Rows (m, 3) of a mix, brought back towards those at rest where the sum folds triangles far below goals (t,).

    A patch keeps what the worst of its triangles may keep: its area is a quadratic of the share that is kept.
    """
    patches = regions.patches
    whole = area_shares(points, normals, sizes, regions.triangles)
    over = whole < goals
    if not over.any():
        return points
    half = area_shares(0.5 * (rest + points), normals, sizes, regions.triangles)
    keep = np.ones(len(goals))
    keep[over] = np.maximum(_share_at_goal(whole[over], half[over], goals[over]), KEPT)
    kept = np.minimum.reduceat(keep[patches.triangles], np.concatenate([[0], patches.ends[:-1]]))
    lost = (patches.shares * (1.0 - kept[patches.members])).sum(axis=1)
    return points + lost[:, None] * (rest - points)


def _share_at_goal(whole: Values, half: Values, goals: Values) -> Values:
    """The share of a move at which a triangle's area, 1 at none of it, is at its goal, which all of it misses."""
    square = 2.0 * (whole - 1.0) - 4.0 * (half - 1.0)
    slope = whole - 1.0 - square
    root = np.sqrt(np.maximum(slope**2 - 4.0 * square * (1.0 - goals), 0.0))
    # The one root of 1 - goal + slope s + square s^2 in (0, 1): it is above zero at 0 and below at 1.
    return 2.0 * (1.0 - goals) / np.maximum(root - slope, 1e-12)


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


def _open_crossings(regions: CorrectiveRegions, rest: Values, points: Values, allowed: Values) -> None:
    """Opens every line where it crosses, in place: either side by half, the skin around it by less and less."""
    for crossing, own in zip(regions.crossings, allowed, strict=True):
        along, least, now = _openings(crossing, rest, points)
        missing = np.maximum(least - own - now, 0.0)
        if not missing.any():
            continue
        half = 0.5 * missing[:, None] * along
        place = np.minimum(np.maximum(crossing.share * RUNGS - 0.5, 0.0), RUNGS - 1.0)
        first = np.minimum(place.astype(np.int32), RUNGS - 2)
        after = (place - first)[:, None]
        points[crossing.near] += crossing.side[:, None] * ((1.0 - after) * half[first] + after * half[first + 1])


# ---- lids and eyeballs


def _lid_depths(regions: CorrectiveRegions, points: Values, balls: Eyeballs) -> Values:
    """How deep each lid vertex lies in its eyeball, (r,) metres, zero outside."""
    depth, _ = _measure_depths(regions, points, balls)
    return np.maximum(depth, 0.0)


def _measure_depths(regions: CorrectiveRegions, points: Values, balls: Eyeballs) -> tuple[Values, Values]:
    """Depth (r,), negative outside, and the outward direction (r, 3)."""
    outward = points[regions.lids] - balls.centres[regions.eye]
    distance = np.maximum(np.linalg.norm(outward, axis=1), 1e-9)
    outward = outward / distance[:, None]
    end = np.cos(CORNEA)
    cosine = (outward * balls.sights[regions.eye]).sum(axis=1)
    up = np.maximum((cosine - end) / (1.0 - end), 0.0)
    radius = balls.radii[regions.eye] * (1.0 + BULGE * up * up * (3.0 - 2.0 * up))
    return radius - distance, outward


def _push_out_of_eyeballs(regions: CorrectiveRegions, points: Values, allowed: Values, balls: Eyeballs) -> None:
    """Pushes lids out of the eyeballs, in place, as far as they lie deeper than allowed (r,)."""
    depth, outward = _measure_depths(regions, points, balls)
    push = np.maximum(depth - allowed, 0.0)
    points[regions.lids] += push[:, None] * outward
