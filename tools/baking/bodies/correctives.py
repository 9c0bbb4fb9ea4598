"""Solves what skinning makes wrong of a bent elbow, knee or finger, on each body: skin as rigid as it can be, apart,
and full.

From the skin as modelled on, step by step, each from the last: as rigid as possible (O. Sorkine, M. Alexa, 2007), under
a pressure that keeps the volume, and kept on its own side of the plane through the joint that halves the angle.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.sparse import csr_array

from omote.arrays import Floats as Singles
from omote.arrays import Mask, Points, Values
from omote.geometry.skinning import skin
from omote.model.body.correctives import FINGER_BENDS, FINGERS, HINGE_BENDS, HINGES
from omote.model.body.posed_bones import PosedBones, pose_bones
from omote.model.body.skeleton import Skeleton
from omote.model.body.stand import OUT, stand_turns
from tools.baking.heads.basemesh import Ints

REACH = {"lowerarm01": 0.11, "lowerleg01": 0.15}
"""Metres around a hinge of the generic body (1.67 m) within which its rows have correctives."""
FINGER_REACH = (0.0234, 0.018, 0.018)
"""As much around the joints of a finger, from the knuckle on; a row is of the nearest."""
FULL = 0.99
"""Of its volume as modelled, what a bent limb keeps: all of it makes ridges (body.md, section 4)."""
APART = 0.0004
"""Metres that the skin of each segment stays off the plane between both."""
STEP = 15.0
"""Degrees from one solve of an elbow or a knee to the next; fingers go from one corrective to the next."""
ROUNDS = 5
"""Of rotations and places in each."""
LEAST = 0.05
"""Of a cotangent: none pushes rows apart."""
HOLD = 20.0
"""How stiff the plane is, in the mean stiffness of a row."""
FINGER_HOLD = 2.0
"""As much of a finger: fists of kaori have 62 triangles turned over, with the other 111, without correctives 393."""


@dataclass(frozen=True, eq=False)
class Skinning:
    """skeleton; bones, weights (R, 8), shares (R,): as of `FigureSpace`."""

    skeleton: Skeleton
    bones: Ints
    weights: Singles
    shares: Singles


@dataclass(frozen=True, eq=False)
class Patch:
    """Where the rows of one joint lie. rows (n,): those that have correctives, then the ring (n + r,) that holds them;
    free: n; triangles (t, 3): places among the rows."""

    rows: Ints
    free: int
    triangles: Ints


@dataclass(frozen=True, eq=False)
class Hinge:
    """A joint that bends about one axis. names: of the bone before it, of the one that bends, and of the one at whose
    beginning that ends, empty where it ends itself; patch: of it; closed (c, 3): the patch and fans over its borders;
    bends, steps: degrees at which correctives are kept, and solved; hold: how stiff the plane is."""

    names: tuple[str, str, str]
    patch: Patch
    closed: Ints
    bends: tuple[float, ...]
    steps: tuple[float, ...]
    hold: float


def find_patch(own: Mask, triangles: Ints) -> Patch:
    """The patch of some rows (R,) of a figure. triangles: of figures, without parts of skirts."""
    touching = triangles[own[triangles].any(axis=1)]
    ring = np.setdiff1d(touching, np.flatnonzero(own))
    rows = np.concatenate([np.flatnonzero(own), ring])
    place = np.full(len(own), -1)
    place[rows] = np.arange(len(rows))
    return Patch(rows, int(own.sum()), place[touching])


def find_hinges(skinning: Skinning, joints: Points, generic: Points, triangles: Ints) -> list[Hinge]:
    """Each elbow, knee and joint of a finger, in the order of `omote.model.body.correctives`.

    joints (J, 3), generic (R, 3): of the generic figure, metres; triangles: of figures, without parts of skirts.
    """
    drawn = np.isin(np.arange(len(generic)), triangles)
    angles = (*np.arange(STEP, HINGE_BENDS[-1], STEP).tolist(), *HINGE_BENDS)
    steps = tuple(sorted({*angles}))
    found = []
    for begin, bone, end in HINGES:
        patch = find_patch(drawn & _around_limb(bone, skinning, joints, generic), triangles)
        closed = np.concatenate([patch.triangles, *_lids(patch.triangles)])
        found.append(Hinge((begin, bone, end), patch, closed, HINGE_BENDS, steps, HOLD))
    nearest = _nearest_knuckle(skinning, joints, generic)
    for place, (before, bone) in enumerate(FINGERS):
        patch = find_patch(drawn & (nearest == place), triangles)
        closed = np.concatenate([patch.triangles, *_lids(patch.triangles)])
        found.append(Hinge((before, bone, ""), patch, closed, FINGER_BENDS, FINGER_BENDS, FINGER_HOLD))
    return found


def _around_limb(bone: str, skinning: Skinning, joints: Points, generic: Points) -> Mask:
    """The rows (R,) near an elbow or a knee that are of its limb."""
    kind, side = bone.split(".")
    part = kind.removeprefix("lower")[:3]
    names = skinning.skeleton.names
    near = np.linalg.norm(generic - joints[skinning.skeleton.places[bone]], axis=1) < REACH[kind]
    limb = [name.startswith((f"upper{part}", f"lower{part}")) and name.endswith(side) for name in names]
    return np.asarray(near & (share_of(skinning, np.array(limb)) > 0.9))


def _nearest_knuckle(skinning: Skinning, joints: Points, generic: Points) -> Ints:
    """Which joint of `FINGERS` is nearest to each row (R,) of a hand that is in its reach; -1 for none."""
    names = skinning.skeleton.names
    hand = np.array([name.startswith(("metacarpal", "finger")) and not name.startswith("finger1") for name in names])
    places = joints[[skinning.skeleton.places[bone] for _, bone in FINGERS]]
    reach = np.array([FINGER_REACH[int(bone[8]) - 1] for _, bone in FINGERS])
    away = np.linalg.norm(generic[:, None] - places, axis=2)
    nearest = away.argmin(axis=1)
    within = away[np.arange(len(away)), nearest] < reach[nearest]
    return np.where(within & (share_of(skinning, hand) > 0.6), nearest, -1).astype(np.int32)


def share_of(skinning: Skinning, chosen: Mask) -> Values:
    """How much of each row's move (R,) some bones (J,) make."""
    return np.asarray((skinning.weights * chosen[skinning.bones]).sum(axis=1))


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
    return [lid for lid in lids if len(lid)]


