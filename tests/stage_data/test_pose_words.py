"""Poses in words, before a cast is there: what is meant comes out, and numbers out of range do not."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.stage_data.picture_request import RenderRequest
from omote.stage_data.pose_words import (
    merge_names,
    read_angles,
    read_channels,
    read_expression_mix,
    read_mix,
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
            assert getattr(RenderRequest(gaze=text).words.gaze, name) == pytest.approx(sign * limit, abs=1e-7)
            with pytest.raises(ValueError, match=rf"the gaze's {name} \(degrees\) is"):
                _ = RenderRequest(gaze=",".join(["0"] * place + [str(sign * (degrees + 0.1))])).words


def test_a_name_that_is_meant_twice_is_refused() -> None:
    with pytest.raises(ValueError, match="the face 'kaori' comes twice"):
        merge_names((("kaori", 0.5), ("Kaori", 0.5)), {"kaori": None}, "face")


def test_commas_are_told_apart() -> None:
    with pytest.raises(ValueError, match=r"mixes of faces are written with \+, .*; write kaori=0\.5\+dog=0\.5 for"):
        read_mix("kaori=0.5, dog=0.5", "face")
    with pytest.raises(ValueError, match=r"in 'kaori=0,5' the weight has a comma; .* kaori=0\.5$"):
        read_mix("kaori=0,5+dog", "face")
    with pytest.raises(ValueError, match=r"there is no face 'kaori, dog'.*; mixes are written with \+, as in a\+b"):
        merge_names((("kaori, dog", 1.0),), {"kaori": None, "dog": None}, "face")
    assert merge_names((("Blink, left", 1.0),), {"blink": None}, "channel", {"blink": "Blink, left"}) == {"blink": 1.0}


def test_both_halves_of_a_unit_are_channels_and_no_mix() -> None:
    names = {"eyeBlinkLeft": None, "eyeBlinkRight": None}
    assert merge_names((("AU45", 0.7),), names, "channel") == {"eyeBlinkLeft": 0.7, "eyeBlinkRight": 0.7}
    with pytest.raises(ValueError, match="AU45 is eyeBlinkLeft and eyeBlinkRight together; write one of them"):
        merge_names((("AU45", 0.7),), names, "expression")
    with pytest.raises(ValueError, match="the channel 'eyeBlinkLeft' comes twice"):
        merge_names((("blink", 0.7), ("L45", 0.1)), names, "channel")
