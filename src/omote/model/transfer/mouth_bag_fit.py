"""Pushes the mouth bag behind the skin of a compound (docs/method.md, "Mouth bag").

Rays from the cylinder's axis find how deep each vertex lies; what is not deep enough is projected along the skin's
normal, its neighbours with it. Rays along the skin say little: there the winding number says what is out, and the
nearest triangle how far. The depth that is required does not depend on the expression, so a compound stays linear
in its residual where nothing comes out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats, Mask, Rows, Values
from omote.geometry import mesh
from omote.geometry.proximity import cast_level_rays, measure_outside, nearest_triangles, winding_numbers
from omote.geometry.ramp import smooth_ramp
from omote.model.space.eye_socket import fall_off
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import MouthBag, find_mouth_bag
from omote.model.transfer.paper_map import project_to_surface
from omote.model.weak_cache import weakly_cached_with

BagRows = Rows | slice

ALL = slice(None)
NONE = np.zeros(0, np.int64)

# How far behind the skin the bag stays, where it is as far behind it on the generic face at rest, metres; less toward
# the lips, nothing at them and in full beyond FREE_METRES along the mesh.
MARGIN_METRES = 0.0015
FREE_METRES = 0.014
# Beside the corners of the mouth, up to the first of CORNER_METRES from them and less up to the second, the same more
# strictly: the skin is bent most there, and straight edges between vertices that are behind it would come out of it;
# each compound of a sum takes some of that depth.
CORNER_METRES = (0.012, 0.022)
CORNER_MARGIN = 0.004
CORNER_FREE = 0.008
# A push spreads over so many rings, from one to the next this share of it, less what a vertex is deeper than wanted:
# who lies deep enough stays, for behind it are teeth. Then what is still outside by more than EXACT is pushed again.
RINGS = 4
SHARE = 0.75
PUSH_ROUNDS = 12
EXACT = 1e-6
# What has moved by less, metres, is at rest.
STILL_METRES = 1e-5
# Skin that the ray from the axis only grazes, cosines below LEAST_COSINE, says little of what lies behind it: the bag
# may lie SLACK_METRES in front of it where it is parallel to the ray, less toward LEAST_COSINE.
LEAST_COSINE = 0.2
SLACK_METRES = 0.02
# Where the ray meets skin that is turned away or only grazed, what lies so far before the vertex, metres, may cover it.
BEFORE_METRES = 0.01
# What is outside by less than the first, metres, is so at rest too; what is by more than the second is between lips
# that have passed each other, which no bag mends.
OUT_METRES = 0.0003
PASSED_METRES = 0.004
# The same beside the lips, where skin is bent so much that a ray from the axis meets none, or another layer of it.
OUT_AT_RIM = 0.00002
PASSED_AT_RIM = 0.001


@dataclass(frozen=True, eq=False)
class Depths:
    """How far behind the skin each vertex of a bag lies: depth (m,) metres along the skin's normal, less than zero in
    front; more where the skin is only grazed; inward (m, 3): the way to go deeper; doubtful (m,): in front of the plane
    of skin that is only grazed."""

    depth: Values
    inward: Values
    doubtful: Mask


def measure_depths(space: ParameterSpace, bag: MouthBag, positions: Values, /, rows: BagRows = ALL) -> Depths:
    """The depths of a bag behind the sheet of positions (V, 3), seen from the cylinder's axis; rows (r,): of these of
    its vertices alone.

    space: the space of the generic head.
    """
    points = positions[bag.vertices[rows]]
    landing = project_to_surface(space, positions, points, bag.starts[rows])
    corners = positions[space.location_triangles[landing.triangles]]
    surface = (landing.weights[..., None] * corners).sum(axis=1)
    normal = mesh.unit_normals(corners)
    ahead = space.cylinder.outward(points)
    met = (ahead * normal).sum(axis=1)
    _find_foremost(bag, positions, points, ahead, surface, normal, met)
    grazed = np.maximum(LEAST_COSINE - met, 0.0) / LEAST_COSINE
    depth = ((surface - points) * normal).sum(axis=1)
    doubtful = landing.inside & (grazed > 0) & (depth < 0)
    return Depths(np.where(landing.inside, depth + SLACK_METRES * grazed, np.inf), -normal, doubtful)


def _find_foremost(
    bag: MouthBag, positions: Values, points: Values, ahead: Values, surface: Values, normal: Values, met: Values
) -> None:
    """Puts the foremost skin on the rays of points (m, 3) in place of what was met from behind or grazed, where it
    is met squarely: lips cover each other, and a walk along the skin ends at any of the layers."""
    rows = np.flatnonzero(met < LEAST_COSINE)
    if len(rows) == 0:
        return
    around = np.concatenate([bag.skin, bag.membranes])
    far, at = cast_level_rays(positions, around, points[rows] + BEFORE_METRES * ahead[rows], -ahead[rows])
    across = mesh.unit_normals(positions[around[at]])
    squarely = (ahead[rows] * across).sum(axis=1)
    squarely_met = (far < 2.0 * BEFORE_METRES) & (squarely >= LEAST_COSINE)
    rows = rows[squarely_met]
    surface[rows] = points[rows] + (BEFORE_METRES - far[squarely_met])[:, None] * ahead[rows]
    normal[rows] = across[squarely_met]
    met[rows] = squarely[squarely_met]


def require_depths(space: ParameterSpace, bag: MouthBag, /) -> Values:
    """How far behind the skin of any face the bag has to lie, (m,) metres. space: the space of the generic head."""
    depth = np.maximum(measure_depths(space, bag, space.points).depth, 0.0)
    everywhere = (1.0 - fall_off(bag.distance / FREE_METRES)) * np.minimum(depth, MARGIN_METRES)
    beside = (1.0 - fall_off(bag.distance / CORNER_FREE)) * np.minimum(depth, CORNER_MARGIN)
    share = 1.0 - smooth_ramp(*CORNER_METRES, _measure_to_corners(space, bag))
    return np.maximum(everywhere, share * beside)


def _measure_to_corners(space: ParameterSpace, bag: MouthBag) -> Values:
    """How far the bag's vertices are from the nearer corner of the mouth on the generic face, (m,) metres."""
    lips = next(space.points[line.loop] for line in space.lines if line.kind == "lips")
    corners = lips[[lips[:, 0].argmin(), lips[:, 0].argmax()]]
    return np.linalg.norm(space.points[bag.vertices, None] - corners, axis=2).min(axis=1)