def bend_hinge(
    skeleton: Skeleton, joints: Points, stand: Values, names: tuple[str, str, str], angle: float
) -> PosedBones:
    """The bones of a body that stands with one hinge bent so far: an elbow or a knee from straight, a finger from
    where it was modelled. joints (J, 3), stand (J, 3, 3): of the body; names: of the hinge; angle: degrees."""
    turns = np.zeros((len(joints), 3))
    if not names[2]:
        turns[skeleton.places[names[1]], 2] = -OUT[names[1][-1]] * np.radians(angle)
        return pose_bones(skeleton, joints, stand, turns, np.zeros(3))
    way = -1.0 if names[1].startswith("lowerarm") else 1.0
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
    """The correctives (SHAPES, n, 3) of one hinge of a body, metres, to be added to its rows as modelled.

    rows (R, 3), joints (J, 3), ends (J, 3): of the body as modelled.
    """
    patch = hinge.patch
    rest = rows[patch.rows]
    stand = stand_turns(skinning.skeleton, joints, ends)
    elastic = elastic_of(rest, patch)
    off = np.zeros((patch.free, 3))
    full = _volume(rest, hinge.closed)
    middle, _, normal = _plane(hinge, skinning.skeleton, joints, ends)
    side = np.where((rest - middle)[: patch.free] @ normal < 0.0, -1.0, 1.0)
    found = []
    for angle in hinge.steps:
        bones = bend_hinge(skinning.skeleton, joints, stand, hinge.names, angle)
        moved, turns = skinned(patch, skinning, rest, joints, bones)
        start = moved.copy()
        start[: patch.free] += np.einsum("nab,nb->na", turns, off)
        tips = bones.joints + np.einsum("jab,jb->ja", bones.turns, ends - joints)
        plane = _plane(hinge, skinning.skeleton, bones.joints, tips)
        solved = _solve(hinge, elastic, start, side, plane, FULL * full)
        off = np.asarray(np.linalg.solve(turns, (solved - moved)[: patch.free, :, None])[..., 0], float)
        if angle in hinge.bends:
            found.append(off)
    return np.stack(found)


def skinned(patch: Patch, skinning: Skinning, rest: Points, joints: Points, bones: PosedBones) -> tuple[Points, Values]:
    """The rows (n + r, 3) of a patch as skinning has them, and how each of the first n answers to a move of it as
    modelled (n, 3, 3). rest (n + r, 3), joints (J, 3): as modelled; bones: in a pose."""
    at = patch.rows
    row_bones = skinning.bones[at]
    weights = skinning.weights[at]
    shares = skinning.shares[at]

    def move(points: Points) -> Points:
        return skin(points, row_bones, weights, shares, bones.turns, bones.shifts(joints))

    moved = move(rest)
    answers = np.stack([move(rest + step) - moved for step in np.eye(3)], axis=2)
    return moved, answers[: patch.free]


