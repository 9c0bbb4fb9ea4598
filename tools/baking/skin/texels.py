"""What lies under each pixel of the skin's pictures, and how a painted layer becomes one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, dijkstra

from tools.baking.heads.basemesh import Floats, Ints
from tools.baking.heads.head import Piece
from tools.baking.layout import islands
from tools.baking.skin.raster import openness, rasterise, vertex_normals

SIZE = 1024
PADDING = 8  # pixels that every island is grown by, so that filtering never reads the ground


@dataclass(frozen=True, eq=False)
class Texels:
    """What lies under each pixel of the picture.

    covered: (SIZE, SIZE) bool;  places: (n, 3) metres on the generic head of the covered pixels;
    normals: (n, 3) of unit length;  lip_rings, lid_rings: (n,) edges to the seam of the mouth and of the nearer eye;
    light: (n,) 0 to 1;  inner: (n,) bool, on the islands that lie inside mouth and lids
    """

    covered: NDArray[np.bool_]
    places: Floats
    normals: Floats
    lip_rings: Floats
    lid_rings: Floats
    light: Floats
    inner: NDArray[np.bool_]

    def spread(self, values: Floats) -> Floats:
        """Values (n, ...) of the covered pixels as a picture (SIZE, SIZE, ...), islands grown over their borders."""
        picture = np.zeros((*self.covered.shape, *values.shape[1:]))
        picture[self.covered] = values
        covered = self.covered.copy()
        for _ in range(PADDING):
            for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
                source = np.roll(covered, step, axis)
                fresh = source & ~covered
                picture[fresh] = np.roll(picture, step, axis)[fresh]
                covered |= fresh
        return picture


def texels_of(skin: Piece, points: Floats, layout: Floats) -> Texels:
    """The texels of the generic head: points (n, 3) metres, layout (k, 2) its texture coordinates.

    skin: its triangles and texture corners.
    """
    corners = np.concatenate([layout * SIZE, np.zeros((len(layout), 1))], axis=1)[skin.uv_corners]
    owner, weights, _ = rasterise(corners, SIZE)
    covered = owner >= 0
    chosen = skin.triangles[owner[covered]]
    share = weights[covered]

    def at_pixels(values: Floats) -> Floats:
        return np.asarray(np.einsum("ij,ij...->i...", share, values[chosen]))

    light = openness(points, skin.triangles)
    mouth, lids = _rings(skin, points)
    normals = at_pixels(vertex_normals(points, skin.triangles))
    return Texels(
        covered=covered,
        places=at_pixels(points),
        normals=normals / np.linalg.norm(normals, axis=1, keepdims=True),
        lip_rings=at_pixels(mouth),
        lid_rings=at_pixels(lids),
        light=at_pixels(light),
        inner=_hidden_islands(skin, light)[skin.uv_corners[owner[covered], 0]],
    )


def ramp(values: Floats, low: Floats | float, high: Floats | float) -> Floats:
    """0 at `low`, 1 at `high`, with a soft step between; the two may stand in either order.

    values: of any shape.
    """
    share = np.clip((values - low) / (np.asarray(high) - low), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def blob(places: Floats, centre: tuple[float, float, float], radii: tuple[float, float, float]) -> Floats:
    """A soft ball (n,): 1 at the centre, 0.37 on the ellipsoid with these radii; metres, mirrored in x.

    places (n, 3).
    """
    off = (np.abs(places[:, 0]) - centre[0]) / radii[0], *((places[:, 1:] - centre[1:]) / radii[1:]).T
    return np.asarray(np.exp(-sum(part**2 for part in off)))


def _hidden_islands(skin: Piece, light: Floats) -> NDArray[np.bool_]:
    """Whether each texture coordinate (k,) lies on an island that hardly sees light: mouth bag and eye sockets."""
    island = islands(skin.uv_corners, len(skin.uvs))
    seen = np.zeros(len(skin.uvs))
    seen[skin.uv_corners] = light[skin.triangles]
    return (np.bincount(island, weights=seen) / np.bincount(island) < 0.3)[island]


def _rings(skin: Piece, points: Floats) -> tuple[Floats, Floats]:
    """Edges from each vertex (n,) to the seam of the mouth, and to the seam of the nearer eye."""
    seams = [np.unique(seam) for seam in _seams(skin)]
    front = [seam for seam in seams if points[seam, 2].min() > 0.08 and len(seam) > 20]  # mouth and eyes
    mouth = [seam for seam in front if abs(points[seam, 0].mean()) < 0.01]
    eyes = [seam for seam in front if abs(points[seam, 0].mean()) >= 0.01]
    edges = np.concatenate([skin.triangles[:, [0, 1]], skin.triangles[:, [1, 2]], skin.triangles[:, [2, 0]]])
    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(len(points),) * 2).tocsr()

    def edges_to(chosen: list[Ints]) -> Floats:
        start = np.concatenate(chosen) if chosen else np.zeros(0, dtype=np.int32)
        far = np.full(len(points), 99.0)
        return dijkstra(graph, directed=False, unweighted=True, indices=start, min_only=True) if chosen else far

    return edges_to(mouth), edges_to(eyes)


def _seams(skin: Piece) -> list[Ints]:
    """The closed border lines of the largest island, each as vertices."""
    corners = skin.uv_corners
    count = len(skin.uvs)
    island = islands(corners, count)
    vertex = np.zeros(count, dtype=np.int32)
    vertex[corners] = skin.triangles
    edges = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    unique, uses = np.unique(edges, axis=0, return_counts=True)
    border = unique[(uses == 1) & (island[unique[:, 0]] == np.bincount(island).argmax())]
    links = coo_array((np.ones(len(border)), (border[:, 0], border[:, 1])), shape=(count, count))
    label = connected_components(links, directed=False)[1]
    return [vertex[label == line] for line in np.unique(label[border[:, 0]])]
