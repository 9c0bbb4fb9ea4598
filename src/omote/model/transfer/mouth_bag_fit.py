"""Pushes the mouth bag behind the skin of a compound (docs/method.md, "Mouth bag").

Rays from the cylinder's axis find how deep each vertex lies; what is not deep enough is projected along the skin's
normal, its neighbours with it. Rays along the skin say little: there the winding number says what is out, and the
nearest triangle how far. The depth that is required does not depend on the expression, so a compound stays linear
in its residual where nothing comes out.
"""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.proximity import cast_level_rays, measure_outside, nearest_triangles, winding_numbers
from omote.geometry.ramp import smooth_ramp
from omote.model.space.eye_socket import fall_off
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import MouthBag, find_mouth_bag
from omote.model.transfer.paper_map import project_to_surface

Floats = NDArray[np.float32]
Values = NDArray[np.float64]
Rows = NDArray[np.intp] | slice

ALL = slice(None)
NONE = np.zeros(0, np.int64)
_limits: WeakKeyDictionary[Face, tuple[ParameterSpace, Values]] = WeakKeyDictionary()

# How far behind the skin the bag stays, where it is as far behind it on the generic face at rest, metres; less toward
# the lips, nothing at them and in full beyond FREE along the mesh.
MARGIN, FREE = 0.0015, 0.014
# Beside the corners of the mouth, up to the first of CORNER metres from them and less up to the second, the same more
# strictly: the skin is bent most there, and straight edges between vertices that are behind it would come out of it;
# each compound of a sum takes some of that depth.
CORNER, CORNER_MARGIN, CORNER_FREE = (0.012, 0.022), 0.004, 0.008
# A push spreads over so many rings, from one to the next this share of it, less what a vertex is deeper than wanted:
# who lies deep enough stays, for behind it are teeth. Then what is still outside by more than EXACT is pushed again.
RINGS, SHARE, ROUNDS, EXACT = 4, 0.75, 12, 1e-6
# What has moved by less, metres, is at rest.
STILL = 1e-5
# Skin that the ray from the axis only grazes, cosines below MET, says little of what lies behind it: the bag may lie
# SLACK metres in front of it where it is parallel to the ray, less toward MET.
MET, SLACK = 0.2, 0.02
# Where the ray meets skin that is turned away or only grazed, what lies so far before the vertex, metres, may cover it.
BEFORE = 0.01
# What is outside by less than the first, metres, is so at rest too; what is by more than the second is between lips
# that have passed each other, which no bag mends.
OUT, PASSED = 0.0003, 0.004
# The same beside the lips, where skin is bent so much that a ray from the axis meets none, or another layer of it.
OUT_AT_RIM, PASSED_AT_RIM = 0.00002, 0.001


@dataclass(frozen=True, eq=False)
class Depths:
    """How far behind the skin each vertex of a bag lies: depth (m,) metres along the skin's normal, less than zero in
    front; more where the skin is only grazed; inward (m, 3): the way to go deeper; doubtful (m,): in front of the plane
    of skin that is only grazed."""

    depth: Values
    inward: Values
    doubtful: NDArray[np.bool_]


def measure_depths(space: ParameterSpace, bag: MouthBag, positions: Values, /, rows: Rows = ALL) -> Depths:
    """The depths of a bag behind the sheet of positions (V, 3), seen from the cylinder's axis; rows (r,): of these of
    its vertices alone."""
    points = positions[bag.vertices[rows]]
    landing = project_to_surface(space, positions, points, bag.starts[rows])
    corners = positions[space.location_triangles[landing.triangles]]
    surface = (landing.weights[..., None] * corners).sum(axis=1)
    normal = mesh.unit_normals(corners)
    ahead = space.cylinder.outward(points)
    met = (ahead * normal).sum(axis=1)
    _find_foremost(bag, positions, points, ahead, surface, normal, met)
    grazed = np.maximum(MET - met, 0.0) / MET
    depth = ((surface - points) * normal).sum(axis=1)
    doubtful = landing.inside & (grazed > 0) & (depth < 0)
    return Depths(np.where(landing.inside, depth + SLACK * grazed, np.inf), -normal, doubtful)


