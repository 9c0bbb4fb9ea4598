"""Keeps the lining of the eye sockets behind the skin of a face at rest (docs/method.md, "Lining of the sockets").

The lining is the inner skin that hangs together behind the lids. In a squint the cheek comes up and the lining with it,
by up to 2 mm toward the skin: on a face whose lining lies as deep as on the generic one it stays behind, and nothing
has to be done for it in a compound.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats, Values
from omote.geometry import mesh
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.socket_skin import SocketLining, find_socket_lining, measure_depth_behind

# One that is put in order goes so many times as deep: units take more on some faces than on the generic one.
SPARE = 1.25
PUSH_ROUNDS = 12
EXACT = 1e-6
# A face whose lining lies less than this too shallow, metres, keeps it.
SHALLOW_METRES = 0.0002


def measure_lining(space: ParameterSpace, lining: SocketLining, positions: NDArray[np.floating], /) -> Values:
    """How much deeper the lining of positions (V, 3) has to lie, (m,) metres. space: the space of the generic head."""
    asked = np.flatnonzero(np.isfinite(lining.least))
    result = np.zeros(len(lining.vertices))
    depth, _ = measure_depth_behind(space, lining.skin, lining.vertices[asked], positions.astype(np.float64))
    result[asked] = np.maximum(lining.least[asked] - depth, 0.0)
    return result


def fit_lining_at_rest(space: ParameterSpace, positions: Floats, /) -> Floats:
    """A new face at rest (V, 3) with the lining of its sockets as far behind its skin as on the generic face, and
    a little more.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    lining = find_socket_lining(space)
    if lining is None or measure_lining(space, lining, positions).max() <= SHALLOW_METRES:
        return positions
    asked = np.flatnonzero(np.isfinite(lining.least))
    vertices = lining.vertices[asked]
    wanted = SPARE * lining.least[asked]
    result = positions.astype(np.float64)
    for _ in range(PUSH_ROUNDS):
        depth, inward = measure_depth_behind(space, lining.skin, vertices, result)
        push = np.maximum(wanted - depth, 0.0)
        if push.max() < EXACT:
            break
        result[vertices] += push[:, None] * inward
    return np.asarray(result[space.welded], np.float32) if (result != positions).any() else positions


def mend_lining(space: ParameterSpace, face: Face, /) -> Face:
    """A face with the lining of its sockets in order; itself where that is so. space: the space of the generic head."""
    positions = _tuck_rims(space, fit_lining_at_rest(space, face.positions))
    return face if positions is face.positions else replace(face, positions=positions)


def _tuck_rims(space: ParameterSpace, positions: Floats) -> Floats:
    """A face at rest (V, 3) with rims of lids that have come through the skin of a lid put behind it; out through the
    eye's opening they may be."""
    lining = find_socket_lining(space)
    if lining is None:
        return positions
    result = positions.astype(np.float64)
    rims = lining.vertices[~lining.hidden]
    corners = result[space.location_triangles]
    away, at = nearest_triangles(corners, result[rims])
    rows = np.flatnonzero((at < len(space.sheet_triangles)) & (away > SHALLOW_METRES))
    out = rows[winding_numbers(corners, result[rims[rows]]) < 0.5]
    result[rims[out]] -= (away[out] + SHALLOW_METRES)[:, None] * mesh.unit_normals(corners[at[out]])
    return np.asarray(result[space.welded], np.float32) if len(out) else positions