def _plane(hinge: Hinge, skeleton: Skeleton, joints: Points, ends: Points) -> Values:
    """The joint, the way to the inner side of the bend, and the normal of the plane that halves it, towards the upper
    segment, (3, 3)."""
    before, bone, last = hinge.names
    middle = joints[skeleton.places[bone]]
    end = joints[skeleton.places[last]] if last else ends[skeleton.places[bone]]
    upper = unit(joints[skeleton.places[before]] - middle)
    lower = unit(end - middle)
    return np.stack([middle, unit(upper + lower), unit(upper - lower)])


def unit(way: Values) -> Values:
    """A direction (3,) of unit length; nothing of what is nothing: a straight limb has no inner side."""
    return np.asarray(way / max(float(np.linalg.norm(way)), 1e-6))


@dataclass(frozen=True, eq=False)
class Elastic:
    """The skin around a joint as modelled. i, j (e,): the rows of each edge, both ways; w (e,): its cotangent; edges
    (e, 3): from j to i; spread (n, e): sums over the edges of each row; held (f, n - f): what the ring pulls;
    stiffness (f, f): of the free rows; stiff: the mean of a row."""

    i: Ints
    j: Ints
    w: Values
    edges: Points
    spread: csr_array
    held: Values
    stiffness: Values
    stiff: float

    @cached_property
    def answer(self) -> Values:
        """The inverse (f, f) of the stiffness."""
        return np.asarray(np.linalg.inv(self.stiffness), np.float64)


def elastic_of(rest: Points, patch: Patch) -> Elastic:
    """A patch as modelled, (n + r, 3): the cotangents of each pair of its rows, none below a little."""
    triangles = patch.triangles
    free = patch.free
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
    held = laplacian[:free, free:]
    stiff = float(np.diag(laplacian).mean())
    return Elastic(i, j, weights[i, j], rest[i] - rest[j], spread, held, laplacian[:free, :free], stiff)


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
    free = hinge.patch.free
    points = start.copy()
    middle, inner, normal = plane
    for _ in range(ROUNDS):
        pull = elastic.spread @ _pulls(elastic, points)
        right = pull[:free] - elastic.held @ points[free:]
        depth = side * ((points[:free] - middle) @ normal)
        crossing = np.flatnonzero((depth < APART) & ((points[:free] - middle) @ inner > 0.0)).astype(np.int32)
        wanted = points[crossing] + ((APART - depth) * side)[crossing, None] * normal
        right[crossing] += hinge.hold * elastic.stiff * wanted
        push = _pressure(points, hinge.closed)[:free]
        given = _answer(elastic, hinge.hold, crossing, np.concatenate([right, push], axis=1))
        points[:free] = given[:, :3]
        missing = full - _volume(points, hinge.closed)
        points[:free] += missing / float((push * given[:, 3:]).sum()) * given[:, 3:]
    return points


def _answer(elastic: Elastic, hold: float, crossing: Ints, right: Values) -> Values:
    """What the free rows do under forces (f, k), those that cross the plane held (Woodbury's formula)."""
    free = elastic.answer @ right
    if len(crossing) == 0:
        return np.asarray(free)
    columns = elastic.answer[:, crossing]
    inside = columns[crossing] + np.eye(len(crossing)) / (hold * elastic.stiff)
    return np.asarray(free - columns @ np.linalg.solve(inside, free[crossing]))


def _pulls(elastic: Elastic, points: Points) -> Points:
    """What each edge pulls at its row, (e, 3): as modelled, turned as the rows of both its ends are."""
    now = points[elastic.i] - points[elastic.j]
    products = (elastic.w[:, None] * elastic.edges)[:, :, None] * now[:, None, :]
    u, _, v = np.linalg.svd((elastic.spread @ products.reshape(-1, 9)).reshape(-1, 3, 3))
    v[:, 2] *= np.linalg.det(u @ v)[:, None]
    turns = np.swapaxes(u @ v, 1, 2)
    return edges_turned(elastic, turns)


def edges_turned(elastic: Elastic, turns: Values) -> Points:
    """What each edge pulls at its row, (e, 3): as modelled, turned by the mean of the turns (n, 3, 3) of its ends."""
    halfway = 0.5 * elastic.w[:, None, None] * (turns[elastic.i] + turns[elastic.j])
    return np.asarray((halfway @ elastic.edges[:, :, None])[..., 0])
