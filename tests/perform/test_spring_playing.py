"""A performer's springs: on by liveliness, above all layers, in snapshots to the bit, at rest after a panic."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import msgspec
import pytest

import omote
from omote.model.cast import Cast
from omote.perform.frame import Frame
from omote.perform.performer import Performer
from omote.perform.scene.scene import Scene
from omote.perform.snapshot import Snapshot
from omote.perform.springs.cast_springs import SpringName

EARS: SpringName = "ears-sway"


@pytest.fixture(scope="module")
def eared(cast: Cast) -> Cast:
    return cast.with_expressions(**{EARS: replace(cast.expressions["smile"], signed=True)})


def lively(cast: Cast, *, gaze: float = 0.0, breath: float = 0.0) -> Performer:
    performer = Performer(cast)
    performer.set_motion(0.5, blinks=0.0, gaze=gaze, breath=breath)
    return performer


def shake(performer: Performer, ticks: int, first: int = 0) -> list[Frame]:
    frames = []
    for tick in range(first, first + ticks):
        performer.set_head(0.26 * math.sin(4.0 * math.pi * tick / 60.0), 0.0, 0.0)
        frames.append(performer.advance(1 / 60))
    return frames


def most(frames: list[Frame]) -> float:
    return max(abs(frame.channels.get(EARS, 0.0)) for frame in frames)


def largest_step(frames: list[Frame]) -> float:
    return max(abs(b.channels.get(EARS, 0.0) - a.channels.get(EARS, 0.0)) for a, b in pairwise(frames))


def test_who_holds_still_has_none(eared: Cast) -> None:
    assert most(shake(Performer(eared), 90)) == 0.0
    frames = shake(lively(eared), 90)
    assert 0.3 < most(frames) < 1.0
    assert min(frame.channels.get(EARS, 0.0) for frame in frames) < -0.3


def test_who_lives_and_moves_little_leaves_the_channel_alone(eared: Cast) -> None:
    performer = lively(eared, breath=1.0, gaze=0.2)
    frames = [performer.advance(1 / 60) for _ in range(120)]
    assert most(frames) < 0.05


def test_they_add_to_what_hands_hold_and_leave_it_to_them(eared: Cast) -> None:
    performer = lively(eared)
    performer.set_channel(EARS, 0.5)
    frames = shake(performer, 90)
    held = frames[-1].held
    assert held is not None
    assert held.channels == {EARS: 0.5}
    assert max(frame.channels[EARS] for frame in frames) > 0.8
    assert all(-1.0 <= frame.channels[EARS] <= 1.5 for frame in frames)
    omote.evaluate(eared, frames[-1])


def test_one_is_switched_on_and_off_within_a_shake_without_a_jump(eared: Cast) -> None:
    performer = lively(eared)
    plain = shake(performer, 120)
    fastest = largest_step(plain)
    performer.set_spring(EARS, 0.0)
    frames = [plain[-1], *shake(performer, 120, 120)]
    assert frames[-1].channels.get(EARS, 0.0) == 0.0
    performer.set_spring(EARS, 1.0)
    frames += shake(performer, 120, 240)
    assert most(frames[-30:]) > 0.9 * most(plain[-30:])
    assert largest_step(frames) < 1.2 * fastest


def test_a_snapshot_goes_on_to_the_bit(eared: Cast) -> None:
    performer = lively(eared)
    performer.set_spring(EARS, 1.5)
    shake(performer, 70)
    written = msgspec.json.encode(performer.snapshot())
    other = Performer.restored(eared, msgspec.json.decode(written, type=Snapshot))
    assert shake(performer, 60, 70) == shake(other, 60, 70)
    assert performer.snapshot() == other.snapshot()


def test_they_are_kept_through_a_recast_and_wait_where_a_cast_has_no_such_channel(eared: Cast, cast: Cast) -> None:
    performer = lively(eared)
    shake(performer, 70)
    performer.recast(eared.with_expressions(beam=eared.expressions["smile"]))
    moving = performer.snapshot().springs
    assert moving is not None
    assert moving.moving[EARS].turn
    performer.recast(cast)
    assert EARS not in performer.advance(1 / 60).channels


def test_a_panic_brings_them_to_rest_in_its_quarter_of_a_second(eared: Cast) -> None:
    performer = lively(eared)
    before = shake(performer, 70)[-1]
    performer.panic()
    frames = [before, *(performer.advance(1 / 60) for _ in range(16))]
    assert EARS not in frames[-1].channels
    assert largest_step(frames) < 0.35
    assert [performer.advance(1 / 60).channels for _ in range(30)] == [{}] * 30


def test_steps_of_no_time_change_nothing(eared: Cast) -> None:
    performer = lively(eared)
    shown = shake(performer, 70)[-1]
    assert performer.advance(0.0).channels == shown.channels


def test_a_character_that_is_moved_across_the_stage_drives_them_too(eared: Cast) -> None:
    scene = Scene.begun(eared)
    scene["one"].set_motion(0.5, blinks=0.0, gaze=0.0, breath=0.0)
    for _ in range(60):
        scene.advance(1 / 60)
    scene.place("one", x=0.3, seconds=0.4)
    frames = [scene.advance(1 / 60).characters["one"].frame for _ in range(60)]
    assert most(frames) > 0.1
    first = next(frame.channels[EARS] for frame in frames if EARS in frame.channels)
    assert first < 0.0  # ears stay behind


@pytest.mark.parametrize(("name", "amount"), [("tail", 1.0), (EARS, -0.1), (EARS, 2.1), (EARS, math.nan)])
def test_what_is_no_spring_or_no_amount_is_refused(eared: Cast, name: str, amount: float) -> None:
    performer = Performer(eared)
    with pytest.raises(ValueError, match="spring"):
        performer.set_spring(name, amount)
    assert performer.advance(0.0).springs == {}
