"""Commas between numbers and within them: told apart where only one reading is possible."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.decimal_commas import join_decimals


@pytest.mark.parametrize(
    ("text", "count", "expected"),
    [
        ("1,2,3", 3, ["1", "2", "3"]),
        ("-1,5,2,25,0,0", 3, ["-1.5", "2.25", "0.0"]),
        ("5,3,0,35,0", 3, ["5.3", "0.35", "0"]),
        ("6,9,-3,1,0", 3, ["6.9", "-3.1", "0"]),
        ("1,2e-05,-3,0", 3, ["1.2e-05", "-3", "0"]),
        ("1,2,3,4", 3, None),
        ("1,2,3,4,5,6,7", 3, None),
        ("1,2", 3, None),
        ("", 3, None),
    ],
)
def test_numbers_are_joined_where_one_reading_is_possible(text: str, count: int, expected: list[str] | None) -> None:
    assert join_decimals(text.split(","), count) == expected


@given(st.lists(st.floats(-99, 99).map(lambda number: f"{number:.3f}"), min_size=6, max_size=6))
def test_a_program_that_keeps_all_decimals_is_read_as_it_wrote(numbers: list[str]) -> None:
    assert join_decimals(",".join(numbers).replace(".", ",").split(","), 6) == numbers


@given(st.lists(st.floats(-99, 99).map(lambda number: f"{number:.3g}"), min_size=3, max_size=3))
def test_what_is_joined_is_never_another_number(numbers: list[str]) -> None:
    joined = join_decimals(",".join(numbers).replace(".", ",").split(","), 3)
    assert joined is None or [*map(float, joined)] == [*map(float, numbers)]
