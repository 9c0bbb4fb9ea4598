"""The skin as photographs show it: the same surface, finer, each vertex in its texel's colour."""

import numpy as np

from omote.edit.compute.face_previews import FINER, colour_skin, halve_edges
from omote.geometry import mesh

SQUARE = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
HALVES = np.array([[0, 1, 2], [0, 2, 3]])


def area(positions: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = positions[triangles].transpose(1, 0, 2)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def test_each_edge_is_halved_once_and_all_triangles_face_as_before() -> None:
    corners, triangles = halve_edges(SQUARE, HALVES)
    assert len(corners) == 4 + 5, "five edges, the diagonal shared"
    assert len(triangles) == 8
    assert np.isclose(area(corners, triangles), 1.0)
    assert (mesh.unit_normals(corners[triangles])[:, 2] > 0.99).all()
    assert set(triangles.ravel()) == set(range(len(corners)))


def test_colours_are_those_of_the_texture_where_a_vertex_lies() -> None:
    side = 64
    painted = np.zeros((side, side, 3), np.uint8)
    painted[..., 0] = np.arange(side)
    painted[..., 1] = np.arange(side)[:, None]
    skin = colour_skin(SQUARE, SQUARE[:, :2], HALVES, painted)
    assert len(skin.triangles) == len(HALVES) * 4**FINER
    wanted = np.minimum(skin.positions[:, :2] * side, side - 1).astype(int)
    assert (skin.colours[:, :2] == wanted).all()
