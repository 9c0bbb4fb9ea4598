"""The table of units and recipes."""

import pytest

from tools.baking.expressions import ARKIT, MAKEHUMAN, OWN, PERFORMED, PUPILS, region, unit_weights


def test_no_name_stands_twice() -> None:
    names = [*ARKIT, *MAKEHUMAN, *PERFORMED, *OWN]
    assert len(set(names)) == len(names) == 52 + 34 + 20 + 2


def test_fear_and_surprise_widen_the_pupils_anger_and_disgust_narrow_them() -> None:
    assert PUPILS.keys() <= PERFORMED.keys()
    assert min(PUPILS["fear"], PUPILS["surprise"]) > 0.0 > max(PUPILS["angry"], PUPILS["disgust"])
    assert all(-1.0 <= pupil <= 1.0 for pupil in (*PUPILS.values(), *OWN.values()))


@pytest.mark.parametrize("name", PERFORMED)
def test_recipes_use_arkit_units_within_reach(name: str) -> None:
    weights = unit_weights(PERFORMED[name])
    assert weights.keys() <= set(ARKIT)
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
        ("pupils-wide", "eyes"),
    ],
)  # fmt: skip
def test_regions(name: str, where: str) -> None:
    assert region(name) == where