def _find_foremost(
    bag: MouthBag, positions: Values, points: Values, ahead: Values, surface: Values, normal: Values, met: Values
) -> None:
    """Puts the foremost skin on the rays of points (m, 3) in place of what was met from behind or grazed, where it
    is met squarely: lips cover each other, and a walk along the skin ends at any of the layers."""
    rows = np.flatnonzero(met < MET)
    if len(rows) == 0:
        return
    around = np.concatenate([bag.skin, bag.membranes])
    far, at = cast_level_rays(positions, around, points[rows] + BEFORE * ahead[rows], -ahead[rows])
    across = mesh.unit_normals(positions[around[at]])
    squarely = (ahead[rows] * across).sum(axis=1)
    found = (far < 2.0 * BEFORE) & (squarely >= MET)
    rows = rows[found]
    surface[rows] = points[rows] + (BEFORE - far[found])[:, None] * ahead[rows]
    normal[rows], met[rows] = across[found], squarely[found]


def require_depths(space: ParameterSpace, bag: MouthBag, /) -> Values:
    """How far behind the skin of any face the bag has to lie, (m,) metres."""
    depth = np.maximum(measure_depths(space, bag, space.points).depth, 0.0)
    everywhere = (1.0 - fall_off(bag.distance / FREE)) * np.minimum(depth, MARGIN)
    beside = (1.0 - fall_off(bag.distance / CORNER_FREE)) * np.minimum(depth, CORNER_MARGIN)
    share = 1.0 - smooth_ramp(*CORNER, _measure_to_corners(space, bag))
    result: Values = np.maximum(everywhere, share * beside)
    return result


def _measure_to_corners(space: ParameterSpace, bag: MouthBag) -> Values:
    """How far the bag's vertices are from the nearer corner of the mouth on the generic face, (m,) metres."""
    lips = next(space.points[line.loop] for line in space.lines if line.kind == "lips")
    corners = lips[[lips[:, 0].argmin(), lips[:, 0].argmax()]]
    away: Values = np.linalg.norm(space.points[bag.vertices, None] - corners, axis=2).min(axis=1)
    return away


def missing_depths(wanted: Values, here: Depths, /) -> Values:
    """How much deeper a bag has to lie, (m,) metres, to be as far behind the skin as wanted (m,)."""
    result: Values = np.maximum(wanted - here.depth, 0.0)
    return result


def push_inside(
    space: ParameterSpace, bag: MouthBag, wanted: Values, positions: Values, rim: NDArray[np.int64] = NONE, /
) -> Values:  # fmt: skip
    """Where the bag of positions (V, 3) goes, (m, 3), to lie as far behind the skin as wanted (m,), and rows of its rim
    not outside of the nearest skin or membrane.

    Each round projects what is not deep enough along the skin's normal, its neighbours with it as far as they have no
    depth to spare, so no dent is left.
    """
    result, here = positions.copy(), measure_depths(space, bag, positions)
    for _ in range(ROUNDS):
        push, inward = _push_doubtful(bag, result, here, missing_depths(wanted, here))
        push, inward = _push_rim(bag, result, push, inward, rim)
        if push.max() < EXACT:
            break
        spare = np.maximum(here.depth - wanted, 0.0)
        for _ in range(RINGS):
            push = np.maximum(push, SHARE * push[bag.neighbours].max(axis=1) - spare)
        result[bag.vertices] += push[:, None] * inward
        moved = np.flatnonzero(push)  # the skin stays, so does what was found of all others
        _put(here, moved, measure_depths(space, bag, result, moved))
    placed: Values = result[bag.vertices]
    return placed


def _put(here: Depths, rows: Rows, found: Depths) -> None:
    """Puts what was found of some vertices in place of what was known of them."""
    here.depth[rows], here.inward[rows], here.doubtful[rows] = found.depth, found.inward, found.doubtful


def _push_doubtful(bag: MouthBag, positions: Values, here: Depths, push: Values) -> tuple[Values, Values]:
    """Pushes (m,) and their ways (m, 3), with those of doubtful vertices that are outside: to the nearest skin, no
    deeper, so that none jumps as it comes out."""
    rows = np.flatnonzero(here.doubtful & (push <= 0))
    if len(rows) == 0:
        return push, here.inward
    corners, points = positions[np.concatenate([bag.skin, bag.membranes])], positions[bag.vertices[rows]]
    away, nearest = nearest_triangles(corners, points, PASSED)  # first, for a winding number is dearer
    near = np.flatnonzero((nearest >= 0) & (nearest < len(bag.skin)) & (away > OUT))
    # The skin around alone: a half behind it, less by one before it.
    out = near[winding_numbers(corners, points[near]) < 0]
    push, inward = push.copy(), here.inward.copy()
    push[rows[out]] = away[out] - OUT
    inward[rows[out]] = -mesh.unit_normals(corners[nearest[out]])
    return push, inward


