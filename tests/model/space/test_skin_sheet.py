"""The parts of finding a sheet, on shapes whose answer is known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from omote.geometry.cylinder import Cylinder
from omote.model.space import skin_sheet as sheet
from tests.synthetic import head

OCTAHEDRON = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
FACES = np.array(
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], dtype=np.int32
)
shifts = st.floats(-0.5, 0.5)


def area_in_s(theta: NDArray[np.float64], h: NDArray[np.float64], corners: NDArray[np.int32]) -> NDArray[np.float64]:
    """Twice the signed area of each triangle in (theta, h)."""
    u, w = sheet.unwrap_corners(theta, corners), h[corners]
    doubled: NDArray[np.float64] = (u[:, 1] - u[:, 0]) * (w[:, 2] - w[:, 0]) - (u[:, 2] - u[:, 0]) * (w[:, 1] - w[:, 0])
    return doubled


@given(shifts, shifts)
def test_the_axis_moves_with_the_head(dx: float, dz: float) -> None:
    points, triangles = head()
    x, z = sheet.find_axis(points, triangles)
    np.testing.assert_allclose(sheet.find_axis(points + np.array([dx, 0, dz]), triangles), [x + dx, z + dz], atol=1e-9)
    assert abs(x) < 1e-3


def test_an_axis_inside_is_taken_and_one_outside_refused() -> None:
    sheet.refuse_axis_outside(OCTAHEDRON * [1, 3, 1], FACES, Cylinder(0.0, 0.0))
    with pytest.raises(ValueError, match=r"the axis at x = 2, z = 0 is outside the head"):
        sheet.refuse_axis_outside(OCTAHEDRON * [1, 3, 1], FACES, Cylinder(2.0, 0.0))


def test_a_triangle_without_area_is_refused_by_its_number() -> None:
    sheet.refuse_degenerate(OCTAHEDRON, FACES)
    flat = OCTAHEDRON.copy()
    flat[0] = flat[2]
    with pytest.raises(ValueError, match=r"triangle 0 \(vertices \[0 2 4\]\) has no area"):
        sheet.refuse_degenerate(flat, FACES)


@given(st.lists(st.floats(-3.1, 3.1), min_size=3, max_size=3))
def test_unwrapping_turns_corners_by_whole_circles_only(angles: list[float]) -> None:
    theta = np.array(angles)
    turns = (sheet.unwrap_corners(theta, np.array([[0, 1, 2]], np.int32))[0] - theta) / (2 * np.pi)
    np.testing.assert_allclose(turns, turns.round(), atol=1e-9)


def test_the_cut_keeps_one_connected_layer_that_faces_outward_and_closes_its_holes() -> None:
    points, triangles = head()
    cylinder = Cylinder(*sheet.find_axis(points, triangles))
    theta, h, _ = cylinder.unroll(points)
    keep = sheet.cut_sheet(points, triangles, theta, h, cylinder)
    membranes = sheet.close_holes(points, triangles[keep], theta, h, cylinder)
    assert keep.mean() > 0.8
    assert (area_in_s(theta, h, triangles[keep]) > 0).all()
    assert (area_in_s(theta, h, membranes) > 0).all()
    assert not keep[~sheet.find_outward(theta, h, triangles)].any()
    assert np.isin(membranes, triangles[keep]).all()


def test_a_head_turned_inside_out_has_no_sheet() -> None:
    points, triangles = head()
    theta, h, _ = Cylinder(0.0, 0.0).unroll(points)
    with pytest.raises(ValueError, match=r"expected a head, y up and \+z forward, wound counter-clockwise"):
        sheet.cut_sheet(points, triangles[:, ::-1], theta, h, Cylinder(0.0, 0.0))


def test_vertices_that_nothing_joins_follow_their_four_nearest() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [5, 5, 0], [0.1, 0, 0]], dtype=np.float64)
    anchors = np.zeros((2, 4), np.int32)
    weights = np.array([[1.0, 0, 0, 0], [0, 0, 0, 0]])
    bound, shares = sheet.bind_islands(points, np.array([4, 5], np.int32), np.arange(4), anchors, weights)
    np.testing.assert_array_equal(bound[0], anchors[0])
    np.testing.assert_array_equal(shares[0], weights[0])
    assert set(bound[1]) == {0, 1, 2, 3}
    assert shares[1].sum() == pytest.approx(1)
    assert bound[1][shares[1].argmax()] == 0
