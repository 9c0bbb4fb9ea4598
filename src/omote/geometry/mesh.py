"""Triangle meshes: validation, adjacency, boundary loops, connected components, normals, welding."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.arrays import Indices, Mask, Points, Rows, Triangles, Values

if TYPE_CHECKING:
    from scipy.sparse import csr_array

Array = TypeVar("Array", bound=NDArray[Any])

FARTHEST = 1e6
"""No number of a mesh lies farther from zero: float32 would keep nothing of a face, and squares would overflow."""


def freeze(values: Array, /) -> Array:
    """Makes an array read-only, and returns it."""
    values.setflags(write=False)
    return values


def validate_numbers(values: ArrayLike, /, *, name: str) -> Values:
    """Validates and copies numbers into a float64 array of any shape.

    name: what messages call it.

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


def rows_out_of_reach(values: Values, /) -> Rows:
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

    name: what messages call it.

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


def weld(points: Points, /) -> Indices:
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
    forward = a.astype(np.int64) * size + b
    backward = b.astype(np.int64) * size + a
    order = np.argsort(forward, kind="stable")
    place = np.searchsorted(forward[order], backward)
    inside = place < len(order)
    other = order[np.minimum(place, len(order) - 1)]
    inside &= forward[other] == backward
    unique = _find_unique(forward)
    inside &= unique & unique[other]
    return np.where(inside, other // 3, -1).astype(np.int32).reshape(-1, 3)


def _find_unique(keys: NDArray[np.int64], /) -> Mask:
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    return counts[inverse] == 1


def edge_lengths(points: Points, triangles: Triangles, /) -> Values:
    """Length of the edge opposite to each corner: (F, 3), metres.

    points: (V, 3), metres; triangles: rows (F, 3) of vertices.
    """
    corners = points[triangles]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - np.roll(corners, -2, axis=1), axis=2)


def areas(points: Points, triangles: Triangles, /) -> Values:
    """Area of each triangle: (F,), square metres. points: (V, 3), metres; triangles: rows (F, 3) of vertices."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def normals(points: Points, triangles: Triangles, /) -> Points:
    """Area-weighted unit normal of each vertex: (V, 3); a vertex without area gets (0, 0, 1).

    points: (V, 3), metres; triangles: rows (F, 3) of vertices.
    """
    a, b, c = points[triangles].transpose(1, 0, 2)
    faces = np.cross(b - a, c - a)
    total = np.zeros_like(points)
    for corner in range(3):
        np.add.at(total, triangles[:, corner], faces)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.where(length > 0, total / np.where(length > 0, length, 1.0), [0.0, 0.0, 1.0])


def unit_normals(corners: Points, /) -> Points:
    """The unit normals (n, 3) of triangles (n, 3, 3); zero where one has no area."""
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-30)


def cross_matrices(vectors: Points, /) -> Values:
    """The matrices (n, 3, 3) that give the cross products of vectors (n, 3) with what they are applied to."""
    x, y, z = vectors.T
    none = np.zeros_like(x)
    return np.stack([none, -z, y, z, none, -x, -y, x, none], axis=1).reshape(-1, 3, 3)


def edges(triangles: Triangles, /) -> Triangles:
    """Every edge of triangles once, lower vertex first: (E, 2)."""
    return np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)


def edge_graph(points: Points, triangles: NDArray[np.integer], /) -> csr_array:
    """The graph (n, n) of a mesh's edges with their lengths, metres.

    points (n, 3): metres; triangles (t, 3): rows of them.
    """
    from scipy.sparse import csr_array

    ends = edges(triangles.astype(np.int32))
    lengths = np.maximum(np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1), 1e-9)
    return csr_array((lengths, (ends[:, 0], ends[:, 1])), shape=(len(points), len(points)))


def boundary_edges(triangles: Triangles, /) -> Triangles:
    """The directed edges with a triangle on the left only: (E, 2)."""
    across = neighbours(triangles)
    rows, corners = np.nonzero(across < 0)
    return np.stack([triangles[rows, (corners + 1) % 3], triangles[rows, (corners + 2) % 3]], axis=1)


def boundary_loops(triangles: Triangles, plane: Values, /, *, period: float = np.inf) -> list[Indices]:
    """The closed boundary lines, mesh on the left; a vertex where two holes touch splits them.

    period: of that column, infinite for none.

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


def _trace(leaving: dict[int, list[int]], plane: Values, period: float) -> Indices:
    start = next(iter(leaving))
    before = start
    here = leaving[start][0]
    _take(leaving, start, here)
    loop = [start]
    while here != start:
        loop.append(here)
        onward = _next_around_hole(before, here, leaving[here], plane, period)
        _take(leaving, here, onward)
        before = here
        here = onward
    return np.array(loop, dtype=np.int32)


def _take(leaving: dict[int, list[int]], start: int, end: int) -> None:
    leaving[start].remove(end)
    if not leaving[start]:
        del leaving[start]


def _next_around_hole(before: int, here: int, candidates: list[int], plane: Values, period: float) -> int:
    # The hole lies on the right of the boundary: sweep counter-clockwise from where we came.
    if len(candidates) == 1:
        return candidates[0]

    def turn(candidate: int) -> float:
        a, b = plane[before] - plane[here], plane[candidate] - plane[here]
        if np.isfinite(period):
            a[0], b[0] = (side - period * np.round(side / period) for side in (a[0], b[0]))
        return float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b) % (2 * np.pi))

    return min(candidates, key=turn)


def components(triangles: Triangles, vertex_count: int, /) -> Indices:
    """Connected component of each vertex, numbered from 0 in order of size, largest first: (V,); a lone vertex is
    one too.

    triangles: rows (F, 3) of vertices; vertex_count: V.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    rows = triangles.ravel()
    cols = np.roll(triangles, 1, axis=1).ravel()
    graph = coo_array((np.ones(len(rows), dtype=np.int8), (rows, cols)), shape=(vertex_count, vertex_count))
    count, label = connected_components(graph, directed=False)
    order = np.argsort(-np.bincount(label, minlength=count), kind="stable")
    rank = np.empty(count, dtype=np.int32)
    rank[order] = np.arange(count, dtype=np.int32)
    return rank[label]
