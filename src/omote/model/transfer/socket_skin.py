"""Finds the lining of the eye sockets, the inner skin that hangs together behind the lids (docs/method.md, "Lining of
the sockets")."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Floats, Indices, Mask, Values
from omote.geometry import mesh
from omote.geometry.proximity import cast_level_rays, nearest_triangles, winding_numbers
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import find_behind, measure_distance
from omote.model.weak_cache import weakly_cached, weakly_cached_with

# The lining lies at least as deep as on the generic face, but at most so deep, metres; what is deeper than FAR_METRES
# there never comes near the skin. With neighbours that go along, linings of narrow eyes come out behind the other lid.
DEEP_METRES = 0.0026
FAR_METRES = 0.008
# Nearer to the lids along the mesh, metres, it is their rim, which they may turn out.
RIM_METRES = 0.001
# Skin so far from the lining, metres, is before it.
COVER_METRES = 0.02


@dataclass(frozen=True, eq=False)
class SocketLining:
    """The lining of a space's eye sockets, seams welded.

    vertices (m,); skin (s, 3): the sheet's triangles near it; least (m,): how far behind them it lies on every face,
    metres, minus infinity where that is not asked; hidden (m,): behind the rims of the lids and near the skin; region
    (k,): the lining and the skin near it.
    """

    vertices: Indices
    skin: Indices
    least: Values
    hidden: Mask
    region: Indices


@weakly_cached
def find_socket_lining(space: ParameterSpace, /) -> SocketLining | None:
    """The lining of a space's sockets, remembered as long as it lives; None where no lids are named."""
    lids = [space.welded[line.loop] for line in space.lines if line.kind == "lids"]
    corners = space.welded[space.triangles]
    behind_lids = [find_behind(corners, ~space.on_sheet, loop) for loop in lids]
    vertices = np.unique(np.concatenate([*behind_lids, np.zeros(0, np.int32)])).astype(np.int32)
    if len(vertices) == 0:
        return None
    triangles = corners[np.isin(corners, vertices).any(axis=1)].astype(np.int32)
    middle = space.points[space.sheet_triangles].mean(axis=1)
    low = space.points[vertices].min(axis=0) - COVER_METRES
    high = space.points[vertices].max(axis=0) + COVER_METRES
    skin = space.sheet_triangles[((middle > low) & (middle < high)).all(axis=1)]
    depth, _ = measure_depth_behind(space, skin, vertices, space.points)
    hidden = measure_distance(space, triangles, vertices) > RIM_METRES
    hidden &= depth < FAR_METRES
    least = np.where(hidden & (depth > 0.0), np.minimum(depth, DEEP_METRES), -np.inf)
    return SocketLining(vertices, skin, least, hidden, np.unique(np.concatenate([vertices, skin.ravel()])))


def measure_depth_behind(
    space: ParameterSpace, skin: Indices, vertices: Indices, positions: Values, /
) -> tuple[Values, Values]:
    """How far behind the nearest skin each vertex lies, (m,) metres, less than zero out of it, and the way in.

    space: the space of the generic head; vertices: (m,) rows; positions: (V, 3), metres.
    """
    corners = np.ascontiguousarray(positions[skin])
    points = np.ascontiguousarray(positions[vertices])
    away, at = nearest_triangles(corners, points)
    normal = mesh.unit_normals(corners[at])
    before = np.flatnonzero(((points - corners[at, 0]) * normal).sum(axis=1) > 0)
    closed = np.ascontiguousarray(positions[space.location_triangles])
    out = before[winding_numbers(closed, points[before]) < 0.5]  # in creases the nearest triangle may look elsewhere
    depth = away.copy()
    depth[out] *= -1.0
    return depth, -normal


# Skin so far before a vertex, metres, may cover it; it may have come out of skin so far behind it.
BEFORE_METRES = 0.01
# Skin that a ray meets at a smaller cosine says little of what lies behind it.
LEAST_COSINE = 0.2
# What has moved by less, metres, is at rest.
STILL_METRES = 1e-4
PUSH_ROUNDS = 4
EXACT = 1e-5
# What is pushed back goes so far behind the skin, metres: edges between vertices would come out of bent skin.
BEHIND_METRES = 0.0001


def measure_out(space: ParameterSpace, lining: SocketLining, positions: Values, /) -> tuple[Values, Values]:
    """How far the hidden vertices of a lining have come out of the foremost skin of positions (V, 3), (h,) metres along
    its normal, less than zero behind it, minus infinity where no skin is met; and the ways in (h, 3). Skin that looks
    away is met as well: a lid's edge that is seen through the opening.

    space: the space of the generic head.
    """
    points = positions[lining.vertices[lining.hidden]]
    ahead = space.cylinder.outward(points)
    far, at = cast_level_rays(positions, lining.skin, points + BEFORE_METRES * ahead, -ahead)
    normal = mesh.unit_normals(positions[lining.skin[at]])
    cosine = (normal * ahead).sum(axis=1)
    met = (far < 2.0 * BEFORE_METRES) & (np.abs(cosine) > LEAST_COSINE)
    return np.where(met, (far - BEFORE_METRES) * np.abs(cosine), -np.inf), -normal * np.sign(cosine)[:, None]


def fit_socket_lining(space: ParameterSpace, face: Face, positions: Floats, /) -> Floats:
    """A face's compound (V, 3) with the lining of its sockets behind its skin; the generic face's own is the source
    and stays.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    lining = find_socket_lining(space)
    if lining is None or np.array_equal(face.positions, space.points.astype(np.float32)):
        return positions
    if np.abs(positions[lining.region] - face.positions[lining.region]).max() < STILL_METRES:
        return positions
    hidden = lining.vertices[lining.hidden]
    allowed = _limit_out(space, face)
    result = positions.astype(np.float64)
    for _ in range(PUSH_ROUNDS):
        out, inward = measure_out(space, lining, result)
        push = np.where(out > allowed + EXACT, out - allowed + BEHIND_METRES, 0.0)
        if not push.any():
            break
        result[hidden] += push[:, None] * inward
    return np.asarray(result[space.welded], np.float32) if (result != positions).any() else positions


@weakly_cached_with
def _limit_out(space: ParameterSpace, face: Face) -> Values:
    """How far the lining of a face may be before the skin: as far as at rest, (h,) metres."""
    lining = find_socket_lining(space)
    assert lining is not None
    return np.maximum(measure_out(space, lining, face.positions.astype(np.float64))[0], 0.0)
