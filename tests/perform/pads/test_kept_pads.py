"""The pads of a show: named, copied, dropped, and every change taken back."""

from __future__ import annotations

from dataclasses import replace

import pytest

from omote.perform.pads.blend_space import MOST_PADS, Pad, PadLook
from omote.perform.pads.kept_pads import (
    MOST_REPLACED,
    NO_PADS,
    Pads,
    check_pads,
    with_change_back,
    with_copy,
    with_name,
    with_pads,
    without_pad,
)

LOOKS = (PadLook("A", {"a": 1.0}, (0.0,)), PadLook("B", {"b": 1.0}, (1.0,)))


def pad(name: str, at: float = 1.0) -> Pad:
    """A pad of a name whose second look is somewhere."""
    return Pad(name, "mouth", 1, (LOOKS[0], replace(LOOKS[1], place=(at,))))


def kept(*names: str) -> Pads:
    return with_pads(NO_PADS, {name: pad(name) for name in names}, "begin")


def test_every_change_is_taken_back_and_done_again() -> None:
    states = [kept("a", "b", "c")]
    states.append(with_pads(states[-1], {"a": pad("a", 0.5)}, "k1"))
    states.append(with_name(states[-1], "b", "bee", "k2"))
    states.append(with_copy(states[-1], "c", "sea", "k3"))
    states.append(without_pad(states[-1], "a", "k4"))
    pads = states[-1]
    for number in (4, 3, 2, 1):
        pads, _ = with_change_back(pads, f"k{number}")
        assert dict(pads.kept) == dict(states[number - 1].kept)
    for number in (1, 2, 3, 4):
        pads, _ = with_change_back(pads, f"k{number}")
        assert dict(pads.kept) == dict(states[number].kept)
    check_pads(pads)


def test_a_new_name_keeps_the_place_in_the_order_and_says_what_was_renamed() -> None:
    pads = with_name(kept("a", "b", "c"), "b", "bee", "k")
    assert ([*pads.kept], pads.kept["bee"].name) == (["a", "bee", "c"], "bee")
    pads, renamed = with_change_back(pads, "k")
    assert ([*pads.kept], renamed) == (["a", "b", "c"], {"bee": "b"})
    pads, renamed = with_change_back(pads, "k")
    assert ([*pads.kept], renamed) == (["a", "bee", "c"], {"b": "bee"})


def test_a_drag_under_one_key_is_taken_back_whole_and_changes_without_one_alone() -> None:
    pads = kept("a")
    for at in (0.9, 0.8, 0.7):
        pads = with_pads(pads, {"a": pad("a", at)}, "drag", goes_on=True)
    assert with_change_back(pads, "drag")[0].kept["a"] == pad("a")
    for at in (0.6, 0.5):
        pads = with_pads(pads, {"a": pad("a", at)}, "a")
    assert with_change_back(pads, "a")[0].kept["a"] == pad("a", 0.6)


def test_there_are_so_many_pads_and_changes_and_no_more() -> None:
    pads = NO_PADS
    for number in range(MOST_PADS):
        pads = with_pads(pads, {f"p{number}": pad(f"p{number}")}, str(number))
    assert len(pads.changes) == MOST_REPLACED
    with pytest.raises(ValueError, match="there are 32 pads, which is as many as a show keeps"):
        with_pads(pads, {"more": pad("more")}, "k")
    with pytest.raises(ValueError, match="there are 32 pads"):
        with_copy(pads, "p0", "more", "k")
    assert with_pads(pads, {"p0": pad("p0", 0.5)}, "k").kept["p0"] == pad("p0", 0.5)


@pytest.mark.parametrize("change", [with_name, with_copy])
def test_a_name_that_is_taken_or_none_is_refused(change: object) -> None:
    assert callable(change)
    pads = kept("a", "b")
    with pytest.raises(ValueError, match="there is no pad 'x'"):
        change(pads, "x", "y", "k")
    with pytest.raises(ValueError, match="there is a pad 'b' already"):
        change(pads, "a", "B", "k")
    with pytest.raises(ValueError, match="cannot be named 'a b'"):
        change(pads, "a", "a b", "k")


def test_what_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match="there is no pad 'x'"):
        without_pad(kept("a"), "x", "k")
    with pytest.raises(ValueError, match="there is no change of a pad 'x'"):
        with_change_back(kept("a"), "x")


def test_pads_that_no_scene_has_kept_are_refused() -> None:
    with pytest.raises(ValueError, match="the pad a is kept as 'b'"):
        check_pads(Pads({"b": pad("a")}))
