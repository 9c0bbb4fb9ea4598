"""Angles of heads and eyes: each convention is checked against matrices, and its signs against what is known."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.rejection import PacketError
from omote.inputs.trackers import head_angles
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from tests.inputs.trackers.packets import head_matrix, quaternion

ANGLE = st.floats(-1.4, 1.4)
HEADS = st.tuples(ANGLE, ANGLE, ANGLE)
UNITY = np.diag([-1.0, 1.0, 1.0])
"""From our axes to Unity's: its x is the performer's right."""


@given(HEADS)
def test_a_quaternion_about_our_axes_is_the_stage_s_turn(head: tuple[float, float, float]) -> None:
    x, y, z, w = quaternion(head_matrix(*head))
    assert head_angles.read_quaternion((x, y, z, w)) == pytest.approx(head, abs=1e-6)


@given(HEADS, st.floats(0.1, 10.0))
def test_a_quaternion_of_unity_is_mirrored_in_x_whatever_its_length(
    head: tuple[float, float, float], length: float
) -> None:
    x, y, z, w = quaternion(UNITY @ head_matrix(*head) @ UNITY)
    made = (length * x, length * y, length * z, length * w)
    assert head_angles.read_unity_quaternion(made) == pytest.approx(head, abs=1e-6)


@given(HEADS)
def test_what_is_written_for_unity_is_read_as_it_was(head: tuple[float, float, float]) -> None:
    assert head_angles.read_unity_quaternion(head_angles.write_unity_quaternion(head)) == pytest.approx(head, abs=1e-9)


@given(HEADS, HEADS)
def test_quaternions_multiply_as_matrices_do(
    first: tuple[float, float, float], second: tuple[float, float, float]
) -> None:
    (ax, ay, az, aw) = quaternion(head_matrix(*first))
    (bx, by, bz, bw) = quaternion(head_matrix(*second))
    both = head_angles.read_quaternion(head_angles.multiply_quaternions((ax, ay, az, aw), (bx, by, bz, bw)))
    assert np.allclose(head_matrix(*both), head_matrix(*first) @ head_matrix(*second), atol=1e-6)


@pytest.mark.parametrize("wrong", [(0.0,) * 4, (math.nan, 0.0, 0.0, 1.0), (math.inf, 0.0, 0.0, 1.0)])
def test_what_is_no_rotation_is_rejected(wrong: tuple[float, float, float, float]) -> None:
    with pytest.raises(PacketError, match="no quaternion"):
        head_angles.read_quaternion(wrong)


def test_the_vendor_s_example_looks_left_and_down() -> None:
    """iFacialMocap's own packet: eyeLookOut_L 44, eyeLookIn_R 54, eyeLookDown 16 with these angles of the eyes."""
    yaw, pitch, _ = head_angles.read_right_handed_degrees(5.5607924, 15.616646, 1.5515244)
    assert yaw > 0.0 > pitch


@given(ANGLE, ANGLE)
def test_a_direction_has_the_angles_that_turn_straight_ahead_to_it(yaw: float, pitch: float) -> None:
    direction = head_matrix(yaw, pitch, 0.0) @ (0.0, 0.0, 2.0)
    assert head_angles.read_direction(direction.tolist()) == pytest.approx((yaw, pitch), abs=1e-9)


def test_no_direction_has_no_angles() -> None:
    assert head_angles.read_direction((0.0, 0.0, 0.0)) is None
    assert head_angles.read_direction((math.nan, 0.0, 1.0)) is None


def test_the_gaze_is_the_mean_of_the_eyes_that_are_known() -> None:
    assert head_angles.average_eyes([(0.2, 0.1), (0.0, 0.3)]) == pytest.approx((0.1, 0.2))
    assert head_angles.average_eyes([None, (0.5, 0.0)]) == (0.5, 0.0)
    assert head_angles.average_eyes([None, None]) is None


@given(st.lists(st.floats(-1e6, 1e6), min_size=5, max_size=5))
def test_angles_end_where_ours_do(angles: list[float]) -> None:
    head = head_angles.limit_head((angles[0], angles[1], angles[2]))
    gaze = head_angles.limit_gaze((angles[3], angles[4]))
    assert all(abs(angle) <= most for angle, most in zip(head, HEAD_LIMITS.values(), strict=True))
    assert all(abs(angle) <= most for angle, most in zip(gaze, GAZE_LIMITS.values(), strict=True))
    assert head_angles.limit_head((0.3 + 4.0 * math.pi, 0.0, 0.0))[0] == pytest.approx(0.3)
