"""Solves what skinning makes wrong of a bent elbow or knee, on each body: skin as rigid as it can be, apart, and full.

From the skin as modelled on, step by step, each from the last: as rigid as possible (O. Sorkine, M. Alexa, 2007), under
a pressure that keeps the volume, and kept on its own side of the plane through the joint that halves the angle.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.sparse import csr_array

from omote.arrays import Floats as Singles
from omote.arrays import Points, Values
from omote.geometry.skinning import skin
from omote.model.body.hinges import BENDS, HINGES
from omote.model.body.posed_bones import PosedBones, pose_bones
from omote.model.body.skeleton import Skeleton
from omote.model.body.stand import stand_turns
from tools.baking.heads.basemesh import Ints

REACH = {"lowerarm01": 0.11, "lowerleg01": 0.15}
"""Metres around a hinge of the generic body (1.67 m) within which its rows have correctives."""
FULL = 0.99
"""Of its volume as modelled, what a bent limb keeps: all of it makes ridges (body.md, section 4)."""
APART = 0.0004
"""Metres that the skin of each segment stays off the plane between both."""
STEP = 15.0
"""Degrees from one solve to the next."""
ROUNDS = 5
"""Of rotations and places in each."""
LEAST = 0.05
"""Of a cotangent: none pushes rows apart."""
HOLD = 20.0
"""How stiff the plane is, in the mean stiffness of a row."""


@dataclass(frozen=True, eq=False)
class Hinge:
    """Where the rows of one hinge lie. rows (n,): those that have correctives, then the ring (n + r,) that holds them;
    free: n; triangles (t, 3): places among the rows; closed (c, 3): these and fans over their borders."""

    names: tuple[str, ...]
    rows: Ints
    free: int
    triangles: Ints
    closed: Ints


@dataclass(frozen=True, eq=False)
class Skinning:
    """skeleton; bones, weights (R, 8), shares (R,): as of `FigureSpace`."""

    skeleton: Skeleton
    bones: Ints
    weights: Singles
    shares: Singles


def find_hinges(skinning: Skinning, joints: Points, generic: Points, triangles: Ints) -> list[Hinge]:
    """The rows around each elbow and knee. joints (J, 3), generic (R, 3): of the generic figure, metres; triangles: of
    figures, without parts of skirts."""
    found = []
    names = skinning.skeleton.names
    for hinge in HINGES:
        kind, side = hinge[1].split(".")
        part = kind.removeprefix("lower")[:3]
        near = np.linalg.norm(generic - joints[skinning.skeleton.places[hinge[1]]], axis=1) < REACH[kind]
        of = {
            where: np.array([name.startswith(f"{where}{part}") and name.endswith(side) for name in names])
            for where in ("upper", "lower")
        }
        share = {where: (skinning.weights * chosen[skinning.bones]).sum(axis=1) for where, chosen in of.items()}
        own = near & (share["upper"] + share["lower"] > 0.9) & np.isin(np.arange(len(generic)), triangles)
        touching = triangles[own[triangles].any(axis=1)]
        ring = np.setdiff1d(touching, np.flatnonzero(own))
        rows = np.concatenate([np.flatnonzero(own), ring])
        place = np.full(len(generic), -1)
        place[rows] = np.arange(len(rows))
        patch = place[touching]
        found.append(Hinge(hinge, rows, int(own.sum()), patch, np.concatenate([patch, *_lids(patch)])))
    return found


def _lids(triangles: Ints) -> list[Ints]:
    """Fans (r - 2, 3) that close a patch at each of its borders."""
    known = {(int(a), int(b)) for triangle in triangles for a, b in zip(triangle, np.roll(triangle, -1), strict=True)}
    after = {b: a for a, b in known if (b, a) not in known}
    lids = []
    while after:
        loop = [next(iter(after))]
        while loop[-1] in after:
            loop.append(after.pop(loop[-1]))
        lids.append(np.array([[loop[0], one, two] for one, two in pairwise(loop[1:-1])]))
    return lids


def bend_hinge(skeleton: Skeleton, joints: Points, stand: Values, names: tuple[str, ...], angle: float) -> PosedBones:
    """The bones of a body that stands with one hinge bent so far from straight. joints (J, 3), stand (J, 3, 3): of the
    body; names: of the hinge; angle: degrees."""
    way = -1.0 if names[1].startswith("lowerarm") else 1.0
    turns = np.zeros((len(joints), 3))
    at = [skeleton.places[name] for name in names]
    posed = pose_bones(skeleton, joints, stand, turns, np.zeros(3))
    for _ in range(4):
        upper = posed.joints[at[1]] - posed.joints[at[0]]
        lower = posed.joints[at[2]] - posed.joints[at[1]]
        bent = np.arctan2(way * np.cross(upper, lower)[0], upper @ lower)
        turns[at[1], 0] += way * (np.radians(angle) - bent)
        posed = pose_bones(skeleton, joints, stand, turns, np.zeros(3))
    return posed


def solve_hinge(hinge: Hinge, skinning: Skinning, rows: Points, joints: Points, ends: Points) -> Values:
    """The correctives (len(BENDS), n, 3) of one hinge of a body, metres, to be added to its rows as modelled.

    rows (R, 3), joints (J, 3), ends (J, 3): of the body as modelled.
    """
    rest = rows[hinge.rows]
    stand = stand_turns(skinning.skeleton, joints, ends)
    elastic = _elastic(rest, hinge.triangles, hinge.free)
    off = np.zeros((hinge.free, 3))
    full = _volume(rest, hinge.closed)
    middle, _, normal = _plane(hinge, skinning, joints)
    side = np.where((rest - middle)[: hinge.free] @ normal < 0.0, -1.0, 1.0)
    found = []
    angles = np.arange(STEP, BENDS[-1] + STEP, STEP)
    for angle in np.union1d(angles[angles <= BENDS[-1]], BENDS):
        bones = bend_hinge(skinning.skeleton, joints, stand, hinge.names, float(angle))
        moved, turns = _skinned(hinge, skinning, rest, joints, bones)
        start = moved.copy()
        start[: hinge.free] += np.einsum("nab,nb->na", turns[: hinge.free], off)
        solved = _solve(hinge, elastic, start, side, _plane(hinge, skinning, bones.joints), FULL * full)
        off = np.asarray(np.linalg.solve(turns[: hinge.free], (solved - moved)[: hinge.free, :, None])[..., 0], float)
        if angle in BENDS:
            found.append(off)
    return np.stack(found)


def _skinned(
    hinge: Hinge, skinning: Skinning, rest: Points, joints: Points, bones: PosedBones
) -> tuple[Points, Values]:
    """The rows as skinning has them, and how each answers to a move of it as modelled (n, 3, 3)."""
    at = hinge.rows
    row_bones = skinning.bones[at]
    weights = skinning.weights[at]
    shares = skinning.shares[at]

    def move(points: Points) -> Points:
        return skin(points, row_bones, weights, shares, bones.turns, bones.shifts(joints))

    moved = move(rest)
    answers = np.stack([move(rest + step) - moved for step in np.eye(3)], axis=2)
    return moved, answers


def _plane(hinge: Hinge, skinning: Skinning, joints: Points) -> Values:
    """The joint, the way to the inner side of the bend, and the normal of the plane that halves it, towards the upper
    segment, (3, 3)."""
    begin, middle, end = (joints[skinning.skeleton.places[name]] for name in hinge.names)
    upper = _unit(begin - middle)
    lower = _unit(end - middle)
    return np.stack([middle, _unit(upper + lower), _unit(upper - lower)])


def _unit(way: Values) -> Values:
    return np.asarray(way / np.linalg.norm(way))


@dataclass(frozen=True, eq=False)
class Elastic:
    """The skin around a hinge as modelled. i, j (e,): the rows of each edge, both ways; w (e,): its cotangent; edges
    (e, 3): from j to i; spread (n, e): sums over the edges of each row; held (f, n - f): what the ring pulls; answer
    (f, f): the inverse of the stiffness of the free rows; stiff: the mean of a row."""

    i: Ints
    j: Ints
    w: Values
    edges: Points
    spread: csr_array
    held: Values
    answer: Values
    stiff: float


def _elastic(rest: Points, triangles: Ints, free: int) -> Elastic:
    """Cotangents of each pair of rows, none below a little."""
    weights = np.zeros((len(rest), len(rest)))
    for corner in range(3):
        a, b, c = (triangles[:, (corner + step) % 3] for step in range(3))
        one = rest[b] - rest[a]
        two = rest[c] - rest[a]
        cotangents = (one * two).sum(axis=1) / np.linalg.norm(np.cross(one, two), axis=1)
        np.add.at(weights, (b, c), 0.5 * cotangents)
        np.add.at(weights, (c, b), 0.5 * cotangents)
    weights = np.where(weights != 0.0, np.maximum(weights, LEAST), 0.0)
    i, j = (places.astype(np.int32) for places in np.nonzero(weights))
    laplacian = np.diag(weights.sum(axis=1)) - weights
    spread = csr_array((np.ones(len(i)), (i, np.arange(len(i)))), shape=(len(rest), len(i)))
    answer = np.asarray(np.linalg.inv(laplacian[:free, :free]), np.float64)
    held = laplacian[:free, free:]
    stiff = float(np.diag(laplacian).mean())
    return Elastic(i, j, weights[i, j], rest[i] - rest[j], spread, held, answer, stiff)


def _volume(points: Points, triangles: Ints) -> float:
    """Signed, of what closed triangles bound, cubic metres."""
    a, b, c = (points[triangles[:, corner]] - points[0] for corner in range(3))
    return float((a * np.cross(b, c)).sum() / 6.0)


def _pressure(points: Points, triangles: Ints) -> Values:
    """By how much each row's way changes the volume, (n, 3)."""
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a) / 6.0
    gradient = np.zeros_like(points)
    for corner in range(3):
        np.add.at(gradient, triangles[:, corner], normals)
    return gradient


