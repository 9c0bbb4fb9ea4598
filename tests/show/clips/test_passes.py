"""Passes of clips at another speed, and of what one pair of hands plays."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

import omote
from omote.model.cast import Cast
from omote.model.known_names import PlayRegion
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import MotionCurve, make_curve
from omote.perform.layers.layer_names import LayerPart
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.mix import mix_in
from omote.show.clips import show_clips
from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import clips as wire
from omote.show.objects.characters import AddCharacter
from omote.show.objects.hand.macros import MoveMacro, SetMapping
from omote.show.objects.hand.pads import MovePad
from omote.show.objects.link import Hello
from omote.show.objects.motion import SetMotion
from omote.show.objects.sources import Drive, RouteSource, Source, SourceIs
from omote.show.objects.speech import PlaySound
from omote.show.objects.state import CharacterState
from tests.show.clips.clip_show import DT, Show, reason

CURVE = 1e-3
"""Radians: by which two cubics through 60 and through more frames a second differ, of a head that swings by .2 three
times a second."""
SECOND: tuple[PlayRegion, ...] = ("brows", "eyes", "rest")
TIMES = np.arange(121) / 60.0


def swinging(part: LayerPart, rate: float) -> Clip:
    """Two seconds of a head or a gaze that swings so many times a second."""
    yaw = 0.2 * np.sin(2.0 * math.pi * rate * TIMES)
    still = np.zeros(len(TIMES))
    if part == "head":
        curve = make_curve(TIMES, {}, {}, head=np.column_stack([yaw, still, still]))
    else:
        curve = make_curve(TIMES, {}, {}, gaze=np.column_stack([yaw, still]))
    return Clip([Lane(curve, parts=(part,))], blend_out=0.0)


@pytest.mark.parametrize(
    ("speed", "rate", "start"), [(0.25, 3.0, 0.0), (0.5, 3.0, 0.25), (0.75, 1.0, 0.25), (1.0, 3.0, 0.0)]
)
def test_a_pass_of_motion_at_its_own_speed_is_that_at_full_speed_in_the_time_of_the_clip(
    cast: Cast, speed: float, rate: float, start: float
) -> None:
    def kept(speed: float) -> tuple[Lane, list[float]]:
        show = Show(cast)
        show.session.clips.put("moves", swinging("head", rate))
        show.session.clips.put("line1", swinging("gaze", rate))
        show.send(wire.PlayClip, "one", "moves", seconds=0.0, start=start, speed=speed)
        show.send(wire.RecordClip, "one", "line1", ["head"], "head", start=start, speed=speed)
        played = [state.gaze[0] for state in show.states(1.5 / speed)]
        show.send(wire.KeepPass, "one")
        return show.session.clips.clips["line1"].lanes[1], played

    def yaw(curve: MotionCurve, part: str, at: float) -> float:
        return float(curve.values(at)[curve.layout.columns.index(f"{part}/yaw")])

    (whole, _), (slow, played) = kept(1.0), kept(speed)
    assert (slow.start, slow.stop) == pytest.approx((start, start + 1.5), abs=1e-9)
    for at in np.arange(start + 0.05, start + 1.5, 0.0173):  # at its first frame a pass has what the first tick showed
        assert yaw(slow.curve, "head", at) == pytest.approx(yaw(whole.curve, "head", at), abs=CURVE)
    (below,) = swinging("gaze", rate).lanes
    for tick, gaze in enumerate(played, 1):
        if tick / 60 > show_clips.MEETING_SECONDS:
            assert gaze == pytest.approx(yaw(below.curve, "gaze", start + tick / 60 * speed), abs=1e-9)


def test_a_pass_at_half_speed_hears_no_sound_and_says_so(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"line": 2.0})
    show.send(wire.RecordClip, "one", "line1", sound="line", speed=0.5)
    assert "without its sound: it plays at the speed 0.5, its sound at 1 alone" in show.session.lost[-1]
    show.run(0.5)
    assert show.session.tick(show.now).characters["one"].speech is None
    show.send(PlaySound, "one", "line", seconds=0.0)
    show.send(wire.KeepPass, "one")
    assert show.session.tick(show.now).characters["one"].speech is not None, "what else is heard goes on"
    clip = show.session.clips.clips["line1"]
    assert (clip.sound, clip.sound_at) == ("line", 0.0)
    assert clip.seconds == pytest.approx(0.25, abs=1e-9)
    show.send(wire.RecordClip, "one", "line1", ["brows"], speed=0.5)
    show.run(0.1)
    state = show.session.tick(show.now).characters["one"]
    assert [each.silent for each in state.clips] == ["the clip plays at the speed 0.5, its sound at 1 alone"]


@pytest.mark.parametrize("speed", [0.2, 1.5, float("nan")])
def test_a_pass_is_not_recorded_at_a_speed_that_nobody_can_play_along_with(cast: Cast, speed: float) -> None:
    show = Show(cast)
    assert "the speed of a pass is" in reason(show.send(wire.RecordClip, "one", "line1", speed=speed))
    assert show.session.clips.passes == {}


def test_consoles_are_told_at_what_speed_a_pass_is_recorded(cast: Cast) -> None:
    show = Show(cast)
    show.send(wire.RecordClip, "one", "line1", speed=0.5)
    assert [each.speed for each in show.session.clips.work.passes] == [0.5]


def test_what_one_pair_of_hands_plays_is_recorded_as_lanes_and_played_by_another_character() -> None:
    """First the mouth by a stick and the head by a hand before the camera, then the mood by a pad."""
    show = Show(omote.load_cast())
    session = show.session
    stick = MacroMapping("stick", (MacroTarget("channel/jawOpen", 0.0, 0.8),))
    session.receive("a", SetMapping("one", "set", stick), 0.0)
    session.receive("a", SetMotion("one", liveliness=0.0), 0.0)
    show.send(AddCharacter, "two", "Two", "dog")
    session.receive("hand", Hello("console", PROTOCOL_VERSION, "hand"), show.now)
    (opened,) = session.receive("hand", Source("hand", "tracker", ["jawOpen"]), show.now)
    assert isinstance(opened.message, SourceIs)
    index = opened.message.index
    session.receive("a", RouteSource("route", "hand", ["one"], "tracker", ["head"]), show.now)
    show.run(0.5)

    def play(ticks: int, act: Callable[[float], ClientMessage]) -> list[CharacterState]:
        states = []
        for tick in range(ticks):
            session.receive("hand", Drive(index, bytes(4), (0.2 * tick / ticks, 0.0, 0.0)), show.now)
            session.receive("a", act(tick / ticks), show.now)
            states += show.states(DT)
        return states

    show.send(wire.RecordClip, "one", "line", ["mouth", "head"], "mouth")
    first = play(60, lambda at: MoveMacro("one", "stick", at))
    show.send(wire.KeepPass, "one")
    session.receive("a", MoveMacro("one", "stick", 0.0), show.now)
    show.run(1.0)
    show.send(wire.RecordClip, "one", "line", [*SECOND], "mood")
    second = play(60, lambda at: MovePad("one", "moods", 0.9 * at, 0.3))
    show.send(wire.KeepPass, "one")
    show.send(wire.PlayClip, "two", "line", seconds=0.0)
    for tick, again in enumerate(show.states(40 * DT, "two"), 1):
        assert again.channels.get("jawOpen", 0.0) == pytest.approx(
            first[tick - 1].channels.get("jawOpen", 0.0), abs=1e-6
        )
        assert again.head == pytest.approx(first[tick - 1].head, abs=1e-6)
        for region in SECOND:
            mix = mix_in(region, second[tick - 1].expressions, second[tick - 1].regions)
            assert mix_in(region, again.expressions, again.regions) == pytest.approx(mix, abs=1e-6)
        assert mix_in("mouth", again.expressions, again.regions) == pytest.approx({"neutral": 1.0})


def test_hands_lie_over_a_lane_and_what_a_pad_plays_lies_below_it() -> None:
    show = Show(omote.load_cast())
    session = show.session
    session.receive("a", SetMapping("one", "set", MacroMapping("stick", (MacroTarget("channel/jawOpen"),))), 0.0)
    show.send(wire.RecordClip, "one", "line", ["mouth"])
    session.receive("a", MovePad("one", "mouth", 0.7, 0.6), show.now)
    show.run(1.0)
    show.send(wire.KeepPass, "one")
    session.receive("a", MovePad("one", "mouth", 0.0, 0.0), show.now)
    show.run(0.5)
    show.send(wire.PlayClip, "one", "line", seconds=0.0, loop=True)
    show.run(0.6)
    session.receive("a", MovePad("one", "mouth", -0.85, -0.1), show.now)
    session.receive("a", MoveMacro("one", "stick", 0.5), show.now)
    (*_, state) = show.states(3.0)
    assert state.channels["jawOpen"] == pytest.approx(0.5, abs=1e-3), "a hand has what it plays"
    assert "pout" not in mix_in("mouth", state.expressions, state.regions), "a pad has not"
    session.receive("a", wire.StopClip("one", seconds=0.2), show.now)
    (*_, state) = show.states(0.3)
    assert mix_in("mouth", state.expressions, state.regions) == pytest.approx({"pout": 1.0})
