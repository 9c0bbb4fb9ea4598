"""Triangle meshes: validation, adjacency, boundary loops, connected components, normals, welding."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Points = NDArray[np.float64]
Triangles = NDArray[np.int32]

FARTHEST = 1e6
"""No number of a mesh lies farther from zero: float32 would keep nothing of a face, and squares would overflow."""


def validate_numbers(values: ArrayLike, /, *, name: str) -> NDArray[np.float64]:
    """Validates and copies numbers into a float64 array of any shape.

    Raises ValueError on rows of different lengths, on masked values and on what is no number: text, bool, complex,
    objects. Whether the numbers are finite is left to whoever knows what their rows are.
    """
    given = _to_array(values, name)
    if given.dtype.kind not in "iuf" and given.size:
        kind = type(values).__name__ if given.dtype.kind in "OU" and given.ndim == 0 else given.dtype.name
        raise ValueError(f"{name} has no numbers but {kind}: expected an array of real numbers, such as float32")
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has masked values; expected all of them: fill them in first")
    return np.array(given, dtype=np.float64)


def rows_out_of_reach(values: NDArray[np.float64], /) -> NDArray[np.intp]:
    """The rows of values that are not finite, or farther than FARTHEST from zero."""
    near = np.abs(values) <= FARTHEST  # not so for NaN
    return np.flatnonzero(~near.all(axis=tuple(range(1, near.ndim))))


def _to_array(values: ArrayLike, name: str) -> NDArray[Any]:
    try:
        return np.asarray(values)
    except (ValueError, TypeError) as error:
        raise ValueError(f"{name} has rows of different lengths; expected an array of numbers") from error


def validate_points(points: ArrayLike, /, *, name: str = "points") -> Points:
    """Validates points and converts them to float64.

    points (V, 3), metres. Raises ValueError on another shape, on what is no real number and on values that are not
    finite or out of all reach.
    """
    result = validate_numbers(points, name=name)
    if result.ndim != 2 or result.shape[1] != 3 or len(result) == 0:
        raise ValueError(f"{name} has shape {result.shape}; expected (V, 3), one row of x, y, z per vertex")
    bad = rows_out_of_reach(result)
    if len(bad):
        raise ValueError(
            f"{name}[{bad[0]}] is {result[bad[0]]}; expected finite numbers in every one of its {len(result)} rows, "
            f"at most {FARTHEST:g} from zero"
        )
    return result


def validate_triangles(triangles: ArrayLike, vertex_count: int, /) -> Triangles:
    """Validates triangles and converts them to int32.

    triangles (F, 3), vertex indices counter-clockwise from outside. Raises ValueError on another shape, on indices
    outside 0..vertex_count-1, on a triangle that names a vertex twice and on one that is there twice.
    """
    result = _to_array(triangles, "triangles")
    if result.ndim != 2 or result.shape[1] != 3 or len(result) == 0:
        raise ValueError(f"triangles has shape {result.shape}; expected (F, 3), three vertex indices per triangle")
    if not np.issubdtype(result.dtype, np.integer):
        raise ValueError(f"triangles has dtype {result.dtype}; expected integers")
    bad = np.flatnonzero(((result < 0) | (result >= vertex_count)).any(axis=1))
    if len(bad):
        raise ValueError(f"triangle {bad[0]} is {result[bad[0]]}; expected indices from 0 to {vertex_count - 1}")
    twice = np.flatnonzero((result == np.roll(result, 1, axis=1)).any(axis=1))
    if len(twice):
        raise ValueError(
            f"triangle {twice[0]} is {result[twice[0]]}; expected three different vertices (degenerate triangle)"
        )
    _refuse_doubled(result)
    return result.astype(np.int32)


def _refuse_doubled(triangles: NDArray[np.integer]) -> None:
    """An edge of two equal triangles has four sides: the sheet would tear there."""
    turn = (triangles.argmin(axis=1)[:, None] + np.arange(3)) % 3
    _, first, inverse = np.unique(
        np.take_along_axis(triangles, turn, axis=1), axis=0, return_index=True, return_inverse=True
    )
    same = first[inverse.reshape(-1)]
    late = np.flatnonzero(same != np.arange(len(triangles)))
    if len(late):
        raise ValueError(
            f"triangle {late[0]} is {triangles[late[0]]}, as triangle {same[late[0]]} is, and {len(late) - 1} more; "
            "expected every triangle once: remove one of them"
        )


def weld(points: Points, /) -> NDArray[np.int32]:
    """For each vertex, the first vertex at exactly the same place (texture seams double vertices).

    points (V, 3) -> (V,).
    """
    _, first, inverse = np.unique(points, axis=0, return_index=True, return_inverse=True)
    return first[inverse.reshape(-1)].astype(np.int32)


def neighbours(triangles: Triangles, /) -> Triangles:
    """For each corner, the triangle across the opposite edge, or -1.

    triangles (F, 3) -> (F, 3). An edge of more than two triangles, or of two that disagree in winding, has no
    neighbours.
    """
    a, b = np.roll(triangles, -1, axis=1).ravel(), np.roll(triangles, -2, axis=1).ravel()
    size = np.int64(triangles.max()) + 1
    forward, backward = a.astype(np.int64) * size + b, b.astype(np.int64) * size + a
    order = np.argsort(forward, kind="stable")
    found = np.searchsorted(forward[order], backward)
    inside = found < len(order)
    other = order[np.minimum(found, len(order) - 1)]
    inside &= forward[other] == backward
    unique = _find_unique(forward)
    inside &= unique & unique[other]
    result: Triangles = np.where(inside, other // 3, -1).astype(np.int32).reshape(-1, 3)
    return result


def _find_unique(keys: NDArray[np.int64], /) -> NDArray[np.bool_]:
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    once: NDArray[np.bool_] = counts[inverse] == 1
    return once


def edge_lengths(points: Points, triangles: Triangles, /) -> NDArray[np.float64]:
    """Length of the edge opposite to each corner: (F, 3), metres."""
    corners = points[triangles]
    result: NDArray[np.float64] = np.linalg.norm(np.roll(corners, -1, axis=1) - np.roll(corners, -2, axis=1), axis=2)
    return result


def areas(points: Points, triangles: Triangles, /) -> NDArray[np.float64]:
    """Area of each triangle: (F,), square metres."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    result: NDArray[np.float64] = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return result


