"""Sides: what is above and below an opening, and that no net joins the two."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import build_net_field
from omote.model.controls.upper_lower import clamp_weights, is_across, nearest_own_side, sides
from omote.model.space.lid_lip_lines import chains
from tests import synthetic


def test_lids_and_lips_have_two_sides_and_mirror_each_other() -> None:
    space = omote.load_cast().space
    found = dict(zip((line.name for line in space.lines), sides(space), strict=True))
    for line in space.lines:
        upper, lower = chains(space.points, line.loop)
        assert (found[line.name][upper[2:-2]] == 1).all()
        assert (found[line.name][lower[2:-2]] == -1).all()
    assert (found["lid_left"] != 0).sum() == (found["lid_right"] != 0).sum()
    assert not np.array(list(found.values()))[:, ~space.on_sheet].any()


def test_a_head_without_lines_has_no_sides() -> None:
    assert sides(synthetic.space()).shape == (0, synthetic.space().vertex_count)


@given(st.integers(0, 400))
def test_whatever_points_an_artist_takes_no_vertex_is_moved_from_across_an_opening(seed: int) -> None:
    """Also where the points of a lip's edge are taken away."""
    space = omote.load_cast().space
    random = np.random.default_rng(seed)
    rows = random.choice(np.array(default_net(space)), 80, replace=False)
    made = build_net_field(space, [int(row) for row in rows])
    sheet = np.flatnonzero(space.on_sheet)
    side = sides(space)
    corners = made.net.corners[sheet]
    weights = made.net.weights[sheet]
    own = corners < len(rows)
    of_corners = np.where(own, side[:, rows[np.where(own, corners, 0)]], 0)
    across = side[:, sheet][..., None] * of_corners < 0
    assert not np.where(across.any(axis=0), weights, 0.0).any()


def test_the_nearest_triangle_of_its_own_side_is_carried_on_beyond_its_edge() -> None:
    points = np.array([[1, 1, 1, -1, -1]], np.int8)
    place = np.array([[0.0, 1.0], [1.0, 1.0], [0.5, 2.0], [0.0, 0.0], [1.0, 0.0]])
    triangles = np.array([[0, 1, 2], [3, 4, 1], [3, 1, 0]], np.int32)
    vertex = np.array([[1]], np.int8)
    assert is_across(np.array([1], np.int8), points[:, triangles]).tolist() == [False, True, True]
    assert nearest_own_side(vertex, points, triangles, place[triangles], np.array([[0.5, 0.9]])).tolist() == [0]
    assert nearest_own_side(-vertex, points, triangles, place[triangles], np.array([[0.5, 0.1]])).tolist() == [-1]


def test_what_lies_far_beyond_an_edge_goes_with_it() -> None:
    weights = clamp_weights(np.array([[0.6, 0.6, -0.2], [0.9, 0.9, -0.8]]))
    assert np.allclose(weights, [[0.6, 0.6, -0.2], [0.5, 0.5, 0.0]])
