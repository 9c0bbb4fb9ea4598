"""Clearance: what lies too deep in an eyeball goes out, smoothly, and nothing else moves."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.transfer.eyeball_clearance import (
    Clearance,
    Eyeball,
    build_clearance,
    clear_eyeball,
    measure_depth,
)

BALL = Eyeball(np.zeros(3), 0.015)


def cap(radius: float, side: int = 21) -> tuple[np.ndarray, np.ndarray]:
    """A patch of skin (V, 3) in front of a ball at the origin, at a distance from its centre, and its triangles."""
    across = np.linspace(-0.7, 0.7, side)
    yaw, pitch = (grid.ravel() for grid in np.meshgrid(across, across))
    points = np.stack([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)], axis=1)
    a = (np.arange(side - 1) + side * np.arange(side - 1)[:, None]).ravel()
    one = np.stack([a, a + 1, a + side], axis=1)
    other = np.stack([a + 1, a + side + 1, a + side], axis=1)
    return radius * points, np.concatenate([one, other]).astype(np.int32)


def lids(source: float, face: float) -> tuple[np.ndarray, np.ndarray, Clearance]:
    (generic, triangles) = cap(source)
    (positions, _) = cap(face)
    return generic, positions, build_clearance(generic, positions, triangles, BALL, BALL)


@given(st.floats(0.0152, 0.02), st.floats(1e-6, 0.003))
def test_no_lid_lies_deeper_than_at_rest_and_as_on_the_source(face: float, dent: float) -> None:
    generic, positions, clearance = lids(0.016, face)
    middle = int(positions[:, 2].argmax())
    pressed = positions.copy()
    pressed[middle] *= (BALL.radius - dent) / face
    moved = generic.copy()
    moved[middle] *= (BALL.radius - 0.4 * dent) / 0.016
    assert clear_eyeball(clearance, pressed, moved)
    assert measure_depth(BALL, pressed).max() <= 0.4 * dent + 1e-12


def test_what_lay_in_the_ball_at_rest_may_stay_there() -> None:
    generic, positions, clearance = lids(0.016, 0.014)
    still = positions.copy()
    assert not clear_eyeball(clearance, still, generic)
    assert np.array_equal(still, positions)


def test_what_lay_less_deep_at_rest_than_on_the_source_stays_so_where_the_source_stays() -> None:
    generic, positions, clearance = lids(0.0146, 0.0149)  # .4 mm deep there, .1 mm here
    pressed = positions * (0.0147 / 0.0149)
    assert clear_eyeball(clearance, pressed, generic)
    assert np.allclose(pressed, positions, atol=1e-12)


def test_a_push_leaves_no_vertex_standing_out() -> None:
    generic, positions, clearance = lids(0.016, 0.0151)
    middle = int(positions[:, 2].argmax())
    pressed = positions.copy()
    pressed[middle] *= 0.013 / 0.0151
    before = pressed.copy()
    clear_eyeball(clearance, pressed, generic)
    step = np.linalg.norm(pressed - before, axis=1)
    around = np.argsort(np.linalg.norm(positions - positions[middle], axis=1))[1:5]
    assert step[middle] == pytest.approx(0.002)
    assert (step[around] > 0.5 * step[middle]).all()
    far = np.linalg.norm(positions - positions[middle], axis=1) > 0.012
    assert (step[far] == 0).all()


@pytest.mark.parametrize(
    ("centre", "radius", "sentence"),
    [(np.zeros(2), 0.01, "three finite numbers"), (np.array([0, 0, np.nan]), 0.01, "three finite numbers"),
     (np.zeros(3), 0.0, "positive number of metres"), (np.zeros(3), np.inf, "positive number of metres")],
)  # fmt: skip
def test_what_is_no_ball_is_refused(centre: np.ndarray, radius: float, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        Eyeball(centre, radius)