def _solve(hinge: Hinge, elastic: Elastic, start: Points, side: Values, plane: Values, full: float) -> Points:
    """Where the rows come to; the ring stays. side (f,): -1 beyond the plane, else 1;
    full: cubic metres that they are to hold."""
    free = hinge.free
    points = start.copy()
    middle, inner, normal = plane
    for _ in range(ROUNDS):
        pull = elastic.spread @ _pulls(elastic, points)
        right = pull[:free] - elastic.held @ points[free:]
        depth = side * ((points[:free] - middle) @ normal)
        crossing = np.flatnonzero((depth < APART) & ((points[:free] - middle) @ inner > 0.0)).astype(np.int32)
        wanted = points[crossing] + ((APART - depth) * side)[crossing, None] * normal
        right[crossing] += HOLD * elastic.stiff * wanted
        push = _pressure(points, hinge.closed)[:free]
        given = _answer(elastic, crossing, np.concatenate([right, push], axis=1))
        points[:free] = given[:, :3]
        missing = full - _volume(points, hinge.closed)
        if missing > 0.0:
            points[:free] += missing / float((push * given[:, 3:]).sum()) * given[:, 3:]
    return points


def _answer(elastic: Elastic, crossing: Ints, right: Values) -> Values:
    """What the free rows do under forces (f, k), those that cross the plane held (Woodbury's formula)."""
    free = elastic.answer @ right
    if len(crossing) == 0:
        return np.asarray(free)
    columns = elastic.answer[:, crossing]
    inside = columns[crossing] + np.eye(len(crossing)) / (HOLD * elastic.stiff)
    return np.asarray(free - columns @ np.linalg.solve(inside, free[crossing]))


def _pulls(elastic: Elastic, points: Points) -> Points:
    """What each edge pulls at its row, (e, 3): as modelled, turned as the rows of both its ends are."""
    now = points[elastic.i] - points[elastic.j]
    products = (elastic.w[:, None] * elastic.edges)[:, :, None] * now[:, None, :]
    u, _, v = np.linalg.svd((elastic.spread @ products.reshape(-1, 9)).reshape(-1, 3, 3))
    v[:, 2] *= np.linalg.det(u @ v)[:, None]
    turns = np.swapaxes(u @ v, 1, 2)
    halfway = 0.5 * elastic.w[:, None, None] * (turns[elastic.i] + turns[elastic.j])
    return np.asarray((halfway @ elastic.edges[:, :, None])[..., 0])
