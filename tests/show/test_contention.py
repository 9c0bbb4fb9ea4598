"""Whose hands move what, as each console is told."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show import messages as wire
from omote.show.contention import AGAIN_SECONDS, LONGEST_NAME, MOVING, MOVING_SECONDS, Hands, control_of, free_name

NAMES = {"a": "Ana", "b": "Ben", "c": "console"}
JAW, GAZE = wire.SetChannel("jawOpen", 0.5), wire.SetGaze(0.1, 0.0)


def test_each_console_hears_of_the_others_and_never_of_itself() -> None:
    hands = Hands()
    hands.note("a", JAW, 0.0)
    hands.note("b", GAZE, 0.0)
    assert hands.tell(NAMES, 0.0) == {
        "a": wire.Hands({"set_gaze": "Ben"}),
        "b": wire.Hands({"set_channel:jawOpen": "Ana"}),
        "c": wire.Hands({"set_channel:jawOpen": "Ana", "set_gaze": "Ben"}),
    }
    assert hands.tell(NAMES, 0.1) == {}, "nothing is new"


def test_of_two_hands_on_one_control_both_hear_of_the_other_and_the_rest_of_the_last() -> None:
    hands = Hands()
    hands.note("a", JAW, 0.0)
    hands.note("b", JAW, 0.1)
    told = hands.tell(NAMES, 0.1)
    assert {who: list(each.hands.values()) for who, each in told.items()} == {"a": ["Ben"], "b": ["Ana"], "c": ["Ben"]}


def test_a_hand_counts_for_a_moment_and_the_same_is_told_again() -> None:
    hands = Hands()
    hands.note("a", JAW, 0.0)
    first = hands.tell(NAMES, 0.0)
    hands.note("a", JAW, 0.9)
    assert hands.tell(NAMES, AGAIN_SECONDS) == first, "a message may have been lost"
    ended = hands.tell(NAMES, 1.0 + MOVING_SECONDS)
    assert ended == dict.fromkeys("bc", wire.Hands({}))
    assert hands.tell(NAMES, 9.0) == {}


@pytest.mark.parametrize("end", ["leaves", "panic"])
def test_who_leaves_and_panic_take_hands_off(end: str) -> None:
    hands = Hands()
    hands.note("a", JAW, 0.0)
    hands.tell(NAMES, 0.0)
    if end == "panic":
        hands.take_off()
    else:
        hands.leave("a")
    assert hands.tell({"b": "Ben"}, 0.0) == {"b": wire.Hands({})}


def test_only_what_moves_a_control_is_a_hand_on_it() -> None:
    hands = Hands()
    for message in (wire.Panic(), wire.CallFace("1", "dog", 1.0, "smooth"), wire.ReleaseFace(), wire.Ping(0.0)):
        hands.note("a", message, 0.0)
    assert hands.tell(NAMES, 0.0) == {}


def test_every_control_has_its_own_key() -> None:
    messages = [JAW, wire.SetChannel("smile", 0.0), GAZE, wire.SetHead(0.0, 0.0, 0.0), *faders()]
    assert {type(message) for message in messages} == {*MOVING}
    assert len({control_of(message) for message in messages}) == len(messages)


def faders() -> list[wire.Message]:
    return [wire.FadeFace(0.0), wire.FadeExpression(0.0)]


@given(st.lists(st.sampled_from(["Ana", "ana", "Ana 2", "console 1", "Ben", "7", "x" * 24])))
def test_no_two_consoles_have_one_name(wanted: list[str]) -> None:
    taken: set[str] = set()
    for each in wanted:
        name = free_name(each, taken)
        assert name.casefold() not in taken
        assert name.startswith(re.sub(r"(?<=\S) \d+$", "", each)[:20])
        assert len(name) <= LONGEST_NAME
        taken.add(name.casefold())
