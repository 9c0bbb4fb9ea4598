"""Depth maps: of what juts out alone, the same about any axes, turned as the surface is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.depth_maps import RINGS, TURNS, compare_maps, find_turn, make_maps
from tests.model.fitting.placed_heads import degrees_between, turn_by

PEAK = np.zeros((1, 3))


def _hill(depth: float = 0.6, ridge: float = 0.3) -> NDArray[np.float64]:
    """A cone with a ridge to one side, its peak at the origin along +z."""
    x, y = (part.ravel() for part in np.meshgrid(np.arange(-0.07, 0.07, 0.003), np.arange(-0.07, 0.07, 0.003)))
    radius = np.hypot(x, y)
    angle = np.arctan2(y, x)
    return np.stack([x, y, -radius * (depth - ridge * np.cos(angle))], axis=1)


def test_a_peak_has_a_map_and_a_plain_none() -> None:
    assert len(make_maps(_hill(), PEAK).points) == 1
    assert len(make_maps(_hill(depth=0.0, ridge=0.0), PEAK).points) == 0
    assert len(make_maps(_hill(), np.ones((1, 3))).points) == 0


def test_the_axis_turns_with_the_surface() -> None:
    turn = turn_by(4)
    plain = make_maps(_hill(), PEAK)
    turned = make_maps(_hill() @ turn.T, PEAK)
    assert np.allclose(plain.frames[0, 2] @ turn.T, turned.frames[0, 2], atol=1e-9)
    assert np.allclose(turned.frames[0] @ turned.frames[0].T, np.eye(3))


def test_a_map_is_like_itself_however_the_surface_is_turned() -> None:
    wanted = make_maps(_hill(), PEAK)
    for seed in range(4):
        turned = make_maps(_hill() @ turn_by(seed).T, PEAK)
        alike = compare_maps(turned.depths, wanted.depths[0])
        assert alike.distance[0] < 0.003
        angle = alike.turn[0] * 2.0 * np.pi / TURNS
        first, second, axis = turned.frames[0]
        across = np.cos(angle) * first + np.sin(angle) * second
        back = wanted.frames[0].T @ np.stack([across, np.cross(axis, across), axis])
        assert degrees_between(back, turn_by(seed).T) < 15.0


def test_a_map_is_unlike_another_shape() -> None:
    wanted = make_maps(_hill(), PEAK).depths
    same = compare_maps(wanted, wanted[0])
    other = compare_maps(make_maps(_hill(ridge=-0.55), PEAK).depths, wanted[0])
    straight = compare_maps(make_maps(_hill(depth=1.2), PEAK).depths, wanted[0])
    assert np.isclose(same.distance[0], 0.0, atol=1e-9)
    assert same.turn[0] == 0
    assert straight.distance[0] > 0.004
    assert other.distance[0] > same.distance[0]
    assert wanted.shape == (1, RINGS * TURNS)


def test_turns_that_are_barred_are_not_asked() -> None:
    wanted = make_maps(_hill(), PEAK).depths
    first = compare_maps(wanted, wanted[0])
    other = compare_maps(wanted, wanted[0], barred=first.turn)
    away = (other.turn - first.turn) % TURNS
    assert min(away[0], TURNS - away[0]) >= TURNS // 4
    assert other.distance[0] > first.distance[0]


def test_turns_are_those_of_the_arc_tangent() -> None:
    ways = np.random.default_rng(0).normal(size=(2000, 2))
    angles = np.arctan2(ways[:, 1], ways[:, 0])
    expected = ((angles + np.pi) / (2.0 * np.pi) * TURNS).astype(int) % TURNS
    assert [find_turn(u, v) for u, v in ways] == expected.tolist()
    assert all(0 <= find_turn(u, v) < TURNS for u in (-1.0, 0.0, 1.0) for v in (-1.0, 0.0, 1.0))
