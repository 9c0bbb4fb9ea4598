"""The table of units and recipes."""

import numpy as np
import pytest

from omote.model.space.complexion import Complexion
from omote.perform.springs.cast_springs import SPRINGS as PLAYED_SPRINGS
from tools.baking.expressions import (
    ARKIT,
    COMPLEXIONS,
    EARS,
    HEADS,
    MAKEHUMAN,
    OMOTE,
    PERFORMED,
    PUPILS,
    SPRING_EARS,
    SPRINGS,
    ear_turns,
    head_turn,
    region,
    unit_weights,
)  # fmt: skip


def test_no_name_stands_twice() -> None:
    names = [*ARKIT, *MAKEHUMAN, *PERFORMED, *OMOTE, *SPRINGS]
    assert len(set(names)) == len(names) == 52 + 34 + 20 + 6 + 4


def test_what_springs_play_is_what_springs_of_a_show_ask_for() -> None:
    assert {spring.channel for spring in PLAYED_SPRINGS.values()} == {*SPRINGS}


def test_ears_that_sway_go_to_one_side() -> None:
    left, right = ear_turns("ears-sway")
    assert left.any()
    assert np.array_equal(left, -right)
    assert np.array_equal(*ear_turns("ears-flap"))


def test_fear_and_surprise_widen_the_pupils_anger_and_disgust_narrow_them() -> None:
    assert PUPILS.keys() <= PERFORMED.keys()
    assert min(PUPILS["fear"], PUPILS["surprise"]) > 0.0 > max(PUPILS["angry"], PUPILS["disgust"])
    assert all(-1.0 <= pupil <= 1.0 for pupil in (*PUPILS.values(), *OMOTE.values()))


def test_blood_has_the_signs_of_the_literature() -> None:
    assert COMPLEXIONS.keys() <= PERFORMED.keys()
    shown = {name: Complexion(*values) for name, values in COMPLEXIONS.items()}
    assert min(shown["angry"].forehead, shown["joy"].cheeks, shown["laugh"].cheeks) > 0.0 > shown["fear"].whole
    assert [name for name, own in shown.items() if own.tears == 1.0] == ["cry"]
    assert {name for name, own in shown.items() if own.sweat} == {"shout", "fear", "pain"}  # effort, fear, pain
    assert all(abs(value) <= 1.0 for own in shown.values() for value in own)


def test_ears_and_heads_turn_by_degrees_that_ears_and_heads_can() -> None:
    assert EARS.keys() <= {*ARKIT, *PERFORMED, *OMOTE, *SPRING_EARS}
    assert HEADS.keys() <= PERFORMED.keys()
    assert max(abs(angle) for turn in (*EARS.values(), *HEADS.values()) for angle in turn) <= 40.0
    assert np.allclose(ear_turns("fear"), np.radians([EARS["fear"]] * 2))
    assert not ear_turns("browDownLeft")[1].any()
    assert ear_turns("browDownLeft")[0].any()
    assert not head_turn("browDownLeft").any()


def test_ears_rise_with_surprise_lie_back_with_fear_and_rage_and_hang_with_sorrow() -> None:
    back, up = ({name: turn[axis] for name, turn in EARS.items()} for axis in (0, 1))
    assert up["surprise"] > 0 > max(up["sad"], up["cry"])
    assert min(back["fear"], back["angry"], back["pain"]) > 15 > 0 > back["surprise"]


@pytest.mark.parametrize("name", PERFORMED)
def test_recipes_use_units_within_reach(name: str) -> None:
    weights = unit_weights(PERFORMED[name])
    assert weights.keys() <= {*ARKIT, *MAKEHUMAN}
    assert all(0.0 < weight <= 1.25 for weight in weights.values())


def test_a_star_stands_for_left_and_right() -> None:
    assert unit_weights({"eyeBlink*": 0.5, "jawOpen": 1.0}) == {
        "eyeBlinkLeft": 0.5, "eyeBlinkRight": 0.5, "jawOpen": 1.0,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("name", "where"),
    [
        ("eyebrows-left-up", "brows"), ("eye-left-slit", "eyes"), ("jawOpen", "jaw"), ("tongueOut", "tongue"),
        ("neck-platysma", "whole"), ("smile", "whole"), ("noseSneerLeft", "nose"), ("mouth-open", "mouth"),
        ("pupils-wide", "eyes"), ("ears-back", "ears"), ("ears-sway", "ears"), ("jowls-sway", "jaw"),
    ],
)  # fmt: skip
def test_regions(name: str, where: str) -> None:
    assert region(name) == where
