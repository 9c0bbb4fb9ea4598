"""Macros as vectors are the same as they are kept, and what they give is summed by target."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.mappings.kept_mappings import ByName
from omote.perform.mappings.macro_vectors import (
    MacroVectors,
    advance_macros,
    given_by,
    macro_statuses,
    move_macro,
    states_of,
    sum_by_target,
    vectors_of,
)
from omote.perform.mappings.macros import NO_MACROS, follow_change
from omote.perform.mappings.mapping import HalfBelow, MacroCondition, MacroMapping, MacroTarget

JAW = MacroTarget("channel/jawOpen", high=0.5, curve=((0.0, 0.0), (0.3, 0.8), (1.0, 1.0)), below=HalfBelow(-0.2))
TURN = MacroTarget("head/yaw", high=0.3, rise=0.1, fall=0.4)
MAPPINGS: ByName = {
    "a": MacroMapping("a", (JAW, TURN)),
    "b": MacroMapping("b", (JAW,), MacroCondition("macro/a", 0.0)),
    "c": MacroMapping("c", (TURN,)),
}
moves = st.lists(st.tuples(st.sampled_from([*MAPPINGS]), st.floats(-1.0, 1.0), st.floats(0.0, 0.2)), max_size=8)


def read(_: MacroCondition) -> float:
    return 0.5


def played(way: list[tuple[str, float, float]], mappings: ByName = MAPPINGS) -> MacroVectors | None:
    vectors = None
    for name, value, dt in way:
        vectors = advance_macros(move_macro(vectors, mappings, name, value, read), read, dt)
    return vectors


@given(moves, st.sampled_from([*MAPPINGS]))
def test_what_is_kept_goes_on_as_what_plays(way: list[tuple[str, float, float]], changed: str) -> None:
    later: ByName = {**MAPPINGS, changed: MacroMapping(changed, (MacroTarget("gaze/pitch", high=0.3),))}
    macros = follow_change(states_of(played(way)), MAPPINGS, later)  # something fades, unless nothing was moved
    vectors = vectors_of(macros, later)
    assert states_of(vectors) == macros
    for _ in range(4):
        kept = vectors_of(states_of(vectors), later)
        vectors = vectors and advance_macros(vectors, read, 0.05)
        assert states_of(kept and advance_macros(kept, read, 0.05)) == states_of(vectors)


def test_nothing_that_was_moved_is_nothing() -> None:
    assert vectors_of(NO_MACROS, MAPPINGS) is None
    assert states_of(None) == NO_MACROS
    assert {name: tuple(status) for name, status in macro_statuses(MAPPINGS, None).items()} == dict.fromkeys(
        MAPPINGS, (0.0, 0.0)
    )


def test_sources_of_one_target_are_added_to_what_faders_hold() -> None:
    vectors = played([("a", 1.0, 4.0), ("c", 1.0, 4.0), ("b", -1.0, 4.0)])
    assert vectors is not None
    table = vectors.table
    assert table.targets == (("channel", "jawOpen"), ("head", "yaw"))
    sums = sum_by_target(table, given_by(vectors), [0.1, -0.1])
    assert sums == pytest.approx([0.1 + 0.5 - 0.2, -0.1 + 0.3 + 0.3])
