"""A mapping: what its targets give over the whole way of a macro, and what cannot be one."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.mappings.mapping import (
    HalfBelow,
    MacroCondition,
    MacroMapping,
    MacroTarget,
    check_macro_name,
    fitted,
    places_in,
    range_of,
)

WEIGHTS = st.floats(-0.5, 1.5)
MACROS = st.floats(-1.0, 1.0)


@given(WEIGHTS, WEIGHTS, WEIGHTS, MACROS)
def test_both_halves_meet_in_the_middle_and_end_where_they_say(
    low: float, high: float, under: float, macro: float
) -> None:
    target = MacroTarget("channel/jawOpen", low, high, below=HalfBelow(under))
    assert target.value_at(0.0) == low
    assert (target.value_at(1.0), target.value_at(-1.0)) == pytest.approx((high, under))
    ends = (low, high) if macro >= 0.0 else (low, under)
    assert min(ends) - 1e-9 <= target.value_at(macro) <= max(ends) + 1e-9
    assert MacroTarget("channel/jawOpen", low, high).value_at(-abs(macro)) == low


@given(st.lists(st.floats(-1.0, 1.0), min_size=2, max_size=40), st.booleans())
def test_a_condition_changes_only_when_a_reading_has_passed_its_level_or_come_back_by_its_hysteresis(
    readings: list[float], above: bool
) -> None:
    condition = MacroCondition("macro/on", 0.1, above, 0.2)
    was_open = False
    for reading in readings:
        opens = condition.opens(reading, was_open=was_open)
        beyond = reading - 0.1 if above else 0.1 - reading
        assert opens == (beyond > 0.0 or (was_open and beyond > -0.2))
        was_open = opens


def test_targets_of_each_kind_have_their_range() -> None:
    assert range_of("channel/a/b") == (-0.5, 1.5)
    assert range_of("pad/mouth/y") == (-1.0, 1.0)
    assert range_of("gaze/pitch")[1] < range_of("gaze/yaw")[1] < range_of("head/roll")[1]
    assert fitted("pad/mouth/x", -3.0) == -1.0
    targets = (MacroTarget("channel/jawOpen"), MacroTarget("pad/mouth/x"))
    assert places_in([MacroMapping("m", targets)] * 2) == [("channel", "jawOpen"), ("pad", "mouth/x")]


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: MacroTarget("head/up"), "a macro cannot play 'head/up'"),
        (lambda: MacroTarget("pad/mouth"), "cannot play 'pad/mouth'"),
        (lambda: MacroTarget("channel/"), "cannot play 'channel/'"),
        (lambda: MacroTarget("head/yaw", high=2.0), "head/yaw"),
        (lambda: MacroTarget("head/yaw", high=0.1, below=HalfBelow(1.58)), "number from"),
        (lambda: MacroTarget("head/yaw", high=0.1, rise=6.0), "rise of head/yaw"),
        (lambda: MacroCondition("head/yaw", 0.5), "kind of source"),
        (lambda: MacroCondition("macro/", 0.5), "the condition reads"),
        (lambda: MacroMapping("m", ()), "1 to 8"),
        (lambda: MacroMapping("m", (MacroTarget("head/yaw", high=0.1),) * 2), "has head/yaw twice"),
    ],
)
def test_what_cannot_be_is_said(make: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        make()


@pytest.mark.parametrize("name", ["", "a b", "a/b", "x" * 41, "a\n", 5])
def test_names_that_no_address_can_have_are_said(name: object) -> None:
    with pytest.raises(ValueError, match="macro"):
        check_macro_name(name)


def test_what_was_left_out_is_told_as_it_counts() -> None:
    """Pages read every field of a mapping."""
    condition = {"reads": "macro/grip", "level": 0.5}
    left_out = {"name": "mouth", "targets": [{"to": "channel/jawOpen"}]}
    for given_fields in (left_out, {**left_out, "when": condition}):
        told = msgspec.msgpack.decode(msgspec.msgpack.encode(msgspec.convert(given_fields, MacroMapping)))
        assert told.keys() == {each.name for each in fields(MacroMapping)}
        assert told["targets"][0].keys() == {each.name for each in fields(MacroTarget)}
    assert told["when"].keys() == {each.name for each in fields(MacroCondition)}
