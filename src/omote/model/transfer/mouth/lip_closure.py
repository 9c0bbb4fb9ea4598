"""Closes the lips of a face at rest where one can look through between them (docs/method.md, "Lips at rest")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from omote.geometry import mesh
from omote.geometry.ramp import smooth_ramp
from omote.model.space.lid_lip_lines import chains
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
Indices = NDArray[np.int64]

# Skin within REACH metres of the lips' line, along the mesh, goes along, by less and less.
REACH = 0.012
# Places along the mouth at which one looks through, and the pitches from which, radians.
STATIONS = 41
PITCHES = (-0.35, 0.0, 0.35)
# The skin behind closed lips overlaps by so much, metres; what is nearer than MET meets.
PRESS, MET = 0.0002, 0.00002
ROUNDS = 20


@dataclass(frozen=True, eq=False)
class _Lips:
    """corners (2,): those of the mouth; upper, lower (e, 2): edges of the lips; side (V,): how far a vertex goes
    with the upper (+) or the lower lip (-); behind (V,): the same of inner skin, none of the sheet."""

    corners: Indices
    upper: Indices
    lower: Indices
    side: Values
    behind: Values


def close_lips(space: ParameterSpace, positions: NDArray[np.floating], /) -> Values:
    """Positions of a face at rest (V, 3) whose lips meet all along the mouth: both give way by half, upward and
    downward; who has them closed keeps them. Where no lips are named the positions come back as they are.

    The sheet moves until lips meet as seen from the front and no further; that of the generic face is S, one layer in
    which no lip may cover the other, and stays. What can be looked through behind it, inner skin closes.
    """
    result, lips = positions.astype(np.float64), _find_lips(space)
    if lips is not None and not np.array_equal(positions, space.points.astype(positions.dtype)):
        _close(lips, result, lips.side, (0.0,), 0.0)
    return close_behind_lips(space, result)


def close_behind_lips(space: ParameterSpace, positions: NDArray[np.floating], /) -> Values:
    """Positions of a face at rest (V, 3) with the inner skin behind closed lips, and it alone, where nobody looks
    through from above, below or ahead."""
    result, lips = positions.astype(np.float64), _find_lips(space)
    if lips is not None:
        _close(lips, result, lips.behind, PITCHES, PRESS)
    return result


def _close(lips: _Lips, positions: Values, side: Values, pitches: Sequence[float], press: float) -> None:
    """Moves what goes with a lip, by its side (V,), until nobody looks through from these pitches, in place; a press
    goes beyond that, beside a gap too."""
    for _ in range(ROUNDS):
        across, gaps = _look_through(lips, positions, pitches)
        if not gaps.any():
            return
        wanted = np.where(gaps > 0.0, gaps + press, 0.0)
        if press:
            beside = np.pad(wanted, 1)
            wanted = np.maximum(wanted, 0.5 * (beside[2:] + beside[:-2]))
        positions[:, 1] -= 0.5 * side * np.interp(positions[:, 0], across, wanted, left=0.0, right=0.0)


def measure_slits(space: ParameterSpace, positions: NDArray[np.floating], /) -> Values:
    """How far one can look through between the lips of positions (V, 3), metres, at places along the mouth."""
    lips = _find_lips(space)
    if lips is None:
        raise ValueError("the space names no lips; expected the built-in cast's")
    return _look_through(lips, positions.astype(np.float64), PITCHES)[1]


_found: WeakKeyDictionary[ParameterSpace, tuple[_Lips, ...]] = WeakKeyDictionary()


def _find_lips(space: ParameterSpace) -> _Lips | None:
    """The lips of a space, remembered as long as it lives; None where none are named."""
    if space not in _found:
        lines = [line for line in space.lines if line.kind == "lips"]
        _found[space] = tuple(_search(space, space.welded[line.loop]) for line in lines[:1])
    return next(iter(_found[space]), None)


def _search(space: ParameterSpace, loop: NDArray[np.int32]) -> _Lips:
    edges = mesh.edges(space.welded[space.triangles]).astype(np.int64)
    lengths = np.linalg.norm(space.points[edges[:, 0]] - space.points[edges[:, 1]], axis=1)
    graph = coo_array((lengths, (edges[:, 0], edges[:, 1])), shape=(space.vertex_count, space.vertex_count)).tocsr()
    halves = chains(space.points, loop)
    up, down = (
        dijkstra(graph, directed=False, indices=half[1:-1], min_only=True, limit=2.0 * REACH)[space.welded]
        for half in halves
    )
    share = 1.0 - smooth_ramp(0.0, REACH, np.minimum(np.minimum(up, down), REACH))
    side = np.where(up < down, share, np.where(down < up, -share, 0.0))
    ends = np.array([halves[0][0], halves[0][-1]], np.int64)
    behind = np.where(space.on_sheet, 0.0, side)
    return _Lips(ends, edges[(side[edges] > 0).all(axis=1)], edges[(side[edges] < 0).all(axis=1)], side, behind)


def _look_through(lips: _Lips, positions: Values, pitches: Sequence[float]) -> tuple[Values, Values]:
    """Places along the mouth, x, and how far the lips are apart there, whatever pitch one looks from; zero: they
    meet."""
    right, left = np.sort(positions[lips.corners, 0])
    across = right + (left - right) * (np.arange(STATIONS) + 0.5) / STATIONS
    gaps = np.zeros(STATIONS)
    for pitch in pitches:
        height = np.cos(pitch) * positions[:, 1] + np.sin(pitch) * positions[:, 2]
        low = -_highest(positions[:, 0], -height, lips.upper, across)
        gaps = np.maximum(gaps, low - _highest(positions[:, 0], height, lips.lower, across))
    return across, np.where(gaps > MET, gaps, 0.0)


def _highest(x: Values, height: Values, edges: Indices, across: Values) -> Values:
    """The greatest height of edges at each x; minus infinity where none is."""
    one, other = edges.T
    rise = x[other] - x[one]
    share = (across[:, None] - x[one]) / np.where(np.abs(rise) < 1e-9, 1e-9, rise)
    there = height[one] + share * (height[other] - height[one])
    return np.asarray(np.where((share >= 0.0) & (share <= 1.0), there, -np.inf).max(axis=1))
