"""Goals of the parts of characters and of the scene."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.axis import Axis, called, weights
from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    SCENE_PARTS,
    WITH_FACE,
    called_mix,
    check_goal,
    check_names,
    expression_of,
    goal_of_axis,
    ranges_of,
    regions_of,
    standing_mix,
)

PARTS = (*(f"one/{part}" for part in CHARACTER_PARTS), *(f"*/{part}" for part in SCENE_PARTS))


def test_a_mix_that_shows_is_kept_without_what_is_less_than_nothing() -> None:
    assert standing_mix({"a": 1.05, "b": -0.05}) == {"a": 1.0}
    assert sum(standing_mix({"a": 0.5, "b": 0.6, "c": -0.1}).values()) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("part", "goal", "reason"),
    [
        ("one/tail", {}, "there is no part 'one/tail'; expected CHARACTER/face"),
        ("one/light", {}, "there is no part 'one/light'"),
        ("face", {}, "there is no part 'face'"),
        ("one/head", {"yaw": 0.0}, "the goal of one/head has yaw; expected yaw, pitch, roll"),
        ("*/black", {"black": 2.0}, r"black of \*/black is 2.0; give a number from 0 to 1"),
        ("one/face", {"a": 0.5}, "the weights of one/face sum to 0.5"),
        ("one/face", {}, "the weights of one/face sum to 0"),
    ],
)
def test_what_no_part_can_go_to_is_rejected(part: str, goal: dict[str, float], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        check_goal(part, goal)


def test_a_name_that_there_is_not_is_rejected() -> None:
    with pytest.raises(ValueError, match="there is no face 'c'"):
        check_names({"a": 0.5, "c": 0.5}, ["a", "b"], "face")


def test_a_region_goes_with_its_face_alone_and_a_face_takes_all_of_its_regions() -> None:
    for part in PARTS:
        whole = expression_of(part)
        assert whole is None or part in regions_of(whole)
        assert (whole is not None) == (ranges_of(part) is None and part in regions_of("one/expression"))
    assert check_goal("one/brows", WITH_FACE) == WITH_FACE


@given(st.floats(0.0, 5.0), st.floats(0.05, 3.0), st.sampled_from([{"b": 1.0}, {"a": 0.25, "b": 0.75}]))
def test_an_axis_comes_to_the_goal_that_it_is_called_to(begun: float, seconds: float, goal: dict[str, float]) -> None:
    on = called_mix(called(Axis("a"), "c", begun, "smooth"), goal, seconds, "smooth")
    assert goal_of_axis(on) == goal
    cut = called_mix(on, goal, 0.0, "smooth")
    assert weights(cut) == goal_of_axis(cut) == goal