def _push_rim(
    bag: MouthBag, positions: Values, push: Values, inward: Values, rim: NDArray[np.int64]
) -> tuple[Values, Values]:  # fmt: skip
    """Pushes (m,) and their ways (m, 3), with those of rows of the rim that are outside: to the nearest surface."""
    if len(rim) == 0:
        return push, inward
    away, back = measure_outside(positions[bag.around], positions[bag.vertices[rim]], PASSED_AT_RIM)
    farther = away - OUT_AT_RIM > push[rim]
    if not farther.any():
        return push, inward
    push, inward, rows = push.copy(), inward.copy(), rim[farther]
    push[rows], inward[rows] = away[farther] - OUT_AT_RIM, back[farther]
    return push, inward


def fit_mouth_bag(space: ParameterSpace, face: Face, positions: Floats, /) -> Floats:
    """A face's compound (V, 3) with the mouth bag behind its skin; the generic face's own is the source and stays."""
    bag = find_mouth_bag(space)
    if bag is None or np.array_equal(face.positions, space.points.astype(np.float32)):
        return positions
    if _is_at_rest(bag, positions, face.positions):
        return positions
    wanted = limit_depths(space, face, bag)
    return place_bag(space, bag, positions, push_inside(space, bag, wanted, positions.astype(np.float64), bag.rim))


def keep_bag_inside(space: ParameterSpace, displacement: Values, /) -> Values:
    """A displacement of the generic skin (V, 3) with the mouth bag as far behind the moved skin as on any face.

    A unit whose bag comes out of the generic face's skin would come out of every face's in each sum, where none pushes.
    """
    bag = find_mouth_bag(space)
    if bag is None:
        return displacement
    result = displacement.copy()
    moved = push_inside(space, bag, require_depths(space, bag), space.points + displacement)
    result[bag.vertices] = moved - space.points[bag.vertices]
    welded: Values = result[space.welded]
    return welded


def fit_mouth_bag_at_rest(space: ParameterSpace, positions: Floats, /) -> Floats:
    """A new face at rest (V, 3) with the mouth bag as far behind its skin as on the generic face."""
    bag = find_mouth_bag(space)
    if bag is None:
        return positions
    return place_bag(
        space, bag, positions, push_inside(space, bag, require_depths(space, bag), positions.astype(np.float64))
    )


def measure_shallow(space: ParameterSpace, positions: Floats, /) -> float:
    """By how much the mouth bag of a face at rest (V, 3) lies less deep than wanted, where most, metres."""
    bag = find_mouth_bag(space)
    if bag is None:
        return 0.0
    here = measure_depths(space, bag, positions.astype(np.float64))
    return float(missing_depths(require_depths(space, bag), here).max())


def _is_at_rest(bag: MouthBag, positions: Floats, rest: Floats) -> bool:
    """Whether neither the bag nor the skin over it has moved by STILL: then it is as far inside as at rest."""
    return bool(np.abs(positions[bag.region] - rest[bag.region]).max() < STILL)


def place_bag(space: ParameterSpace, bag: MouthBag, positions: Floats, placed: Values, /) -> Floats:
    """Positions (V, 3) with the bag at placed (m, 3), on both sides of its seams."""
    rows = np.flatnonzero(bag.rows >= 0)
    result = positions.copy()
    result[space.inner.vertices[rows]] = placed[bag.rows[rows]]
    return result


def limit_depths(space: ParameterSpace, face: Face, bag: MouthBag, /) -> Values:
    """How far behind the skin of a face the bag has to lie, (m,) metres: no farther than it does at rest."""
    known = _limits.get(face)
    if known is None or known[0] is not space:
        wanted = require_depths(space, bag)
        known = (space, wanted - missing_depths(wanted, measure_depths(space, bag, face.positions.astype(np.float64))))
        _limits[face] = known
    return known[1]