def normals(points: Points, triangles: Triangles, /) -> Points:
    """Area-weighted unit normal of each vertex: (V, 3); a vertex without area gets (0, 0, 1)."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    faces = np.cross(b - a, c - a)
    total = np.zeros_like(points)
    for corner in range(3):
        np.add.at(total, triangles[:, corner], faces)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    result: Points = np.where(length > 0, total / np.where(length > 0, length, 1.0), [0.0, 0.0, 1.0])
    return result


def unit_normals(corners: Points, /) -> Points:
    """The unit normals (n, 3) of triangles (n, 3, 3); zero where one has no area."""
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    result: Points = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-30)
    return result


def edges(triangles: Triangles, /) -> Triangles:
    """Every edge of triangles once, lower vertex first: (E, 2)."""
    found: Triangles = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    return found


def boundary_edges(triangles: Triangles, /) -> Triangles:
    """The directed edges with a triangle on the left only: (E, 2)."""
    across = neighbours(triangles)
    rows, corners = np.nonzero(across < 0)
    return np.stack([triangles[rows, (corners + 1) % 3], triangles[rows, (corners + 2) % 3]], axis=1)


def boundary_loops(
    triangles: Triangles, plane: NDArray[np.float64], /, *, period: float = np.inf
) -> list[NDArray[np.int32]]:  # fmt: skip
    """The closed boundary lines, mesh on the left; a vertex where two holes touch splits them.

    triangles (F, 3), plane (V, 2): a picture of the mesh in which angles at such a vertex are measured, its first
    column periodic. Returns one index array per loop.
    """
    edges = boundary_edges(triangles)
    leaving: dict[int, list[int]] = {}
    for start, end in edges.tolist():
        leaving.setdefault(start, []).append(end)
    loops = []
    while leaving:
        loops.append(_trace(leaving, plane, period))
    return loops


def _trace(leaving: dict[int, list[int]], plane: NDArray[np.float64], period: float) -> NDArray[np.int32]:
    start = next(iter(leaving))
    before, here = start, leaving[start][0]
    _take(leaving, start, here)
    loop = [start]
    while here != start:
        loop.append(here)
        onward = _next_around_hole(before, here, leaving[here], plane, period)
        _take(leaving, here, onward)
        before, here = here, onward
    return np.array(loop, dtype=np.int32)


def _take(leaving: dict[int, list[int]], start: int, end: int) -> None:
    leaving[start].remove(end)
    if not leaving[start]:
        del leaving[start]


def _next_around_hole(
    before: int, here: int, candidates: list[int], plane: NDArray[np.float64], period: float
) -> int:  # fmt: skip
    # The hole lies on the right of the boundary: sweep counter-clockwise from where we came.
    if len(candidates) == 1:
        return candidates[0]

    def turn(candidate: int) -> float:
        a, b = plane[before] - plane[here], plane[candidate] - plane[here]
        if np.isfinite(period):
            a[0], b[0] = (side - period * np.round(side / period) for side in (a[0], b[0]))
        return float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b) % (2 * np.pi))

    return min(candidates, key=turn)


def components(triangles: Triangles, vertex_count: int, /) -> NDArray[np.int32]:
    """Connected component of each vertex, numbered from 0 in order of size, largest first: (V,); a lone vertex is
    one too."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    rows, cols = triangles.ravel(), np.roll(triangles, 1, axis=1).ravel()
    graph = coo_array((np.ones(len(rows), dtype=np.int8), (rows, cols)), shape=(vertex_count, vertex_count))
    count, label = connected_components(graph, directed=False)
    order = np.argsort(-np.bincount(label, minlength=count), kind="stable")
    rank = np.empty(count, dtype=np.int32)
    rank[order] = np.arange(count, dtype=np.int32)
    result: NDArray[np.int32] = rank[label]
    return result
