"""Triangles that are about to turn over are kept from it."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.geometry.orientation import area_shares, repair_triangles, rest_normals

SIDE = 7
GOAL = 0.1


def grid() -> tuple[np.ndarray, np.ndarray]:
    """A flat sheet of squares, each cut in two."""
    x, y = np.meshgrid(np.arange(SIDE, dtype=float), np.arange(SIDE, dtype=float))
    points = 1e-3 * np.stack([x.ravel(), y.ravel(), np.zeros(SIDE * SIDE)], axis=1)
    corner = (np.arange(SIDE - 1)[:, None] * SIDE + np.arange(SIDE - 1)).ravel()
    one = np.stack([corner, corner + 1, corner + SIDE], axis=1)
    other = np.stack([corner + 1, corner + SIDE + 1, corner + SIDE], axis=1)
    return points, np.concatenate([one, other]).astype(np.int32)


REST, TRIANGLES = grid()
NORMALS, SIZES = rest_normals(REST, TRIANGLES)
GOALS = np.full(len(TRIANGLES), GOAL)
moves = st.lists(st.floats(-0.9e-3, 0.9e-3), min_size=3, max_size=3).map(np.array)


@given(st.integers(0, SIDE * SIDE - 1), moves)
def test_a_vertex_pushed_through_its_neighbours_turns_nothing_over(vertex: int, move: np.ndarray) -> None:
    points = REST.copy()
    points[vertex] += move
    repair_triangles(points, NORMALS, SIZES, TRIANGLES, GOALS, 200)
    assert area_shares(points, NORMALS, SIZES, TRIANGLES).min() > 0.0


@given(st.integers(0, SIDE * SIDE - 1), moves)
def test_momentum_leaves_no_more_lacking_after_few_rounds(vertex: int, move: np.ndarray) -> None:
    left = []
    for momentum in (0.0, 0.5):
        points = REST.copy()
        points[vertex] += move
        repair_triangles(points, NORMALS, SIZES, TRIANGLES, GOALS, 16, momentum)
        left.append(np.maximum(GOAL - area_shares(points, NORMALS, SIZES, TRIANGLES), 0.0).max())
    assert left[1] <= left[0] + 1e-3


@given(st.integers(0, SIDE * SIDE - 1), moves, st.floats(0.0, 0.4))
def test_what_is_upright_stays_as_it_is(vertex: int, move: np.ndarray, size: float) -> None:
    points = REST.copy()
    points[vertex] += size * move
    before = points.copy()
    whole = area_shares(points, NORMALS, SIZES, TRIANGLES).min() >= GOAL
    repair_triangles(points, NORMALS, SIZES, TRIANGLES, GOALS, 16)
    assert np.array_equal(points, before) == whole


@given(st.integers(0, SIDE * SIDE - 1), moves)
def test_a_triangle_that_begins_to_lack_area_makes_no_jump(vertex: int, move: np.ndarray) -> None:
    """One that lacks a millionth of its area has hardly a say in the mean at its corners."""
    rest = REST.copy()
    rest[vertex] += move
    shares = area_shares(rest, NORMALS, SIZES, TRIANGLES)
    found = []
    for lack in (-1e-6, 1e-6):
        points = rest.copy()
        goals = np.where(shares < GOAL, GOAL, np.minimum(shares + lack, 1.0))
        repair_triangles(points, NORMALS, SIZES, TRIANGLES, goals, 1)
        found.append(points)
    assert np.abs(found[1] - found[0]).max() < 1e-7


def test_a_triangle_may_be_allowed_to_turn_over() -> None:
    points = REST.copy()
    points[SIDE + 1] += [1.5e-3, 0.0, 0.0]
    before = points.copy()
    repair_triangles(points, NORMALS, SIZES, TRIANGLES, area_shares(points, NORMALS, SIZES, TRIANGLES), 16)
    assert np.array_equal(points, before)


def test_shares_are_one_at_rest_and_minus_one_turned_over() -> None:
    assert np.allclose(area_shares(REST, NORMALS, SIZES, TRIANGLES), 1.0)
    assert np.allclose(area_shares(REST * [-1.0, 1.0, 1.0], NORMALS, SIZES, TRIANGLES), -1.0)
