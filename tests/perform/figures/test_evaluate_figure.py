"""The figure of a frame: it stands until something is called, and its head is the frame's, turned by neck and spine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import omote
from omote.perform.figures.evaluate_figure import turn_of
from omote.perform.frame import Frame, Head

CAST = omote.load_cast()
ROWS = CAST.space.vertex_count
STANDING = Frame({"kaori": 1.0}, {"neutral": 1.0})
ANGLES = st.floats(-0.5, 0.5)


def crown(rows: np.ndarray) -> np.ndarray:
    """The rows of the head that its bone alone moves."""
    assert CAST.figures is not None
    space = CAST.figures.space
    own = np.where(space.bones == space.skeleton.places["head"], space.weights, 0.0).sum(axis=1) > 1.0 - 1e-6
    return np.asarray(rows[:ROWS][own[:ROWS]], np.float64)


def test_it_stands_with_the_face_as_it_is_until_something_is_called() -> None:
    performer = omote.Performer(CAST)
    performer.call_face("kaori", seconds=0)
    standing = omote.evaluate_figure(CAST, performer.advance(0.1))
    assert standing.dtype == np.float32
    np.testing.assert_allclose(crown(standing), crown(omote.evaluate(CAST, STANDING)), atol=1e-6)
    performer.call_pose("bow", seconds=0)
    performer.call_body("child", seconds=0)
    bowed = omote.evaluate_figure(CAST, performer.advance(0.1))
    assert crown(bowed)[:, 1].mean() < crown(standing)[:, 1].mean() - 0.05
    assert bowed[:, 1].min() > standing[:, 1].min() + 0.2  # a child's legs, below the same face
    alone = np.array(omote.evaluate_figure(CAST, replace(STANDING, faces={"child": 1.0})))
    assert alone[:, 1].min() == pytest.approx(bowed[:, 1].min(), abs=0.1)


@settings(max_examples=20)
@given(ANGLES, ANGLES, ANGLES)
def test_the_head_turns_as_far_as_the_frame_says(yaw: float, pitch: float, roll: float) -> None:
    still = crown(omote.evaluate_figure(CAST, STANDING))
    moved = crown(omote.evaluate_figure(CAST, replace(STANDING, head=Head(yaw, 0.0, 0.0))))
    at, to = still - still.mean(axis=0), moved - moved.mean(axis=0)
    cosine, sine = np.cos(yaw), np.sin(yaw)
    turned = at @ np.array([[cosine, 0.0, -sine], [0.0, 1.0, 0.0], [sine, 0.0, cosine]])
    np.testing.assert_allclose(to, turned, atol=2e-6)
    assert np.sign(turn_of(Head(0.0, pitch, 0.0))[0]) == -np.sign(pitch)  # up is back
    assert np.linalg.norm(turn_of(Head(0.0, 0.0, roll))) == pytest.approx(abs(roll))


def test_a_cast_without_bodies_says_so() -> None:
    with pytest.raises(ValueError, match="has no bodies and poses"):
        omote.evaluate_figure(replace(CAST, figures=None), STANDING)
