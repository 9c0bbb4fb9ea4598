"""Keeps the lining of the eye sockets behind the skin of a face at rest (docs/method.md, "Lining of the sockets").

The lining is the inner skin that hangs together behind the lids. In a squint the cheek comes up and the lining with it,
by up to 2 mm toward the skin: on a face whose lining lies as deep as on the generic one it stays behind, and nothing
has to be done for it in a compound.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import find_behind, measure_distance

Floats = NDArray[np.float32]
Values = NDArray[np.float64]
Indices = NDArray[np.int32]

# The lining lies at least as deep as on the generic face, but at most so deep, metres; what is deeper than FAR there
# never comes near the skin. With neighbours that go along, linings of narrow eyes come out behind the other lid.
DEEP, FAR = 0.0026, 0.008
# One that is put in order goes so many times as deep: units take more on some faces than on the generic one.
SPARE = 1.25
# Nearer to the lids along the mesh, metres, it is their rim, which they may turn out.
RIM = 0.001
# Skin so far from the lining, metres, is before it.
REACH = 0.02
ROUNDS, EXACT = 12, 1e-6
# A face whose lining lies less than this too shallow, metres, keeps it.
SHALLOW = 0.0002


@dataclass(frozen=True, eq=False)
class SocketLining:
    """The lining of a space's eye sockets, seams welded.

    vertices (m,); skin (s, 3): the sheet's triangles near it; least (m,): how far behind them it lies on every face,
    metres, minus infinity where that is not asked.
    """

    vertices: Indices
    skin: Indices
    least: Values


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
    depth, _ = _measure(space, skin, vertices, space.points)
    asked = (measure_distance(space, triangles, vertices) > RIM) & (depth > 0.0) & (depth < FAR)
    return (SocketLining(vertices, skin, np.where(asked, np.minimum(depth, DEEP), -np.inf)),)


def _measure(space: ParameterSpace, skin: Indices, vertices: Indices, positions: Values) -> tuple[Values, Values]:
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


def measure_lining(space: ParameterSpace, lining: SocketLining, positions: NDArray[np.floating], /) -> Values:
    """How much deeper the lining of positions (V, 3) has to lie, (m,) metres."""
    asked = np.flatnonzero(np.isfinite(lining.least))
    result = np.zeros(len(lining.vertices))
    depth, _ = _measure(space, lining.skin, lining.vertices[asked], positions.astype(np.float64))
    result[asked] = np.maximum(lining.least[asked] - depth, 0.0)
    return result


def fit_lining_at_rest(space: ParameterSpace, positions: Floats, /) -> Floats:
    """A new face at rest (V, 3) with the lining of its sockets as far behind its skin as on the generic face, and
    a little more."""
    lining = find_socket_lining(space)
    if lining is None or measure_lining(space, lining, positions).max() <= SHALLOW:
        return positions
    asked = np.flatnonzero(np.isfinite(lining.least))
    vertices, wanted, result = lining.vertices[asked], SPARE * lining.least[asked], positions.astype(np.float64)
    for _ in range(ROUNDS):
        depth, inward = _measure(space, lining.skin, vertices, result)
        push = np.maximum(wanted - depth, 0.0)
        if push.max() < EXACT:
            break
        result[vertices] += push[:, None] * inward
    return np.asarray(result[space.welded], np.float32) if (result != positions).any() else positions


def mend_lining(space: ParameterSpace, face: Face, /) -> Face:
    """A face with the lining of its sockets in order; itself where that is so."""
    positions = fit_lining_at_rest(space, face.positions)
    return face if positions is face.positions else replace(face, positions=positions)
