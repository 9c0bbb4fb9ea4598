"""Directions of head and gaze are checked where they are made."""

import math
from dataclasses import FrozenInstanceError, replace

import pytest

from omote.perform.frame import Frame, Gaze, Head, with_fields


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
