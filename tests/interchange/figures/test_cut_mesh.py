"""A cut mesh is the same surface, on the right sides of the line, without a crack along it."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.geometry import mesh
from omote.interchange.figures.cut_mesh import cut_mesh

COUNT = 6
POINTS = np.array([[x, y, 0.2 * x * y] for y in range(COUNT) for x in range(COUNT)], np.float64)
CORNERS = np.array([[x + COUNT * y for x, y in ((x, y), (x + 1, y), (x, y + 1))] for y in range(5) for x in range(5)])
OTHERS = np.array(
    [[x + COUNT * y for x, y in ((x + 1, y), (x + 1, y + 1), (x, y + 1))] for y in range(5) for x in range(5)]
)
SHEET = np.concatenate([CORNERS, OTHERS])
values = st.lists(st.floats(-1.0, 1.0), min_size=len(POINTS), max_size=len(POINTS)).map(np.array)


@given(values, st.floats(-0.9, 0.9))
def test_both_sides_are_the_whole_and_meet_without_a_crack(numbers: np.ndarray, level: float) -> None:
    cut = cut_mesh(SHEET, numbers, level)
    points = cut.blend @ POINTS
    np.testing.assert_allclose(cut.blend.sum(axis=1), 1.0)
    whole = np.concatenate([cut.under, cut.over])
    before = mesh.areas(POINTS, SHEET).sum()
    np.testing.assert_allclose(mesh.areas(points, whole).sum(), before)
    kept = cut.blend @ numbers
    assert (kept[cut.under] <= level + 1e-9).all()
    assert (kept[cut.over] >= level - 1e-9).all()
    normals = np.cross(points[whole[:, 1]] - points[whole[:, 0]], points[whole[:, 2]] - points[whole[:, 0]])
    assert (normals[:, 2] >= -1e-12).all()  # none is turned over
    edge = mesh.boundary_edges(SHEET)
    length = np.linalg.norm(np.diff(POINTS[edge], axis=1), axis=2).sum()
    parted = mesh.boundary_edges(whole)
    np.testing.assert_allclose(np.linalg.norm(np.diff(points[parted], axis=1), axis=2).sum(), length)
