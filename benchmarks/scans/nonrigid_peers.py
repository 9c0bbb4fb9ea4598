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
Steps = list[list[float]] | None
AMBERG = "nricp_amberg"
SUMNER = "nricp_sumner"
PEERS: Mapping[str, Callable[..., Values]] = {
    AMBERG: trimesh.registration.nricp_amberg, SUMNER: trimesh.registration.nricp_sumner
}  # fmt: skip
# The peers' own settings, then looser ones: the looser, the nearer to the surface and the more is folded.
SETTINGS: Mapping[str, Mapping[str, Steps]] = {
    AMBERG: {
        "default": None,
        "looser": [[0.02, 3, 0.5, 10], [0.01, 3, 0.5, 10], [0.005, 0, 0.5, 10]],
        "loose": [[0.02, 3, 0.5, 10], [0.007, 3, 0.5, 10], [0.002, 0, 0.5, 10], [0.0005, 0, 0.5, 10]],
    },
    SUMNER: {
        "default": None,
        "looser": [
            [1, 0.001, 1, 1000, 0],
            [10, 0.001, 1, 1000, 0],
            [100, 0.001, 1, 1000, 0],
            [1000, 0.001, 1, 1000, 0],
        ],
        "loose": [[0, 0.1, 2, 10, 0], [2, 0.1, 1, 10, 0], [10, 0.1, 0.5, 10, 0], [100, 0.1, 0.1, 10, 0]],
    },
}


def register(
    space: ParameterSpace, peer: str, steps: Steps, surface: tuple[Values, NDArray[np.integer]],
    clicks: Mapping[str, Values], /,
) -> tuple[Values, float]:  # fmt: skip
    """The sheet's vertices (V, 3) as a peer brings them to a surface in metres (n, 3), (t, 3), and its seconds of this
    thread; steps: its settings, for which the head is of size one."""
    points, triangles = surface
    named = find_landmarks(space)
    rows = np.array([named[name] for name in clicks])
    places = np.array([*clicks.values()])
    used, sheet = np.unique(space.sheet_triangles, return_inverse=True)
    start = fit_similarity(space.points[rows], places, np.ones(len(rows)))(space.points)
    unit = float(np.ptp(points, axis=0).max())
    source = trimesh.Trimesh(start[used] / unit, sheet.reshape(-1, 3), process=False)
    target = trimesh.Trimesh(points / unit, triangles, process=False)
    begin = thread_time()
    moved = PEERS[peer](
        source, target, source_landmarks=np.searchsorted(used, rows), target_positions=places / unit, steps=steps
    )  # fmt: skip
    seconds = thread_time() - begin
    result = np.array(start)
    result[used] = unit * np.asarray(moved)
    return result, seconds
