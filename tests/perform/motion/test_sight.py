"""What eyes look at, as the body sees it."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import GazeTarget
from omote.perform.motion.sight import (
    NOTHING,
    PUPIL_METRES,
    angle_of,
    eyes_of,
    sight_alone,
    sight_of_direction,
    sight_of_point,
    sine_cosine,
    wrap_angle,
)
from omote.perform.performer import Performer

TURNS = st.floats(-math.pi, math.pi)


@given(TURNS, st.floats(-1.5, 1.5), st.floats(0.3, 5.0), st.floats(-1.0, 1.0))
def test_a_point_is_where_it_lies_whatever_way_the_body_stands(body: float, yaw: float, far: float, up: float) -> None:
    """From the body, the direction points at it again."""
    eyes = eyes_of(0.4, 0.2, 1.0, body)
    wanted = (eyes[0] + far * math.sin(body + yaw), eyes[1] + up, eyes[2] + far * math.cos(body + yaw))
    sight = sight_of_point(wanted, eyes, body=body, size=1.0)
    assert sight.turn.yaw == pytest.approx(yaw, abs=1e-6)
    assert sight.turn.pitch == pytest.approx(math.atan2(up, far), abs=1e-6)


@given(st.floats(0.2, 10.0), st.floats(0.5, 2.0))
def test_eyes_converge_more_the_nearer_it_is_and_the_farther_apart_they_are(far: float, size: float) -> None:
    eyes = eyes_of(0.0, 0.0, size, 0.0)
    near, farther = (
        sight_of_point((0.0, 0.0, eyes[2] + each), eyes, body=0.0, size=size).vergence for each in (far, 2.0 * far)
    )
    assert near == pytest.approx(math.atan2(PUPIL_METRES * size, far))
    assert near > farther > 0.0


@given(TURNS, TURNS)
def test_a_direction_of_the_house_stays_there_when_the_body_turns(body: float, yaw: float) -> None:
    seen = sight_of_direction(GazeTarget("direction", yaw=yaw), body=body)
    assert abs(math.remainder(seen.turn.yaw + body - yaw, math.tau)) < 1e-9
    assert seen.vergence == 0.0


def test_alone_there_are_no_others_and_no_cameras() -> None:
    assert sight_alone(GazeTarget("character", "two")) == sight_alone(GazeTarget("stage")) == NOTHING
    assert sight_alone(GazeTarget("point", x=1.0)).turn.yaw > 0.3


@pytest.mark.parametrize("near", [0.4, 0.6])
def test_on_air_each_eye_points_at_a_near_point(cast: Cast, near: float) -> None:
    performer = Performer(cast)
    performer.look_at("point", x=0.0, z=near)
    for _ in range(240):
        frame = performer.advance(1 / 60)
    inward = math.atan2(PUPIL_METRES, near - eyes_of(0.0, 0.0, 1.0, 0.0)[2])
    turned = frame.channels["eyeLookInLeft"] * abs(cast.expressions["eyeLookInLeft"].eye_turns[0])
    assert turned == pytest.approx(inward, rel=0.02)
    assert frame.channels["eyeLookInRight"] == pytest.approx(frame.channels["eyeLookInLeft"], rel=0.02)


@pytest.mark.parametrize(
    ("given_target", "match"),
    [
        ({"kind": "nowhere"}, "kind of what eyes look at"),
        ({"kind": "direction", "yaw": 4.0}, "yaw of what eyes look at"),
        ({"kind": "point", "z": math.nan}, "z of what eyes look at"),
        ({"kind": "stage", "name": "x" * 81}, "80 letters at most"),
    ],
)
def test_what_nobody_can_look_at_is_rejected(cast: Cast, given_target: dict[str, object], match: str) -> None:
    with pytest.raises(ValueError, match=match):
        Performer(cast).look_at(**given_target)  # type: ignore[arg-type]


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
