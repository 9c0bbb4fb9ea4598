"""Poses in words, before a cast is there: what is meant comes out, and numbers out of range do not."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.stage_data.pose_words import (
    merge_names,
    read_angles,
    read_channels,
    read_expression_mix,
    read_mix,
    read_pose,
)


def test_names_without_a_weight_share_what_is_left() -> None:
    assert dict(read_mix("kaori", "face")) == {"kaori": 1.0}
    assert dict(read_mix("kaori+dog", "face")) == {"kaori": 0.5, "dog": 0.5}
    assert dict(read_mix(" kaori = 0.25 + dog ", "face")) == {"kaori": 0.25, "dog": 0.75}


def test_a_channel_without_a_weight_is_full() -> None:
    assert dict(read_channels("jawOpen+smile=-0.25")) == {"jawOpen": 1.0, "smile": -0.25}


def test_angles_are_degrees_and_may_be_left_out() -> None:
    assert read_angles("", "turn", HEAD_LIMITS) == []
    assert read_angles("30, -45", "turn", HEAD_LIMITS) == [math.radians(30), math.radians(-45)]


@given(st.floats(0.0, 1.0))
def test_expressions_weigh_what_is_written(weight: float) -> None:
    assert dict(read_expression_mix(f"smile={weight!r}")) == {"smile": weight}
    assert dict(read_expression_mix(f"smile={weight!r}+sad")) == {"smile": weight, "sad": 1.0 - weight}


def test_a_gaze_may_go_to_its_limit_and_no_farther() -> None:
    for place, (name, limit) in enumerate(GAZE_LIMITS.items()):
        degrees = math.degrees(limit)
        for sign in (-1, 1):
            text = ",".join(["0"] * place + [f"{sign * degrees:.6f}"])
            assert getattr(read_pose(gaze=text).gaze, name) == pytest.approx(sign * limit, abs=1e-7)
            with pytest.raises(ValueError, match=rf"the gaze's {name} \(degrees\) is"):
                read_pose(gaze=",".join(["0"] * place + [str(sign * (degrees + 0.1))]))


def test_a_name_that_is_meant_twice_is_refused() -> None:
    with pytest.raises(ValueError, match="the face 'kaori' comes twice"):
        merge_names((("kaori", 0.5), ("Kaori", 0.5)), {"kaori": None}, "face")
