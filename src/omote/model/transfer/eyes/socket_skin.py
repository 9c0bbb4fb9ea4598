"""Finds the lining of the eye sockets, the inner skin that hangs together behind the lids (docs/method.md, "Lining of
the sockets")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import find_behind, measure_distance

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

# The lining lies at least as deep as on the generic face, but at most so deep, metres; what is deeper than FAR there
# never comes near the skin. With neighbours that go along, linings of narrow eyes come out behind the other lid.
DEEP, FAR = 0.0026, 0.008
# Nearer to the lids along the mesh, metres, it is their rim, which they may turn out.
RIM = 0.001
# Skin so far from the lining, metres, is before it.
REACH = 0.02


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
    hidden: NDArray[np.bool_]
    region: Indices


_linings: WeakKeyDictionary[ParameterSpace, tuple[SocketLining, ...]] = WeakKeyDictionary()


def find_socket_lining(space: ParameterSpace, /) -> SocketLining | None:
    """The lining of a space's sockets, remembered as long as it lives; None where no lids are named."""
    if space not in _linings:
        _linings[space] = tuple(_search(space))
    return next(iter(_linings[space]), None)


def _search(space: ParameterSpace) -> Sequence[SocketLining]:
    lids = [space.welded[line.loop] for line in space.lines if line.kind == "lids"]
    corners = space.welded[space.triangles]
    found = [find_behind(corners, ~space.on_sheet, loop) for loop in lids]
    vertices = np.unique(np.concatenate([*found, np.zeros(0, np.int32)])).astype(np.int32)
    if len(vertices) == 0:
        return ()
    triangles = corners[np.isin(corners, vertices).any(axis=1)].astype(np.int32)
    middle = space.points[space.sheet_triangles].mean(axis=1)
    low, high = space.points[vertices].min(axis=0) - REACH, space.points[vertices].max(axis=0) + REACH
    skin = space.sheet_triangles[((middle > low) & (middle < high)).all(axis=1)]
    depth, _ = measure_depth_behind(space, skin, vertices, space.points)
    hidden = measure_distance(space, triangles, vertices) > RIM
    hidden &= depth < FAR
    least = np.where(hidden & (depth > 0.0), np.minimum(depth, DEEP), -np.inf)
    return (SocketLining(vertices, skin, least, hidden, np.unique(np.concatenate([vertices, skin.ravel()]))),)


def measure_depth_behind(
    space: ParameterSpace, skin: Indices, vertices: Indices, positions: Values, /
) -> tuple[Values, Values]:
    """How far behind the nearest skin each vertex lies, (m,) metres, less than zero out of it, and the way in."""
    corners, points = np.ascontiguousarray(positions[skin]), np.ascontiguousarray(positions[vertices])
    away, at = nearest_triangles(corners, points)
    normal = mesh.unit_normals(corners[at])
    before = np.flatnonzero(((points - corners[at, 0]) * normal).sum(axis=1) > 0)
    closed = np.ascontiguousarray(positions[space.location_triangles])
    out = before[winding_numbers(closed, points[before]) < 0.5]  # in creases the nearest triangle may look elsewhere
    depth = away.copy()
    depth[out] *= -1.0
    return depth, -normal
