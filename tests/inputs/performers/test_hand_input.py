"""Hands before cameras at a session: beside their performer's face, of a character of their own, lost and damaged."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.hand_input import POINT, HandInput
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession

TICK = 1.0 / 60.0


class Stage:
    """A session with a hand, and a face beside it."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast)
        self.session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
        self.hands = HandInput(lambda: self.session)
        self.face = TrackerInput(TRACKER_PROTOCOLS["vmc"], lambda: self.session)
        self.now = 0.0

    def play(self, seconds: float, frame: wire.HandFrame | None, face: TrackerFrame | None = None) -> CharacterState:
        for _ in range(round(seconds / TICK)):
            if frame is not None:
                self.hands.receive("Ada", frame)
            if face is not None:
                self.face.note("", face)
                self.face.play(self.now)
            self.hands.play(self.now)
            self.now += TICK
            state = self.session.tick(self.now)
        return state.characters["one"]


@pytest.fixture
def stage(cast: Cast) -> Stage:
    titles = {"jawOpen": Title("jaw", region="jaw"), "browInnerUp": Title("brows", region="brows")}
    return Stage(replace(cast, titles={**cast.titles, **titles}))


def frame(jaw: float, yaw: float = 0.0, *, found: bool = True) -> wire.HandFrame:
    return wire.HandFrame(0.0, found, {"jawOpen": jaw}, (yaw, 0.0, 0.0))


def test_a_hand_takes_the_mouth_and_the_head_of_a_face_and_gives_them_back(stage: Stage) -> None:
    face = TrackerFrame({"jawOpen": 0.1, "browInnerUp": 0.6}, (0.2, 0.0, 0.0), subject="Bo")
    stage.play(2.0, None, face)
    stage.hands.choose("Ada", wire.PlayHand(["one"], ["mouth", "head"]))
    shown = stage.play(4.0, frame(0.8, 0.5), face)
    assert shown.channels["jawOpen"] == pytest.approx(0.8, abs=2e-3)
    assert shown.channels["browInnerUp"] == pytest.approx(0.6, abs=2e-3)
    assert shown.head[0] == pytest.approx(0.5, abs=2e-3)
    choice = stage.hands.choice("Ada")
    assert ([each.played for each in choice.characters], choice.regions) == ([True], ["mouth", "head"])
    shown = stage.play(4.0, frame(0.8, 0.5, found=False), face)
    assert shown.channels["jawOpen"] == pytest.approx(0.1, abs=2e-3)
    assert shown.head[0] == pytest.approx(0.2, abs=2e-3)


def test_a_hand_is_a_source_from_its_first_frame_to_its_end(stage: Stage) -> None:
    stage.hands.choose("Ada", wire.PlayHand(["one"], []))
    assert [each.name for each in stage.session.sources.states({})] == []
    assert [each.played for each in stage.hands.choice("Ada").characters] == [True]
    stage.play(1.0, frame(0.5))
    assert [each.name for each in stage.session.sources.states({})] == ["Hand Ada"]
    stage.hands.end("Ada")
    assert [each.name for each in stage.session.sources.states({})] == []
    assert [each.played for each in stage.hands.choice("Ada").characters] == [True]


def test_the_other_hand_moves_the_point_of_a_pad_on_the_characters_of_the_hand(stage: Stage) -> None:
    pad = next(name for name, kept in stage.session.scene.pads.items() if kept.dimensions >= POINT)
    assert pad in stage.hands.choice("Ada").pads
    stage.hands.choose("Ada", wire.PlayHand(["one"], []))
    for name in (pad, "no pad", pad):
        stage.play(0.5, wire.HandFrame(0.0, True, {"jawOpen": 0.0}, None, name, (0.25, -7.0)))
    assert stage.session.tick(stage.now).characters["one"].pads[pad].place[:2] == pytest.approx((0.25, -1.0))
    assert stage.hands.trackers.rejected == 0


def test_no_number_of_a_frame_breaks_what_shows(stage: Stage) -> None:
    stage.hands.choose("Ada", wire.PlayHand(["one"], []))

    @settings(max_examples=60, deadline=None)
    @given(value=st.floats(), angle=st.floats(), name=st.text(max_size=8))
    def play(value: float, angle: float, name: str) -> None:
        shown = stage.play(2 * TICK, wire.HandFrame(value, True, {"jawOpen": value, name: value}, (angle, value, 0.0)))
        assert all(math.isfinite(each) for each in (*shown.channels.values(), *shown.head))

    play()
