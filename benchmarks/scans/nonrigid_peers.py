"""Both of trimesh's non-rigid registrations: from the generic head, placed by the same landmarks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from time import thread_time

import numpy as np
import trimesh
from numpy.typing import NDArray

from omote.model.fitting.landmarks import find_landmarks
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import fit_similarity

Values = NDArray[np.float64]
PEERS: Mapping[str, Callable[..., Values]] = {
    "nricp_amberg": trimesh.registration.nricp_amberg, "nricp_sumner": trimesh.registration.nricp_sumner
}  # fmt: skip


def register(
    space: ParameterSpace, peer: str, points: Values, triangles: NDArray[np.integer], clicks: Mapping[str, Values], /
) -> tuple[Values, float]:  # fmt: skip
    """The sheet's vertices (V, 3) as a peer brings them to a surface in metres (n, 3), (t, 3), and its seconds; with
    its default settings, in its own unit of length."""
    named = find_landmarks(space)
    rows, places = np.array([named[name] for name in clicks]), np.array([*clicks.values()])
    used, sheet = np.unique(space.sheet_triangles, return_inverse=True)
    start = fit_similarity(space.points[rows], places, np.ones(len(rows)))(space.points)
    unit = float(np.ptp(points, axis=0).max())
    source = trimesh.Trimesh(start[used] / unit, sheet.reshape(-1, 3), process=False)
    target = trimesh.Trimesh(points / unit, triangles, process=False)
    begin = thread_time()
    moved = PEERS[peer](
        source, target, source_landmarks=np.searchsorted(used, rows), target_positions=places / unit
    )  # fmt: skip
    seconds = thread_time() - begin
    result = np.array(start)
    result[used] = unit * np.asarray(moved)
    return result, seconds