def missing_depths(wanted: Values, here: Depths, /) -> Values:
    """How much deeper a bag has to lie, (m,) metres, to be as far behind the skin as wanted (m,).

    here: where the bag lies now.
    """
    return np.maximum(wanted - here.depth, 0.0)


def push_inside(
    space: ParameterSpace, bag: MouthBag, wanted: Values, positions: Values, rim: NDArray[np.int64] = NONE, /
) -> Values:
    """Where the bag of positions (V, 3) goes, (m, 3), to lie as far behind the skin as wanted (m,), and rows of its rim
    not outside of the nearest skin or membrane.

    space: the space of the generic head.

    Each round projects what is not deep enough along the skin's normal, its neighbours with it as far as they have no
    depth to spare, so no dent is left.
    """
    result = positions.copy()
    here = measure_depths(space, bag, positions)
    for _ in range(PUSH_ROUNDS):
        push = missing_depths(wanted, here)
        inward = here.inward.copy()
        _push_doubtful(bag, result, np.flatnonzero(here.doubtful & (push <= 0)), push, inward)
        _push_rim(bag, result, rim, push, inward)
        if push.max() < EXACT:
            break
        spare = np.maximum(here.depth - wanted, 0.0)
        for _ in range(RINGS):
            push = np.maximum(push, SHARE * push[bag.neighbours].max(axis=1) - spare)
        result[bag.vertices] += push[:, None] * inward
        moved = np.flatnonzero(push)  # the skin stays, so does what was found of all others
        _put(here, moved, measure_depths(space, bag, result, moved))
    return result[bag.vertices]


def _put(here: Depths, rows: BagRows, new: Depths) -> None:
    """Puts what was found of some vertices in place of what was known of them."""
    here.depth[rows], here.inward[rows], here.doubtful[rows] = new.depth, new.inward, new.doubtful


