"""Gestures that run: what they add, interruptions, rejections."""

from __future__ import annotations

import math

import numpy as np
import pytest

from omote.perform.channels import channels_of
from omote.perform.frame import Frame, Head, Held
from omote.perform.gestures import (
    CURVES,
    GESTURES,
    MOST_GESTURES,
    Gesture,
    advance_gestures,
    begin_gesture,
    check_gesture,
    check_gestures,
    mirror_channel,
    release_gestures,
    value_at,
    with_gestures,
)
from omote.perform.performer import Performer
from tests import synthetic

SMILE = synthetic.cast().expressions["smile"]
CHANNELS = dict.fromkeys(("eyeBlinkLeft", "eyeBlinkRight", "browInnerUp"), SMILE)
STILL = Frame({"generic": 1.0}, {"neutral": 1.0})


def _head(running: tuple[Gesture, ...]) -> tuple[float, float, float]:
    head = with_gestures(STILL, running, CHANNELS, Held()).head
    return head.yaw, head.pitch, head.roll


def test_a_frame_without_gestures_is_itself() -> None:
    assert with_gestures(STILL, (), CHANNELS, Held()) is STILL


def test_eyes_that_hands_have_turned_stay_there_in_a_gesture() -> None:
    cast = synthetic.cast()
    performer = Performer(cast)
    performer.set_gaze(0.3, 0.1)
    before = channels_of(cast.expressions, performer.advance(1 / 60))
    performer.gesture("nod")
    during = channels_of(cast.expressions, performer.advance(1 / 60))
    assert before
    assert during == before


def test_a_gesture_adds_to_the_head_and_tells_what_hands_hold() -> None:
    running = advance_gestures(begin_gesture((), "nod", 1.0, 1.0), 0.28)
    frame = with_gestures(Frame({}, {}, head=Head(0.1, 0.1, 0.0)), running, CHANNELS, Held())
    assert (frame.head.yaw, frame.head.pitch) == pytest.approx((0.1, 0.1 - 0.22))
    assert frame.held == Held()
    assert advance_gestures(running, 1.0) == ()


def test_a_wink_closes_one_lid_what_is_closed_stays_closed_and_the_other_side_is_below_zero() -> None:
    for amplitude, lid in ((1.0, "eyeBlinkLeft"), (-1.0, "eyeBlinkRight")):
        running = advance_gestures(begin_gesture((), "wink", amplitude, 1.0), 0.45)
        shown = with_gestures(Frame({}, {}, {lid: 0.5}), running, CHANNELS, Held()).channels
        assert shown[lid] == pytest.approx(1.0)
        assert set(shown) <= CHANNELS.keys()


def test_a_head_stays_in_its_range() -> None:
    running = advance_gestures(begin_gesture((), "bow", 2.0, 1.0), 0.45)
    frame = with_gestures(Frame({}, {}, head=Head(0.0, -1.2, 0.0)), running, CHANNELS, Held())
    assert frame.head.pitch == -math.pi / 2


def test_gestures_that_interrupt_each_other_do_not_pop() -> None:
    random = np.random.default_rng(2)
    running: tuple[Gesture, ...] = ()
    ways = []
    for step in range(2000):
        if step % 37 == 0:
            running = begin_gesture(running, random.choice(GESTURES), float(random.uniform(-2, 2)), None)
        running = advance_gestures(running, 1 / 240)
        ways.append(_head(running))
    assert np.abs(np.diff(ways, axis=0)).max() < 0.05
    assert len(running) <= MOST_GESTURES


def test_what_is_released_goes_within_a_moment() -> None:
    running = release_gestures(advance_gestures(begin_gesture((), "tilt", 1.0, 5.0), 2.0))
    assert release_gestures(running) == running
    assert advance_gestures(running, 0.3) == ()


@pytest.mark.parametrize(
    ("name", "amplitude", "seconds", "match"),
    [
        ("dance", 1.0, None, "gesture 'dance'"),
        ("nod", 2.1, None, "amplitude of a gesture"),
        ("nod", math.nan, None, "amplitude of a gesture"),
        ("nod", 1.0, 0.1, "time of a gesture"),
        ("nod", 1.0, 11.0, "time of a gesture"),
        ("nod", 1.0, math.inf, "time of a gesture"),
    ],
)
def test_rejects_what_is_no_gesture(name: str, amplitude: float, seconds: float | None, match: str) -> None:
    with pytest.raises(ValueError, match=match):
        begin_gesture((), name, amplitude, seconds)


@pytest.mark.parametrize(
    "wrong",
    [
        Gesture("nod", 3.0, 1.0), Gesture("nod", 1.0, 0.0), Gesture("nod", 1.0, 1.0, -1.0),
        Gesture("nod", 1.0, 1.0, 0.0, -1.0), Gesture("dance", 1.0, 1.0),  # type: ignore[arg-type]
    ],
)  # fmt: skip
def test_rejects_a_saved_gesture_that_nobody_can_have_made(wrong: Gesture) -> None:
    with pytest.raises(ValueError, match="gesture"):
        check_gestures((wrong,))
    with pytest.raises(ValueError, match="gestures run"):
        check_gestures((Gesture("nod", 1.0, 1.0),) * (MOST_GESTURES + 1))


@pytest.mark.parametrize("name", GESTURES)
def test_a_gesture_begins_and_ends_at_nothing_without_a_jump(name: str) -> None:
    curves = CURVES[check_gesture(name)]
    for curve in (curves.yaw, curves.pitch, curves.roll, *curves.channels.values()):
        shares = np.linspace(-0.1, 1.1, 1000)
        values = [value_at(curve, share) for share in shares]
        assert values[0] == values[-1] == 0.0
        assert np.abs(np.diff(values)).max() < 0.02
        assert curve == () or np.abs(values).max() > 0.02


def test_a_nod_goes_down_and_a_shake_to_both_sides() -> None:
    pitches = [value_at(CURVES["nod"].pitch, share) for share in np.linspace(0, 1, 100)]
    yaws = [value_at(CURVES["shake"].yaw, share) for share in np.linspace(0, 1, 100)]
    assert min(pitches) < -0.2
    assert min(yaws) < -0.1 < 0.1 < max(yaws)


def test_sides_are_mirrored() -> None:
    assert [mirror_channel(name) for name in ("eyeBlinkLeft", "eyeBlinkRight", "jawOpen")] == [
        "eyeBlinkRight", "eyeBlinkLeft", "jawOpen",
    ]  # fmt: skip


def test_rejects_a_gesture_that_there_is_not() -> None:
    with pytest.raises(ValueError, match="gesture 'dance'"):
        check_gesture("dance")
