"""Directions of head and gaze are checked where they are made."""

import math
from dataclasses import FrozenInstanceError, fields, replace

import pytest
from msgspec import structs

from omote.perform.frame import DETAILS, Frame, Gaze, Head, MotionSettings, SpeechStatus, with_fields
from omote.show.objects.state import SpeechState


@pytest.mark.parametrize("angle", [math.nan, math.inf, 1.58, -1.58])
@pytest.mark.parametrize("name", ["yaw", "pitch", "roll"])
def test_a_direction_that_no_head_has_is_refused_by_name(name: str, angle: float) -> None:
    with pytest.raises(ValueError, match=rf"the head's {name} \(radians; 90 degrees at most\) is"):
        Head(**{name: angle})


@pytest.mark.parametrize("angle", [math.nan, -math.inf, 1.58, 0.7, -0.7])
@pytest.mark.parametrize("name", ["yaw", "pitch"])
def test_a_gaze_that_no_eye_has_is_refused_by_name(name: str, angle: float) -> None:
    with pytest.raises(ValueError, match=rf"the gaze's {name} \(radians; \d+ degrees at most\) is"):
        Gaze(**{name: angle})


def test_directions_are_kept_as_plain_floats() -> None:
    assert [type(angle) for angle in vars(Head(1, 0, -1)).values()] == [float] * 3


def test_a_frame_cannot_be_changed() -> None:
    with pytest.raises(FrozenInstanceError):
        Frame({"generic": 1.0}, {"neutral": 1.0}).time = 1.0  # type: ignore[misc]


def test_a_frame_with_other_fields_is_what_replace_gives_and_leaves_the_first() -> None:
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, panics=2)
    later = with_fields(frame, head=Head(0.1), time=2.0)
    assert later == replace(frame, head=Head(0.1), time=2.0)
    assert frame == Frame({"generic": 1.0}, {"neutral": 1.0}, panics=2)


def test_half_is_as_people_are_and_nothing_is_off() -> None:
    people = MotionSettings(0.5)
    still = MotionSettings()
    assert (people.blink_rate, people.reach, people.depth) == (1.0, 1.0, 1.0)
    assert (still.blink_rate, still.reach, still.depth) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("name", ["liveliness", *DETAILS])
@pytest.mark.parametrize("value", [-0.1, 2.1, math.nan, math.inf])
def test_what_is_out_of_range_is_rejected_by_name(name: str, value: float) -> None:
    with pytest.raises(ValueError, match=name):
        MotionSettings(**{name: value})  # type: ignore[arg-type]


@pytest.mark.parametrize("seed", [-1, 0.5, 2**31, math.nan])
def test_a_seed_is_a_whole_number(seed: float) -> None:
    with pytest.raises(ValueError, match="seed"):
        MotionSettings(seed=seed)  # type: ignore[arg-type]


def test_what_is_no_number_is_rejected() -> None:
    with pytest.raises(TypeError, match="liveliness"):
        MotionSettings("lively")  # type: ignore[arg-type]


def test_a_change_keeps_what_is_not_given() -> None:
    assert MotionSettings(0.5, gaze=0.2).change(liveliness=1.0, gaze=None) == MotionSettings(1.0, gaze=0.2)


def test_the_wire_has_every_field() -> None:
    assert [each.name for each in fields(SpeechStatus)] == [each.name for each in structs.fields(SpeechState)]
