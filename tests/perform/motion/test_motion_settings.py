"""What an operator sets of automatic motion."""

import math

import pytest

from omote.perform.motion.motion_settings import DETAILS, MotionSettings


def test_half_is_as_people_are_and_nothing_is_off() -> None:
    people, still = MotionSettings(0.5), MotionSettings()
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
