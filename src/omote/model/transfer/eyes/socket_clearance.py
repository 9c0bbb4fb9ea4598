"""Pushes the lining of the eye sockets behind the skin of a compound (docs/method.md, "Lining of the sockets").

Rays from the cylinder's axis find the foremost skin before each vertex, as what is seen is what lies before it: where
lids cover each other the nearest skin may be either. What has come out further than at rest goes back along the skin's
normal.
"""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.proximity import cast_level_rays
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.eyes.socket_skin import SocketLining, find_socket_lining

Floats = NDArray[np.float32]
Values = NDArray[np.float64]

# Skin so far before a vertex, metres, may cover it; it may have come out of skin so far behind it.
BEFORE = 0.01
# Skin that a ray meets at a smaller cosine says little of what lies behind it.
MET = 0.2
# What has moved by less, metres, is at rest.
STILL = 1e-4
ROUNDS, EXACT = 4, 1e-5
# What is pushed back goes so far behind the skin, metres: edges between vertices would come out of bent skin.
BEHIND = 0.0001

_allowed: WeakKeyDictionary[Face, tuple[ParameterSpace, Values]] = WeakKeyDictionary()


def measure_out(space: ParameterSpace, lining: SocketLining, positions: Values, /) -> tuple[Values, Values]:
    """How far the hidden vertices of a lining have come out of the foremost skin of positions (V, 3), (h,) metres along
    its normal, less than zero behind it, minus infinity where no skin is met; and the ways in (h, 3). Skin that looks
    away is met as well: a lid's edge that is seen through the opening."""
    points = positions[lining.vertices[lining.hidden]]
    ahead = space.cylinder.outward(points)
    far, at = cast_level_rays(positions, lining.skin, points + BEFORE * ahead, -ahead)
    normal = mesh.unit_normals(positions[lining.skin[at]])
    cosine = (normal * ahead).sum(axis=1)
    met = (far < 2.0 * BEFORE) & (np.abs(cosine) > MET)
    return np.where(met, (far - BEFORE) * np.abs(cosine), -np.inf), -normal * np.sign(cosine)[:, None]


def fit_socket_lining(space: ParameterSpace, face: Face, positions: Floats, /) -> Floats:
    """A face's compound (V, 3) with the lining of its sockets behind its skin; the generic face's own is the source
    and stays."""
    lining = find_socket_lining(space)
    if lining is None or np.array_equal(face.positions, space.points.astype(np.float32)):
        return positions
    if np.abs(positions[lining.region] - face.positions[lining.region]).max() < STILL:
        return positions
    hidden, allowed, result = (
        lining.vertices[lining.hidden],
        _limit_out(space, face, lining),
        positions.astype(np.float64),
    )
    for _ in range(ROUNDS):
        out, inward = measure_out(space, lining, result)
        push = np.where(out > allowed + EXACT, out - allowed + BEHIND, 0.0)
        if not push.any():
            break
        result[hidden] += push[:, None] * inward
    return np.asarray(result[space.welded], np.float32) if (result != positions).any() else positions


def _limit_out(space: ParameterSpace, face: Face, lining: SocketLining) -> Values:
    """How far the lining of a face may be before the skin: as far as at rest, (h,) metres."""
    known = _allowed.get(face)
    if known is None or known[0] is not space:
        out, _ = measure_out(space, lining, face.positions.astype(np.float64))
        known = _allowed[face] = (space, np.maximum(out, 0.0))
    return known[1]
