"""Places are in range, and a new character gets one where nobody stands."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.scene.scene_frame import BESIDE, PLACE_LIMITS, Place, free_place

places = st.builds(Place, x=st.floats(-3.0, 3.0), depth=st.floats(0.0, 20.0), size=st.floats(0.25, 4.0))


@given(st.lists(places, max_size=7))
def test_a_free_place_is_beside_everybody_and_near_the_middle(taken: list[Place]) -> None:
    found = free_place(taken)
    assert all(abs(found.x - other.x) >= 0.75 * BESIDE for other in taken)
    assert abs(found.x) <= BESIDE * (len(taken) + 1)
    assert found == Place(x=found.x)


def test_the_first_stands_in_the_middle_and_the_next_right_and_left_of_it() -> None:
    taken: list[Place] = []
    for _ in range(5):
        taken.append(free_place(taken))
    assert [round(place.x / BESIDE, 9) for place in taken] == [0, 1, -1, 2, -2]


@pytest.mark.parametrize("name", PLACE_LIMITS)
def test_a_place_out_of_range_is_rejected(name: str) -> None:
    low, high = PLACE_LIMITS[name]
    for value in (low, high):
        assert getattr(Place(**{name: value}), name) == value
    for value in (math.nextafter(low, -math.inf), math.nextafter(high, math.inf), math.nan):
        with pytest.raises(ValueError, match=f"the {name} of a place"):
            Place(**{name: value})
