"""The mappings of a character: changed, taken back and that again, and their order, whatever is done to them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.mappings.kept_mappings import (
    MOST_REPLACED,
    NO_MAPPINGS,
    Mappings,
    check_mappings,
    renaming_in,
    with_all,
    with_mapping,
    with_renamed,
    with_restored,
    without_mapping,
)
from omote.perform.mappings.mapping import MacroCondition, MacroMapping, MacroTarget

NAMES = ("a", "b", "c")
JAW = MacroTarget("channel/jawOpen")


def kept(*names: str) -> Mappings:
    mappings = NO_MAPPINGS
    for name in names:
        mappings = with_mapping(mappings, MacroMapping(name, (JAW,)), "")
    return mappings


@given(st.lists(st.tuples(st.sampled_from(["set", "drop", "rename", "all"]), st.sampled_from(NAMES)), max_size=8))
def test_each_change_is_taken_back_and_that_too(steps: list[tuple[str, str]]) -> None:
    mappings = kept("a", "b")
    for number, (what, name) in enumerate(steps):
        key = f"k{number}"
        before = mappings
        try:
            if what == "set":
                mappings = with_mapping(mappings, MacroMapping(name, (MacroTarget("head/yaw", high=0.1),)), key)
            elif what == "drop":
                mappings = without_mapping(mappings, name, key)
            elif what == "rename":
                mappings = with_renamed(mappings, name, f"{name}{number}", key)
            else:
                mappings = with_all(mappings, {name: MacroMapping(name, (JAW,))}, key)
        except ValueError:
            assert name not in before.kept
            continue
        back = with_restored(mappings, key)
        assert back.kept == before.kept
        assert with_restored(back, key).kept == mappings.kept
        check_mappings(mappings)
    assert len(mappings.replaced) <= MOST_REPLACED


def test_one_that_is_called_otherwise_stays_where_it_stood_and_is_read_by_its_new_name() -> None:
    mappings = with_mapping(kept("a", "b"), MacroMapping("c", (JAW,), MacroCondition("macro/a", 0.5)), "")
    later = with_renamed(mappings, "a", "x", "k")
    assert [*later.kept] == ["x", "b", "c"]
    assert later.kept["c"].when == MacroCondition("macro/x", 0.5)
    assert renaming_in(kept("a", "b").kept, kept("b", "x").kept) == ("a", "x")
    assert renaming_in(kept("a", "b").kept, kept("a").kept) is None


def test_what_is_kept_under_another_name_is_refused() -> None:
    with pytest.raises(ValueError, match="both must be one name"):
        check_mappings(Mappings({"a": MacroMapping("b", (JAW,))}))
