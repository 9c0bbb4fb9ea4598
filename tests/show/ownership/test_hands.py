"""Whose hands move what, as each console is told."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.panic import PANIC_SECONDS
from omote.show.crew.members import LONGEST_NAME, free_name
from omote.show.declaration import ClientMessage
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects import faders
from omote.show.objects.calls import CallFace, FadeExpression, FadeFace, FadePose, Panic, ReleaseFace
from omote.show.objects.characters import PlaceCharacter
from omote.show.objects.faders import SetChannel, SetGaze, SetHead
from omote.show.objects.hand.macros import MoveMacro
from omote.show.objects.hand.pads import MovePad
from omote.show.objects.layers import SetLayer
from omote.show.objects.link import Ping
from omote.show.objects.motion import SetMotion, SetSkin, SetSpring
from omote.show.ownership.hands import (
    AGAIN_SECONDS,
    HandReports,
    Panics,
)
from omote.show.ownership.ownership_table import MOVING_SECONDS, OwnershipTable

NAMES = {"a": "Ana", "b": "Ben", "c": "console"}
JAW = SetChannel("one", "jawOpen", 0.5)
GAZE = SetGaze("one", 0.1, 0.0)


def test_each_console_hears_of_the_others_and_never_of_itself() -> None:
    hands = HandReports(OwnershipTable())
    hands.note("a", JAW, ["one"], 0.0)
    hands.note("b", GAZE, ["one"], 0.0)
    assert hands.tell(NAMES, 0.0) == {
        "a": faders.Hands({"one/set_gaze": "Ben"}),
        "b": faders.Hands({"one/set_channel:jawOpen": "Ana"}),
        "c": faders.Hands({"one/set_channel:jawOpen": "Ana", "one/set_gaze": "Ben"}),
    }
    assert hands.tell(NAMES, 0.1) == {}, "nothing is new"


def test_of_two_hands_on_one_control_both_hear_of_the_other_and_the_rest_of_the_last() -> None:
    hands = HandReports(OwnershipTable())
    hands.note("a", JAW, ["one"], 0.0)
    hands.note("b", JAW, ["one"], 0.1)
    told = hands.tell(NAMES, 0.1)
    assert {who: list(each.hands.values()) for who, each in told.items()} == {"a": ["Ben"], "b": ["Ana"], "c": ["Ben"]}


def test_a_hand_counts_for_a_moment_and_the_same_is_told_again() -> None:
    hands = HandReports(OwnershipTable())
    hands.note("a", JAW, ["one"], 0.0)
    first = hands.tell(NAMES, 0.0)
    hands.note("a", JAW, ["one"], 0.9)
    assert hands.tell(NAMES, AGAIN_SECONDS) == first, "a message may have been lost"
    ended = hands.tell(NAMES, 1.0 + MOVING_SECONDS)
    assert ended == dict.fromkeys("bc", faders.Hands({}))
    assert hands.tell(NAMES, 9.0) == {}


@pytest.mark.parametrize("end", ["leaves", "panic"])
def test_who_leaves_and_panic_take_hands_off(end: str) -> None:
    hands = HandReports(OwnershipTable())
    hands.note("a", JAW, ["one"], 0.0)
    hands.tell(NAMES, 0.0)
    if end == "panic":
        hands.take_off(["two"])
        assert hands.tell(NAMES, 0.0) == {}, "those of another character stay on"
        hands.take_off(["one"])
    else:
        hands.leave("a")
    assert hands.tell({"b": "Ben"}, 0.0) == {"b": faders.Hands({})}


def test_only_what_moves_a_control_is_a_hand_on_it() -> None:
    hands = HandReports(OwnershipTable())
    for message in (
        Panic("one"),
        CallFace("one", "1", "dog", 1.0, "smooth"),
        ReleaseFace("one"),
        Ping(0.0),
    ):
        hands.note("a", message, ["one"], 0.0)
    assert hands.tell(NAMES, 0.0) == {}


def test_every_control_has_its_own_key() -> None:
    messages: list[ClientMessage] = [
        JAW,
        SetChannel("one", "smile", 0.0),
        GAZE,
        SetHead("one", 0.0, 0.0, 0.0),
        *t_bars(),
    ]
    messages.append(PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, 0.0))
    messages += [SetLayer("one", "lips", part, 0.5) for part in (None, "mouth", "head")]
    messages.append(SetLayer("one", "blink", "mouth", 0.5))
    messages.append(SetMotion("one", 0.5))
    messages += [MovePad("one", name, 0.5) for name in ("moods", "mouth")]
    messages += [MoveMacro("one", name, 0.5) for name in ("smile", "jaw")]
    messages += [SetSpring("one", "ears-sway", 0.5), SetSpring("one", "ears-flap", 0.5)]
    messages += [SetSkin("one", "folds", 0.5), SetSkin("one", "blood", 0.5)]
    assert {type(message) for message in messages} == {kind for kind in CLIENT_MESSAGES if kind.hand is not None}
    assert len({message.control("one") for message in messages}) == len(messages)


def test_a_hand_on_all_is_a_hand_on_each() -> None:
    hands = HandReports(OwnershipTable())
    hands.note("a", JAW, ["one", "two"], 0.0)
    hands.note("b", GAZE, ["two"], 0.0)
    assert hands.tell(NAMES, 0.0)["c"] == faders.Hands(
        {"one/set_channel:jawOpen": "Ana", "two/set_channel:jawOpen": "Ana", "two/set_gaze": "Ben"}
    )


def test_a_panic_is_news_to_others_for_a_moment() -> None:
    panics = Panics()
    panics.press("a", ["one", "two"], 0.0)
    assert panics.is_late("b", ["three", "two"], PANIC_SECONDS / 2)
    assert not panics.is_late("a", ["two"], 0.0), "who pressed knows of it"
    assert not panics.is_late("b", ["three"], 0.0)
    assert not panics.is_late("b", ["one"], PANIC_SECONDS)
    panics.forget("one")
    assert not panics.is_late("b", ["one"], 0.0)


def t_bars() -> list[ClientMessage]:
    return [FadeFace("one", 0.0), FadeExpression("one", 0.0), FadePose("one", 0.0)]


@given(st.lists(st.sampled_from(["Ana", "ana", "Ana 2", "console 1", "Ben", "7", "x" * 24])))
def test_no_two_consoles_have_one_name(wanted: list[str]) -> None:
    taken: set[str] = set()
    for each in wanted:
        name = free_name(each, taken)
        assert name.casefold() not in taken
        assert name.startswith(re.sub(r"(?<=\S) \d+$", "", each)[:20])
        assert len(name) <= LONGEST_NAME
        taken.add(name.casefold())


steps = st.lists(
    st.tuples(st.sampled_from("ab"), st.sampled_from(["jawOpen", "smile"]), st.sampled_from([0.0, 0.1, 0.6, 1.1]))
)


@given(steps)
def test_what_is_told_is_what_somebody_finds_who_looks_at_all_hands_anew(
    moves: list[tuple[str, str, float]],
) -> None:
    hands = HandReports(OwnershipTable())
    moved = dict[tuple[str, str], float]()
    now = 0.0
    shown = dict[str, dict[str, str]]()
    for who, name, passed in moves:
        now += passed
        hands.note_channels(who, "one", [name], now)
        moved[name, who] = now
        shown |= {each: dict(message.hands) for each, message in hands.tell(NAMES, now).items()}
        for console in NAMES:
            found = dict[str, str]()
            for channel in dict.fromkeys(channel for channel, _ in moved):
                movers = {
                    other: at for (each, other), at in moved.items() if each == channel and now - at < MOVING_SECONDS
                }
                if others := [other for other in movers if other != console]:
                    newest = max(movers[other] for other in others)
                    found[f"one/set_channel:{channel}"] = next(
                        NAMES[other] for other in others if movers[other] == newest
                    )
            assert shown.get(console, {}).keys() == found.keys()
            tied = len(set(moved.values())) < len(moved)  # of two at one instant either may be told
            assert tied or shown.get(console, {}) == found
