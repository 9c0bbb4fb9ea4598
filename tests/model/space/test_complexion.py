"""Complexions: seven plain numbers in their range, each of which some region brings."""

from __future__ import annotations

import math

import pytest

from omote.model.known_names import PLAY_REGIONS
from omote.model.space.complexion import OF_REGION, PALE, PARTS, REGIONS, SPOTS, WATER, Complexion, check_complexion


def test_numbers_are_kept_and_rest_is_one_object() -> None:
    assert check_complexion([0.5, 0, 0, 1, -0.25, 1, 0.5]) == Complexion(0.5, 0.0, 0.0, 1.0, -0.25, 1.0, 0.5)
    assert check_complexion([0] * 7) is PALE


@pytest.mark.parametrize(
    ("values", "error", "said"),
    [
        ((0.0,) * 6, ValueError, "has 6 numbers; expected 7: cheeks, nose"),
        (
            (0.0, 0.0, 2.1, 0.0, 0.0, 0.0, 0.0),
            ValueError,
            r"forehead of a complexion is 2\.1; expected a number from -2 to 2",
        ),
        ((math.nan, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), ValueError, "cheeks of a complexion is nan"),
        ((0.0, 0.0, 0.0, 0.0, 0.0, 0.0, True), TypeError, "sweat of a complexion is True"),
        (0.5, TypeError, "is a float; expected 7 numbers"),
        ("redden", TypeError, "is a str"),
    ],
)
def test_what_is_none_is_refused(values: object, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        check_complexion(values)


def test_every_part_has_a_region_and_every_spot_a_part() -> None:
    assert [*REGIONS] == [*PARTS]
    assert {region for region in REGIONS.values() if region} <= {*PLAY_REGIONS}
    assert {part for parts in OF_REGION.values() for part in parts} <= {*PARTS}
    assert {*SPOTS} < {*PARTS}
    assert {*WATER} < {*PARTS} - {*SPOTS}
