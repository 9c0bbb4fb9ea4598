"""A minute of one performer at one console: two pads and a stick without a pause, calls, cues and panic between."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np
import pytest

import omote
from omote.model.known_names import PLAY_REGIONS
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame
from omote.perform.mappings.mapping import HalfBelow, MacroMapping, MacroTarget
from omote.perform.mix import HIGHEST, LOWEST, mix_in
from omote.show.cues.cue_book import FIRST_LIST, CueBook, edit_cues
from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace, Panic
from omote.show.objects.cues import Go
from omote.show.objects.hand.macros import MoveMacro, SetMapping
from omote.show.objects.hand.pads import MovePad
from omote.show.objects.link import Hello, Refused
from omote.show.objects.motion import SetMotion
from omote.show.session import ShowSession

RATE = 60
SECONDS = 60
LOOKED = 30
"""Ticks whose vertices are looked at: those in which weights bend most."""
HIGHEST_STEP = 0.15
"""Metres a second by which the velocity of any vertex may change in a tick (design, hand.md: pads, calls, recasts,
interruptions)."""
STICK = MacroMapping(
    "stick",
    (
        MacroTarget("channel/jawOpen", 0.0, 0.6, ((0.0, 0.0), (0.5, 0.4), (1.0, 1.0)), rise=0.05, fall=0.1),
        MacroTarget("channel/browInnerUp", 0.0, 0.4),
        MacroTarget("head/yaw", 0.0, 0.3, below=HalfBelow(-0.3)),
    ),
)
CUES = [
    omote.Cue("a", "1", {"one/expression": omote.Move({"joy": 1.0}, 0.8)}),
    omote.Cue("b", "2", {"one/face": omote.Move({"old": 1.0}, 2.0), "one/mouth": omote.Move({"smile": 1.0}, 0.5)}),
    omote.Cue("c", "3", {"one/expression": omote.Move({"sad": 1.0}, 1.0, delay=0.4)}),
    omote.Cue("d", "4", {"one/macros": omote.Move({"stick": 0.5}, 1.0), "one/brows": omote.Move({"fear": 1.0}, 0.6)}),
]


def hands(at: float) -> Iterator[ClientMessage]:
    """What both hands do at a time: one pad for the mood, one for the mouth, as fast as people speak, and the stick."""

    def swing(rate: float, phase: float = 0.0) -> float:
        return math.sin(2.0 * math.pi * rate * at + phase)

    yield MovePad("one", "moods", 0.7 * swing(0.25), 0.6 * swing(0.17, 1.0))
    yield MovePad("one", "mouth", 0.7 * swing(0.8), 0.5 * swing(1.1, 0.5))
    yield MoveMacro("one", "stick", swing(1.3))


def presses() -> Mapping[int, ClientMessage]:
    """What is pressed between, by tick: GO each 13 s, a call each 3.7 s, two panics, the hands going on."""
    cues = {RATE * (5 + 13 * place): Go(f"go {place}") for place in range(len(CUES))}
    calls: dict[int, ClientMessage] = {
        round(RATE * 3.7 * place): CallFace("one", f"face {place}", face, 1.0)
        if place % 2
        else CallExpression("one", f"look {place}", look, 0.5)
        for place, (face, look) in enumerate(
            zip(["kaori", "child", "dog", "man"] * 4, ["joy", "angry"] * 8, strict=True), 1
        )
    }
    return {**calls, **cues, RATE * 28 + 7: Panic("one", "panic 1"), RATE * 51 + 3: Panic("one", "panic 2")}


def weights_of(frame: Frame) -> dict[str, float]:
    """All weights of a frame, by names of their own."""
    mixes = {"face": frame.faces, "channel": frame.channels}
    mixes |= {region: mix_in(region, frame.expressions, frame.regions) for region in PLAY_REGIONS}
    return {f"{part}/{name}": weight for part, mix in mixes.items() for name, weight in mix.items()}


def test_a_minute_alone_has_no_jump(monkeypatch: pytest.MonkeyPatch) -> None:
    cast = omote.load_cast()
    session = ShowSession(cast)
    session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    session.cues.load(
        edit_cues(CueBook(), "write", "ana", {each.identity: each for each in CUES}, {FIRST_LIST: list("abcd")})
    )
    frames: list[Frame] = []
    monkeypatch.setattr(session.clips, "note", lambda scene: frames.append(scene.characters["one"].frame))
    refused: list[str] = []

    def send(message: ClientMessage, now: float) -> None:
        said = session.receive("ana", message, now)
        refused.extend(each.message.reason for each in said if isinstance(each.message, Refused))

    send(SetMapping("one", "set", STICK), 0.0)
    send(SetMotion("one", liveliness=0.5, blinks=0.0, gaze=0.0), 0.0)  # lids and eyes jump by nature
    pressed = presses()
    for tick in range(RATE * SECONDS):
        now = tick / RATE
        for message in hands(now):
            send(message, now)
        if tick in pressed:
            send(pressed[tick], now)
        session.tick(now)
    assert refused == []
    assert len(frames) == RATE * SECONDS
    weights = [weights_of(frame) for frame in frames]
    mixed = [weight for each in weights for name, weight in each.items() if not name.startswith("channel")]
    assert min(mixed) >= LOWEST - 1e-9
    assert max(mixed) <= HIGHEST + 1e-9
    names = sorted({name for each in weights for name in each})
    table = np.array([[each.get(name, 0.0) for name in names] for each in weights])
    bends = np.abs(np.diff(table, 2, axis=0)).sum(axis=1)
    for place in np.argsort(bends)[-LOOKED:]:
        before, at, after = (evaluate(cast, frame).astype(np.float64) for frame in frames[place : place + 3])
        step = RATE * float(np.linalg.norm(after - 2.0 * at + before, axis=-1).max())
        assert step <= HIGHEST_STEP, f"at {(place + 1) / RATE:.3f} s"
