"""Finds the mouth bag, the inner skin behind the lips (docs/method.md, "Mouth bag")."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.spatial import cKDTree

from omote.arrays import Indices, Mask, Values
from omote.geometry import mesh
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached


@dataclass(frozen=True, eq=False)
class MouthBag:
    """The mouth bag of a space, seams welded.

    vertices (m,); triangles (t, 3) of the mesh that touch it; rows (n,): the row in `vertices` of each inner vertex, or
    -1; distance (m,): metres along the mesh to the sheet; neighbours (m, k): rows, a vertex's own where it has fewer;
    starts (m,): sheet vertices at which a walk to the skin outside begins; region (k,): the bag and the skin within
    COVER_METRES of it; skin (s, 3), membranes (o, 3): the triangles of the sheet there, and what closes its openings;
    rim (r,): the rows nearer to the lips than RIM_METRES; around (a, 3): the skin and membranes within AROUND_METRES of
    these."""

    vertices: Indices
    triangles: Indices
    rows: Indices
    distance: Values
    neighbours: NDArray[np.int64]
    starts: Indices
    region: Indices
    skin: Indices
    membranes: Indices
    rim: NDArray[np.int64]
    around: Indices


# The bag's rim reaches so far along the mesh from the lips, and the skin around it so far from it, metres.
RIM_METRES = 0.006
AROUND_METRES = 0.008
# The bag is behind skin that is no farther from it than this, metres.
COVER_METRES = 0.03


@weakly_cached
def find_mouth_bag(space: ParameterSpace, /) -> MouthBag | None:
    """The mouth bag of a space, remembered as long as it lives; None where no lips are named or none is behind."""
    lips = next((line.loop for line in space.lines if line.kind == "lips"), None)
    corners = space.welded[space.triangles]
    vertices = np.zeros(0, np.int32) if lips is None else find_behind(corners, ~space.on_sheet, lips)
    if len(vertices) == 0:
        return None
    triangles = corners[np.isin(corners, vertices).any(axis=1)].astype(np.int32)
    place = np.full(space.vertex_count, -1, np.int32)
    place[vertices] = np.arange(len(vertices), dtype=np.int32)
    rows = place[space.welded[space.inner.vertices]]
    distance = measure_distance(space, triangles, vertices)
    neighbours = _list_neighbours(triangles, place, len(vertices))
    near, _ = cKDTree(space.points[vertices]).query(space.points)
    region = np.flatnonzero(near < COVER_METRES).astype(np.int32)
    starts = _nearest_on_sheet(space, vertices)
    skin, membranes = (
        part[(near < COVER_METRES)[part].all(axis=1)] for part in (space.sheet_triangles, space.membranes)
    )
    rim = np.flatnonzero(distance < RIM_METRES)
    around = _find_around(space, vertices[rim], np.concatenate([skin, membranes]))
    return MouthBag(
        vertices, triangles, rows, distance, neighbours, starts, region, skin, membranes, rim=rim, around=around
    )


def _find_around(space: ParameterSpace, vertices: Indices, triangles: Indices) -> Indices:
    """The triangles whose middles are within AROUND_METRES of vertices."""
    away, _ = cKDTree(space.points[vertices]).query(space.points[triangles].mean(axis=1))
    return triangles[away < AROUND_METRES]


def find_behind(corners: Indices, inner: Mask, line: Indices, /) -> Indices:
    """The inner vertices that are joined to a line of lids or lips by inner vertices.

    corners: (F, 3) rows of the triangles.
    """
    ends = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    ends = ends[inner[ends].all(axis=1)]
    graph = coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(len(inner), len(inner)))
    _, label = connected_components(graph, directed=False)
    touching = corners[np.isin(corners, line).any(axis=1)].ravel()
    met = np.unique(label[touching[inner[touching]]])
    return np.unique(corners[inner[corners] & np.isin(label[corners], met)]).astype(np.int32)


def measure_distance(space: ParameterSpace, triangles: Indices, vertices: Indices, /) -> Values:
    """How far along the mesh vertices (m,) of a bag are from the sheet (Dijkstra), metres: (m,).

    space: the space of the generic head; triangles: (F, 3) of the bag and of what is around it.
    """
    graph = mesh.edge_graph(space.points, triangles)
    rim = np.unique(triangles[space.on_sheet[triangles]])
    return dijkstra(graph, directed=False, indices=rim, min_only=True)[vertices]


def _list_neighbours(triangles: Indices, place: Indices, count: int) -> NDArray[np.int64]:
    ends = place[np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])]
    ends = ends[(ends >= 0).all(axis=1)]
    ends = np.unique(np.concatenate([ends, ends[:, ::-1]]), axis=0)
    degree = np.bincount(ends[:, 0], minlength=count)
    result = np.tile(np.arange(count)[:, None], (1, max(1, int(degree.max(initial=0)))))
    first = np.concatenate([[0], np.cumsum(degree)[:-1]])
    result[ends[:, 0], np.arange(len(ends)) - first[ends[:, 0]]] = ends[:, 1]
    return result


def _nearest_on_sheet(space: ParameterSpace, vertices: Indices) -> Indices:
    """The sheet vertices nearest on S."""
    sheet = np.flatnonzero(space.on_sheet & (space.welded == np.arange(space.vertex_count)))
    radius = float(np.hypot(space.points[sheet, 0], space.points[sheet, 2]).mean())
    plane = np.stack([space.theta * radius, space.h], axis=1)
    _, nearest = cKDTree(plane[sheet]).query(plane[vertices])
    return sheet[nearest].astype(np.int32)
