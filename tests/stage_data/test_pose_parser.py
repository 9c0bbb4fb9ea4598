"""Poses in words: what is meant comes out, what makes no sense is refused with a sentence that names it."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.stage_data.pose_parser import (
    parse_angles,
    parse_channels,
    parse_expression_mix,
    parse_mix,
    parse_pose,
    pose_of,
)

NAMES = ("neutral", "smile", "sad", "jawOpen")
FACES = ("generic", "kaori", "dog")


def test_names_without_a_weight_share_what_is_left() -> None:
    assert parse_mix("kaori", FACES, "face") == {"kaori": 1.0}
    assert parse_mix("kaori+dog", FACES, "face") == {"kaori": 0.5, "dog": 0.5}
    assert parse_mix(" kaori = 0.25 + dog ", FACES, "face") == {"kaori": 0.25, "dog": 0.75}


def test_what_is_left_of_the_expressions_is_neutral() -> None:
    assert parse_expression_mix("", NAMES) == {"neutral": 1.0}
    assert parse_expression_mix("smile=0.75", NAMES) == {"smile": 0.75, "neutral": 0.25}
    assert parse_expression_mix("smile=0.75+sad", NAMES) == {"smile": 0.75, "sad": 0.25}


@given(st.floats(0.0, 1.0))
def test_a_mix_of_expressions_sums_to_one(weight: float) -> None:
    assert sum(parse_expression_mix(f"smile={weight!r}", NAMES).values()) == pytest.approx(1.0, abs=2e-6)


def test_a_channel_without_a_weight_is_full() -> None:
    assert parse_channels("jawOpen+smile=-0.25", NAMES) == {"jawOpen": 1.0, "smile": -0.25}


def test_angles_are_degrees_and_may_be_left_out() -> None:
    assert parse_angles("", 3, "turn") == []
    assert parse_angles("30, -45", 3, "turn") == [math.radians(30), math.radians(-45)]


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ({"face": "nobody"}, "no face 'nobody'"),
        ({"face": "generic=0.5"}, "weigh 0.5 together"),
        ({"face": "generic=x"}, "in 'generic=x' 'x' is no number"),
        ({"face": "generic=nan"}, "weight in 'generic=nan'"),
        ({"face": "generic+generic"}, "comes twice"),
        ({"expression": "grin"}, "no expression 'grin'"),
        ({"expression": "smile=0.8+jawOpen=0.8"}, "weigh 1.6 together"),
        ({"channels": "jawOpen=9"}, "weight in 'jawOpen=9'"),
        ({"light": "noon"}, "no light 'noon'"),
        ({"turn": "1,2,3,4"}, "has 4 angles"),
        ({"turn": "left"}, "'left' is no number"),
        ({"turn": "120"}, "turn (degrees)"),
        ({"gaze": "1,2,3"}, "has 3 angles"),
    ],
)
def test_what_makes_no_sense_is_refused(cast: Cast, words: dict[str, str], named: str) -> None:
    with pytest.raises(ValueError, match=r".") as refused:
        parse_pose(cast, **words)
    assert named in str(refused.value)


def test_a_pose_is_what_a_stage_would_be_told(cast: Cast) -> None:
    pose = pose_of(
        cast, parse_pose(cast, expression="smile=0.5", channels="jawOpen=0.5", turn="30,0,5", gaze="10", light="flat")
    )
    assert pose["light"] == {"flat": 1.0}
    assert pose["faces"] == {"generic": 1.0}
    assert pose["expressions"] == {"smile": 0.5, "neutral": 0.5}
    assert pose["channels"] == {"jawOpen": 0.5}
    assert pose["head"] == pytest.approx([math.radians(30), 0.0, math.radians(5)])
    assert pose["gaze"] == pytest.approx([math.radians(10), 0.0])
