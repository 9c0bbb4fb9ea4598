"""Sockets: lids come to the height over the ball that is asked for, and nothing far from an eye moves."""

from __future__ import annotations

import numpy as np

from omote.model.space.eye_socket import FAR, NEAR, ball_heights, move_ball, radius_of, set_ball_heights
from tests.synthetic import space


def rest() -> dict[str, np.ndarray]:
    return {name: ball_heights(space().points, part.points) for name, part in space().parts.items() if part.eye}


def test_a_head_that_is_only_larger_is_left_alone() -> None:
    parts = {name: space().parts[name].points * 1.3 for name in rest()}
    assert np.allclose(set_ball_heights(space().points * 1.3, parts, rest()), space().points * 1.3, atol=1e-12)


def test_near_skin_gets_its_height_over_a_swollen_ball_and_far_skin_stays() -> None:
    for name, wanted in rest().items():
        ball = space().parts[name].points
        swollen = ball.mean(axis=0) + (ball - ball.mean(axis=0)) * 1.4
        result = set_ball_heights(space().points, {name: swollen}, {name: wanted})
        near = wanted <= NEAR
        far = wanted >= FAR
        assert far.any()
        assert np.array_equal(result[far], space().points[far])
        after = ball_heights(result, swollen)
        before = ball_heights(space().points, swollen)
        assert np.allclose(after[near], wanted[near], atol=1e-12)
        between = ~near & ~far
        assert between.any()
        assert (before - 1e-12 <= after)[between].all()
        assert (after <= wanted + 1e-12)[between].all()


def test_the_radius_of_a_ball_is_how_far_its_vertices_are_from_their_centre() -> None:
    octahedron = np.concatenate([np.eye(3), -np.eye(3)])
    assert np.isclose(radius_of(0.015 * octahedron + [1.0, 2.0, 3.0]), 0.015)


def test_heights_are_counted_in_radii() -> None:
    octahedron = np.concatenate([np.eye(3), -np.eye(3)])
    assert np.allclose(ball_heights(0.04 * octahedron + 1.0, 0.02 * octahedron + 1.0), 2.0)


def test_a_rolled_ball_goes_and_grows_with_another_and_stays_round() -> None:
    octahedron = np.concatenate([np.eye(3), -np.eye(3)])
    before = 0.02 * octahedron
    ball = 0.03 * octahedron + 1.0
    after = before * [1.0, 2.0, 3.0] + [0.0, 0.1, 0.0]
    result = move_ball(ball, before, after)
    larger = np.sqrt((1.0 + 4.0 + 9.0) / 3.0)
    assert np.allclose(result, 0.03 * larger * octahedron + [1.0, 1.1, 1.0])
    assert np.allclose(move_ball(ball, before, before), ball)
