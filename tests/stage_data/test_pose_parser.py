"""Poses in words: what is meant comes out, what makes no sense is refused with a sentence that names it."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.model.cast import Cast
from omote.stage_data.pose_parser import parse_pose, pose_of


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
        ({"channel": "jawOpen=9"}, "weight in 'jawOpen=9'"),
        ({"light": "noon"}, "no light 'noon'"),
        ({"turn": "1,2,3,4"}, "has 4 angles"),
        ({"turn": "left"}, "the turn's yaw is 'left', which is no number"),
        ({"turn": "120"}, "the turn's yaw (degrees) is 120.0; give a number from -90 to 90"),
        ({"gaze": "80"}, "the gaze's yaw (degrees) is 80.0; give a number from -40 to 40"),
        ({"gaze": "0,-31"}, "the gaze's pitch (degrees) is -31.0; give a number from -30 to 30"),
        ({"face": "=0.5"}, "is a weight of no face"),
        ({"gaze": "1,2,3"}, "has 3 angles"),
    ],
)
def test_what_makes_no_sense_is_refused(cast: Cast, words: dict[str, str], named: str) -> None:
    with pytest.raises(ValueError, match=r".") as refused:
        parse_pose(cast, **words)
    assert named in str(refused.value)


@given(st.floats(0.0, 1.0))
def test_what_is_left_of_the_expressions_is_neutral(cast: Cast, weight: float) -> None:
    found = parse_pose(cast, expression=f"smile={weight!r}").expressions
    assert sum(found.values()) == pytest.approx(1.0, abs=2e-6)
    assert found["smile"] == weight
    assert parse_pose(cast, expression="").expressions == {"neutral": 1.0}


def test_a_pose_is_what_a_stage_would_be_told(cast: Cast) -> None:
    pose = pose_of(
        cast, parse_pose(cast, expression="smile=0.5", channel="jawOpen=0.5", turn="30,0,5", gaze="10", light="flat")
    )
    assert pose["light"] == {"flat": 1.0}
    assert pose["faces"] == {"generic": 1.0}
    assert pose["expressions"] == {"smile": 0.5, "neutral": 0.5}
    assert pose["channels"] == {"jawOpen": 0.5}
    assert pose["head"] == pytest.approx([math.radians(30), 0.0, math.radians(5)])
    assert pose["gaze"] == pytest.approx([math.radians(10), 0.0])


@pytest.mark.parametrize("name", ["face", "expression", "channel", "turn", "gaze", "light"])
@pytest.mark.parametrize("value", [(30, -5), 30.0, None, {"smile": 0.5}, b"old"])
def test_what_is_no_text_is_refused_with_how_it_is_written(cast: Cast, name: str, value: object) -> None:
    with pytest.raises(TypeError, match=f"{name} must be text, not .*; write {name}='"):
        parse_pose(cast, **{name: value})  # type: ignore[arg-type]


def test_a_figure_does_what_its_poses_weigh_and_stands_without_any() -> None:
    cast = omote.load_cast()
    assert parse_pose(cast).figure is None
    figure = parse_pose(cast, pose="Bow=0.25+wave").figure
    assert figure is not None
    assert figure.poses == {"bow": 0.25, "wave": 0.75}
    assert pose_of(cast, parse_pose(cast, pose="bow"))["figure"]["poses"] == {"bow": 1.0}
    with pytest.raises(ValueError, match="no pose 'wafe'"):
        parse_pose(cast, pose="wafe")
