"""Angles without the platform's functions agree with them to a millionth of a degree."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion.angles import angle_of, sine_cosine, wrap_angle

LENGTHS = st.floats(-50.0, 50.0)


@given(LENGTHS, LENGTHS)
def test_the_angle_of_a_direction_is_the_arc_tangents(across: float, ahead: float) -> None:
    difference = angle_of(across, ahead) - math.atan2(across, ahead)
    assert abs(math.remainder(difference, math.tau)) < 1e-8


@given(st.floats(-30.0, 30.0))
def test_sine_and_cosine_are_the_platforms(angle: float) -> None:
    sine, cosine = sine_cosine(angle)
    assert sine == pytest.approx(math.sin(angle), abs=1e-8)
    assert cosine == pytest.approx(math.cos(angle), abs=1e-8)


@given(st.floats(-1000.0, 1000.0))
def test_a_wrapped_angle_is_the_same_direction_within_half_a_turn(angle: float) -> None:
    assert -math.pi - 1e-9 <= wrap_angle(angle) <= math.pi + 1e-9
    assert abs(math.remainder(wrap_angle(angle) - angle, math.tau)) < 1e-9


def test_no_direction_is_straight_ahead() -> None:
    assert angle_of(0.0, 0.0) == 0.0
