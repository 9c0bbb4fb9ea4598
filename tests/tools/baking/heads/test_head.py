"""Cutting the head out of the base mesh."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from tools.baking.heads.basemesh import BaseMesh, Quads
from tools.baking.heads.head import cut_piece, split_quads

GRID = np.arange(20, dtype=np.int32).reshape(4, 5)
CORNERS = np.stack([GRID[:-1, :-1], GRID[:-1, 1:], GRID[1:, 1:], GRID[1:, :-1]], axis=-1).reshape(-1, 4)


@st.composite
def sheets(draw: st.DrawFn) -> NDArray[np.float64]:
    """A wavy sheet of 4 x 5 vertices, mirror-symmetric in x, its middle column at x = 0."""
    rng = np.random.default_rng(draw(st.integers(0, 10_000)))
    across, along = np.meshgrid(np.arange(5.0) - 2, np.arange(4.0))
    points = np.stack([across, along, np.zeros((4, 5))], axis=-1) + rng.normal(scale=0.2, size=(4, 5, 3))
    points[:, 2, 0] = 0.0
    points[:, 3:] = points[:, 1::-1] * [-1, 1, 1]
    return points.reshape(-1, 3)


@given(sheets())
def test_a_symmetric_sheet_is_cut_symmetrically(points: NDArray[np.float64]) -> None:
    triangles, _ = split_quads(points, Quads(CORNERS, CORNERS))
    mirrored = GRID[:, ::-1].ravel()[triangles]
    assert {frozenset(t) for t in triangles.tolist()} == {frozenset(t) for t in mirrored.tolist()}


@given(sheets())
def test_both_triangles_keep_the_quads_winding_and_cover_it(points: NDArray[np.float64]) -> None:
    triangles, uvs = split_quads(points, Quads(CORNERS, CORNERS + 100))
    np.testing.assert_array_equal(uvs, triangles + 100)
    for quad, pair in zip(CORNERS.tolist(), triangles.reshape(-1, 2, 3).tolist(), strict=True):
        around = {(quad[i], quad[(i + 1) % 4]) for i in range(4)}
        edges = [(t[i], t[(i + 1) % 3]) for t in pair for i in range(3)]
        assert around <= set(edges)
        inner = set(edges) - around
        assert {(b, a) for a, b in inner} == inner
        assert len(inner) == 2


def test_a_quad_is_cut_along_its_shorter_diagonal() -> None:
    kite = np.array([[0.0, 0, 0], [1, 1, 0], [0, 3, 0], [-1, 1, 0]])
    triangles, _ = split_quads(kite, Quads(np.array([[0, 1, 2, 3]], np.int32), np.array([[0, 1, 2, 3]], np.int32)))
    assert all({1, 3} < set(t) for t in triangles.tolist())


def test_a_piece_numbers_its_own_vertices() -> None:
    points = np.concatenate([np.zeros((5, 3)), [[0.0, 6, 0], [1, 6, 0], [1, 7, 0], [0, 7, 0]]])
    quads = Quads(np.array([[5, 6, 7, 8]], np.int32), np.array([[3, 2, 1, 3]], np.int32))
    piece = cut_piece(BaseMesh(points, np.arange(8.0).reshape(4, 2), {}), quads)
    np.testing.assert_array_equal(piece.vertices, [5, 6, 7, 8])
    assert sorted(np.unique(piece.triangles)) == [0, 1, 2, 3]
    np.testing.assert_array_equal(piece.uvs, [[2, 3], [4, 5], [6, 7]])
    assert piece.uv_corners.shape == (2, 3)
