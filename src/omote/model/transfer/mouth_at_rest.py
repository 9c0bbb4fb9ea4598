"""The mouth of a new face at rest: lips that meet, a bag that meets the gums and stays inside the head."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import dijkstra

from omote.arrays import Floats, Rows, Values
from omote.geometry import mesh
from omote.geometry.ramp import smooth_ramp
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.lid_lip_lines import chains
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.gum_line import GumLine, find_gum_line, measure_gums, meet_gums
from omote.model.transfer.mouth_bag_fit import fit_mouth_bag_at_rest, measure_shallow, place_bag
from omote.model.weak_cache import weakly_cached

# Skin within LIP_SKIN_METRES of the lips' line, along the mesh, goes along, by less and less.
LIP_SKIN_METRES = 0.012
# Places along the mouth at which one looks through, and the pitches from which, radians.
STATIONS = 41
PITCHES = (-0.35, 0.0, 0.35)
# The skin behind closed lips overlaps by so much, metres; what is nearer than MET_METRES meets.
OVERLAP_METRES = 0.0002
MET_METRES = 0.00002
CLOSING_ROUNDS = 20


@dataclass(frozen=True, eq=False)
class _Lips:
    """corners (2,): those of the mouth; upper, lower (e, 2): edges of the lips; side (V,): how far a vertex goes
    with the upper (+) or the lower lip (-); behind (V,): the same of inner skin, none of the sheet."""

    corners: Rows
    upper: Rows
    lower: Rows
    side: Values
    behind: Values


def close_lips(space: ParameterSpace, positions: NDArray[np.floating], /) -> Values:
    """Positions of a face at rest (V, 3) whose lips meet all along the mouth: both give way by half, upward and
    downward; who has them closed keeps them. Where no lips are named the positions come back as they are.

    space: the space of the generic head.

    The sheet moves until lips meet as seen from the front and no further; that of the generic face is S, one layer in
    which no lip may cover the other, and stays. What can be looked through behind it, inner skin closes.
    """
    result = positions.astype(np.float64)
    lips = _find_lips(space)
    if lips is not None and not np.array_equal(positions, space.points.astype(positions.dtype)):
        _close(lips, result, lips.side, (0.0,), 0.0)
    return close_behind_lips(space, result)


def close_behind_lips(space: ParameterSpace, positions: NDArray[np.floating], /) -> Values:
    """Positions of a face at rest (V, 3) with the inner skin behind closed lips, and it alone, where nobody looks
    through from above, below or ahead.

    space: the space of the generic head; positions: (V, 3), metres.
    """
    result = positions.astype(np.float64)
    lips = _find_lips(space)
    if lips is not None:
        _close(lips, result, lips.behind, PITCHES, OVERLAP_METRES)
    return result


def _close(lips: _Lips, positions: Values, side: Values, pitches: Sequence[float], press: float) -> None:
    """Moves what goes with a lip, by its side (V,), until nobody looks through from these pitches, in place; a press
    goes beyond that, beside a gap too."""
    for _ in range(CLOSING_ROUNDS):
        across, gaps = _look_through(lips, positions, pitches)
        if not gaps.any():
            return
        wanted = np.where(gaps > 0.0, gaps + press, 0.0)
        if press:
            beside = np.pad(wanted, 1)
            wanted = np.maximum(wanted, 0.5 * (beside[2:] + beside[:-2]))
        positions[:, 1] -= 0.5 * side * np.interp(positions[:, 0], across, wanted, left=0.0, right=0.0)


@weakly_cached
def _find_lips(space: ParameterSpace) -> _Lips | None:
    """The lips of a space, remembered as long as it lives; None where none are named."""
    line = next((line for line in space.lines if line.kind == "lips"), None)
    if line is None:
        return None
    corners = space.welded[space.triangles]
    edges = mesh.edges(corners).astype(np.int64)
    graph = mesh.edge_graph(space.points, corners)
    halves = chains(space.points, space.welded[line.loop])
    up, down = (
        dijkstra(graph, directed=False, indices=half[1:-1], min_only=True, limit=2.0 * LIP_SKIN_METRES)[space.welded]
        for half in halves
    )
    share = 1.0 - smooth_ramp(0.0, LIP_SKIN_METRES, np.minimum(np.minimum(up, down), LIP_SKIN_METRES))
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
    return across, np.where(gaps > MET_METRES, gaps, 0.0)


def _highest(x: Values, height: Values, edges: Rows, across: Values) -> Values:
    """The greatest height of edges at each x; minus infinity where none is."""
    one, other = edges.T
    rise = x[other] - x[one]
    share = (across[:, None] - x[one]) / np.where(np.abs(rise) < 1e-9, 1e-9, rise)
    there = height[one] + share * (height[other] - height[one])
    return np.asarray(np.where((share >= 0.0) & (share <= 1.0), there, -np.inf).max(axis=1))


# A mouth is out of order where a tenth of the gums' edges are farther from their places in the bag than FLOATING, a
# crown is through its wall, or the bag lies SHALLOW less deep than on the generic face, metres: no face of the cast's
# is.
FLOATING = 0.0016
SHALLOW = 0.0004
# What closes behind the lips brings the bag out again, by less each time: so many turns at most, until it lies less
# than LEFT, metres, too shallow.
TURNS = 8
LEFT = 0.0002


def fit_mouth_at_rest(space: ParameterSpace, positions: Floats, parts: Mapping[str, NDArray[np.floating]], /) -> Floats:
    """A new face at rest (V, 3) with its mouth put in order, its parts placed: all else stays.

    Parameters
    ----------
    space : ParameterSpace
        The face's.
    positions : ndarray, (V, 3)
        Skin and inner skin, metres.
    parts : mapping of ndarray (n, 3), by name
        Where its teeth are.
    """
    closed = close_lips(space, positions)
    line = find_gum_line(space)
    if line is None:
        return fit_mouth_bag_at_rest(space, closed.astype(np.float32))
    placed = meet_gums(line, closed, parts)
    mended = place_bag(space, line.bag, closed.astype(np.float32), placed)
    for _ in range(TURNS):
        inside = fit_mouth_bag_at_rest(space, mended)
        mended = close_behind_lips(space, inside).astype(np.float32)  # the bag begins at the lips' inner edge
        if measure_shallow(space, mended) <= LEFT:
            break
    return mended


def mend_mouth(space: ParameterSpace, face: Face, /) -> Face:
    """A face made of others or from control points with its mouth in order; itself where that is so.

    Its lips are closed; its bag is fitted anew only where it is out of order, for faces in order mix to such.
    ValueError where the face does not belong to the space.
    """
    fitted = fit(space, face)
    line = find_gum_line(space)
    if line is not None and _is_out_of_order(space, line, fitted.positions, fitted.parts):
        positions = fit_mouth_at_rest(space, fitted.positions, fitted.parts)
    else:
        positions = close_lips(space, fitted.positions).astype(np.float32)
    return face if np.array_equal(positions, fitted.positions) else replace(face, positions=positions)


def _is_out_of_order(
    space: ParameterSpace, line: GumLine, positions: Floats, parts: Mapping[str, NDArray[np.floating]]
) -> bool:
    edges, crowns = measure_gums(line, positions.astype(np.float64), parts)
    return bool(np.quantile(edges, 0.9) > FLOATING or crowns.min() < 0.0) or measure_shallow(space, positions) > SHALLOW