def _push_doubtful(bag: MouthBag, positions: Values, rows: Rows, push: Values, inward: Values) -> None:
    """Puts into pushes (m,) and their ways (m, 3) those of doubtful rows that are outside: to the nearest skin, no
    deeper, so that none jumps as it comes out."""
    if len(rows) == 0:
        return
    corners = positions[np.concatenate([bag.skin, bag.membranes])]
    points = positions[bag.vertices[rows]]
    away, nearest = nearest_triangles(corners, points, PASSED_METRES)  # first, for a winding number is dearer
    near = np.flatnonzero((nearest >= 0) & (nearest < len(bag.skin)) & (away > OUT_METRES))
    # The skin around alone: a half behind it, less by one before it.
    out = near[winding_numbers(corners, points[near]) < 0]
    push[rows[out]] = away[out] - OUT_METRES
    inward[rows[out]] = -mesh.unit_normals(corners[nearest[out]])


def _push_rim(bag: MouthBag, positions: Values, rim: NDArray[np.int64], push: Values, inward: Values) -> None:
    """Puts into pushes (m,) and their ways (m, 3) those of rows of the rim that are outside: to the nearest surface."""
    if len(rim) == 0:
        return
    away, back = measure_outside(positions[bag.around], positions[bag.vertices[rim]], PASSED_AT_RIM)
    farther = away - OUT_AT_RIM > push[rim]
    rows = rim[farther]
    push[rows] = away[farther] - OUT_AT_RIM
    inward[rows] = back[farther]


def fit_mouth_bag(space: ParameterSpace, face: Face, positions: Floats, /) -> Floats:
    """A face's compound (V, 3) with the mouth bag behind its skin; the generic face's own is the source and stays.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    bag = find_mouth_bag(space)
    if bag is None or np.array_equal(face.positions, space.points.astype(np.float32)):
        return positions
    if _is_at_rest(bag, positions, face.positions):
        return positions
    wanted = limit_depths(space, face)
    return place_bag(space, bag, positions, push_inside(space, bag, wanted, positions.astype(np.float64), bag.rim))


def fit_mouth_bag_at_rest(space: ParameterSpace, positions: Floats, /) -> Floats:
    """A new face at rest (V, 3) with the mouth bag as far behind its skin as on the generic face.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    bag = find_mouth_bag(space)
    if bag is None:
        return positions
    return place_bag(
        space, bag, positions, push_inside(space, bag, require_depths(space, bag), positions.astype(np.float64))
    )


def measure_shallow(space: ParameterSpace, positions: Floats, /) -> float:
    """By how much the mouth bag of a face at rest (V, 3) lies less deep than wanted, where most, metres.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    bag = find_mouth_bag(space)
    if bag is None:
        return 0.0
    here = measure_depths(space, bag, positions.astype(np.float64))
    return float(missing_depths(require_depths(space, bag), here).max())


def _is_at_rest(bag: MouthBag, positions: Floats, rest: Floats) -> bool:
    """Whether neither the bag nor the skin over it has moved by STILL_METRES: then it is as far inside as at rest."""
    return bool(np.abs(positions[bag.region] - rest[bag.region]).max() < STILL_METRES)


def place_bag(space: ParameterSpace, bag: MouthBag, positions: Floats, placed: Values, /) -> Floats:
    """Positions (V, 3) with the bag at placed (m, 3), on both sides of its seams.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    rows = np.flatnonzero(bag.rows >= 0)
    result = positions.copy()
    result[space.inner.vertices[rows]] = placed[bag.rows[rows]]
    return result


@weakly_cached_with
def limit_depths(space: ParameterSpace, face: Face, /) -> Values:
    """How far behind the skin of a face the bag has to lie, (m,) metres: no farther than it does at rest.

    space: the space of the generic head.
    """
    bag = find_mouth_bag(space)
    assert bag is not None
    wanted = require_depths(space, bag)
    return wanted - missing_depths(wanted, measure_depths(space, bag, face.positions.astype(np.float64)))
