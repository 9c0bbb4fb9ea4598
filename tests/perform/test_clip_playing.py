"""Clips on a performer: what was recorded comes back to the bit, fades never jump, and what lies beside goes on."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.model.space.expression import Title
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.clip_runs import MOST_RUNS
from omote.perform.clips.cut_clip import cut_curve, record
from omote.perform.clips.motion_curve import make_curve
from omote.perform.frame import Frame
from omote.perform.layers.source_frame import source_frame
from omote.perform.mix import mix_in
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot

DT = 1.0 / 60.0
UNITS = ("browInnerUp", "jawOpen")


@pytest.fixture(scope="session")
def people(cast: Cast) -> Cast:
    """A cast whose channels belong to parts of the face."""
    titles = {"jawOpen": Title("jaw", region="jaw"), "browInnerUp": Title("brows", region="brows")}
    return replace(cast, titles={**cast.titles, **titles})


def perform(cast: Cast, seconds: float = 2.0) -> tuple[list[tuple[float, Frame]], Clip]:
    """A tracker under calls of the face and of a region, with the character's own motion; and the clip of it."""
    performer = Performer(cast)
    performer.set_motion(0.5)
    shown = [(0.0, performer.advance(0.0))]
    for tick in range(1, round(seconds / DT) + 1):
        weights = {name: 0.5 + 0.4 * np.sin(tick / 7 + place) for place, name in enumerate(UNITS)}
        performer.drive(weights, layer="tracker", head=(0.2 * np.sin(tick / 9), 0.05, 0.0), gaze=(0.1, 0.05))
        if tick == 20:
            performer.call_expression("jawOpen", seconds=0.5)
            performer.set_layer("tracker", influence=0.4)
        if tick == 40:
            performer.call_expression("browInnerUp", seconds=0.5, region="mouth")
        shown.append((tick * DT, performer.advance(DT)))
    return shown, Clip([Lane(cut_curve(shown, cast, start=0.0, stop=seconds))])


def numbers(frame: Frame) -> dict[str, float]:
    """All that a frame shows which clips have, by name."""
    mixes = {region: mix_in(region, frame.expressions, frame.regions) for region in PLAY_REGIONS}
    found = {f"{region} {name}": value for region, mix in mixes.items() for name, value in mix.items()}
    found |= {name: value for name, value in frame.channels.items() if not name.startswith("eyeLook")}
    return found | {f"head {name}": v for name, v in vars(frame.head).items()} | {
        f"gaze {name}": v for name, v in vars(frame.gaze).items()
    }  # fmt: skip


def farthest(one: Frame, other: Frame) -> float:
    a, b = numbers(one), numbers(other)
    return max(abs(a.get(name, 0.0) - b.get(name, 0.0)) for name in {**a, **b})


def test_a_clip_shows_what_was_recorded_to_the_bit_over_whatever_plays(people: Cast) -> None:
    shown, clip = perform(people)
    performer = Performer(people)
    performer.call_expression("jawOpen", seconds=0)
    performer.drive({"browInnerUp": 1.0}, layer="tracker")
    performer.play_clip(clip, seconds=0)
    clip_frames = [performer.advance(DT if place else 0.0) for place in range(len(shown) - 25)]
    assert max(farthest(one, other) for (_, one), other in zip(shown, clip_frames, strict=False)) == 0.0


def test_fades_and_interruptions_never_jump(people: Cast) -> None:
    _, clip = perform(people)
    still = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {"jawOpen": 2}), parts=("mouth",))])
    performer = Performer(people)
    frames = [performer.advance(DT)]
    acts = {
        5: lambda: performer.play_clip(clip, seconds=0.3),
        15: lambda: performer.play_clip(still, seconds=0.4),
        30: lambda: performer.play_clip(clip, seconds=0.3, speed=0.5, weights={"brows": 0.5, "head": 1.0}),
        80: lambda: performer.stop_clip(seconds=0.3),
    }
    for tick in range(160):
        acts.get(tick, lambda: None)()
        frames.append(performer.advance(DT))
    steps = [farthest(one, other) for one, other in pairwise(frames)]
    assert max(steps) < 2.2 * DT / 0.3  # the quintic's steepest is 1.9 of its way in its time
    assert farthest(frames[0], frames[-1]) == 0.0
    assert frames[-1].clips == ()


def test_a_cut_shows_at_once_and_is_gone_at_once(people: Cast) -> None:
    still = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {"jawOpen": 2}))], blend_out=0.0)
    performer = Performer(people)
    performer.play_clip(still, seconds=0)
    assert performer.advance(DT).channels == {"jawOpen": 0.9}
    performer.stop_clip(seconds=0)
    assert performer.advance(DT).channels == {}


def test_one_part_of_a_clip_leaves_the_others_to_whoever_plays_them(people: Cast) -> None:
    shown, clip = perform(people)
    performer = Performer(people)
    performer.call_expression("browInnerUp", seconds=0)
    performer.set_channel("browInnerUp", 0.25)
    performer.play_clip(clip, seconds=0, weights={"mouth": 1.0})
    for _, before in shown[1:90]:
        frame = performer.advance(DT)
        mouth = mix_in("mouth", before.expressions, before.regions)
        assert mix_in("mouth", frame.expressions, frame.regions) == pytest.approx(mouth, abs=1e-12)
        assert {mix_in(region, frame.expressions, frame.regions)["browInnerUp"] for region in ("brows", "eyes")} == {
            1.0
        }
        assert frame.channels["jawOpen"] == before.channels["jawOpen"]
        assert (frame.channels["browInnerUp"], frame.head.yaw) == (0.25, 0.0)


@settings(max_examples=10, deadline=None)
@given(cut=st.integers(1, 100), speed=st.sampled_from([0.3, 1.0, 3.0]), loop=st.booleans())
def test_a_restored_performer_goes_on_with_its_clips_to_the_bit(
    people: Cast, cut: int, speed: float, loop: bool
) -> None:
    _, clip = perform(people)
    performer = Performer(people)
    performer.play_clip(clip, name="line1", speed=speed, loop=loop)
    for _ in range(cut):
        performer.advance(DT)
    wire = msgspec.json.encode(performer.snapshot())
    again = Performer.restored(people, msgspec.json.decode(wire, type=Snapshot))
    again.find_clips({"line1": clip})
    assert [again.advance(DT) for _ in range(60)] == [performer.advance(DT) for _ in range(60)]


def test_a_clip_that_is_not_there_after_a_restart_is_over(people: Cast) -> None:
    _, clip = perform(people)
    performer = Performer(people)
    performer.play_clip(clip, name="line1")
    performer.advance(DT)
    again = Performer.restored(people, performer.snapshot())
    again.find_clips({"other": clip})
    assert again.advance(DT).clips == ()


def test_a_loop_goes_on_without_a_jump(people: Cast) -> None:
    ramp = np.linspace(0.0, 0.9, 61)
    clip = Clip([Lane(make_curve([place * DT for place in range(61)], {"jawOpen": ramp}, {"jawOpen": 2}))], loop=True)
    performer = Performer(people)
    performer.play_clip(clip, seconds=0.25)
    shown = [performer.advance(DT).channels.get("jawOpen", 0.0) for _ in range(300)]
    assert max(abs(b - a) for a, b in pairwise(shown)) < 0.9 * 2.2 * DT / 0.25
    assert performer.advance(DT).clips[0].loop


@pytest.mark.parametrize("seconds", [0.0, 0.3])
def test_a_panic_ends_clips_and_all_eases_to_rest(people: Cast, seconds: float) -> None:
    _, clip = perform(people)
    performer = Performer(people)
    performer.play_clip(clip, seconds=seconds)
    for _ in range(60):
        before = performer.advance(DT)
    performer.panic()
    frames = [before, *(performer.advance(DT) for _ in range(30))]
    assert max(farthest(one, other) for one, other in pairwise(frames)) < 0.4  # a quarter of a second, `early`
    assert farthest(frames[0], performer.advance(0.0)) > 0.1
    assert numbers(frames[-1]) == numbers(Performer(people).advance(0.0))
    assert frames[-1].clips == ()
    assert frames[-1].layers == {}


def test_what_a_clip_played_belongs_to_a_source_again_after_a_panic(people: Cast) -> None:
    """It belonged to nobody, until something else happened to that source; a restored performer had it at once."""
    _, clip = perform(people)
    weights = {"jawOpen": 0.8, "browInnerUp": 0.6}
    sent = source_frame(people.expressions, weights, None, None)

    def drive(performer: Performer, ticks: int) -> Frame:
        for _ in range(ticks):
            performer.drive_layer("playback", replace(sent, source="phone"))
            frame = performer.advance(DT)
        return frame

    performer = Performer(people)
    drive(performer, 30)
    performer.play_clip(clip, seconds=0.2, weights={"brows": 1.0})
    drive(performer, 30)
    performer.panic()
    drive(performer, 60)
    performer.set_layer("playback", on=True)
    other = Performer.restored(people, performer.snapshot())
    frame = drive(performer, 120)
    assert frame.channels == pytest.approx(weights, abs=1e-3)
    assert numbers(drive(other, 120)) == numbers(frame)


def test_a_clip_that_is_called_while_a_panic_eases_comes_without_a_jump(people: Cast) -> None:
    _, clip = perform(people)
    performer = Performer(people)
    performer.play_clip(clip, seconds=0.0)
    frames = [performer.advance(DT) for _ in range(30)]
    performer.panic()
    frames += [performer.advance(DT) for _ in range(5)]
    performer.play_clip(clip, seconds=0.2, start=0.5)
    frames += [performer.advance(DT) for _ in range(30)]
    assert max(farthest(one, other) for one, other in pairwise(frames[31:])) < 2.5 * DT / 0.2
    assert frames[-1].clips[0].name == "clip"


def test_what_the_cast_does_not_have_is_left_out_and_named(people: Cast) -> None:
    own = {"mine": [0.5, 0.5], "neutral": [0.5, 0.5]}
    curve = make_curve([0.0, 9.0], {"jawOpen": [0.5] * 2, "gone": [1.0] * 2}, {}, mixes={"mouth": own})
    performer = Performer(people)
    performer.play_clip(Clip([Lane(curve)]), seconds=0)
    frame = performer.advance(DT)
    assert frame.clips[0].missing == ("gone", "mine")
    assert (frame.channels, frame.expressions, frame.regions) == ({"jawOpen": 0.5}, {"neutral": 1.0}, {})


def test_hands_stay_above_clips(people: Cast) -> None:
    still = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {"jawOpen": 2}))])
    performer = Performer(people)
    performer.set_channel("jawOpen", 0.2)
    performer.play_clip(still, seconds=0)
    assert performer.advance(DT).channels == {"jawOpen": 0.2}


REJECTED: dict[str, Any] = {
    "give an omote.Clip": ("a clip", {}),
    "no part of a clip 'nose'": (None, {"weights": {"nose": 1.0}}),
    "the weight of a clip on mouth is 2": (None, {"weights": {"mouth": 2.0}}),
    "the speed of a clip is 0": (None, {"speed": 0.0}),
    "it cannot begin at 5 s": (None, {"start": 5.0}),
    "the time of a call": (None, {"seconds": -1.0}),
}


@pytest.mark.parametrize("reason", REJECTED)
def test_what_cannot_be_played_is_rejected_and_changes_nothing(people: Cast, reason: str) -> None:
    clip = Clip([Lane(record(Performer(people), people, seconds=1.0))])
    performer = Performer(people)
    before = performer.snapshot()
    wrong, options = REJECTED[reason]
    with pytest.raises((ValueError, TypeError), match=reason):
        performer.play_clip(clip if wrong is None else wrong, **options)
    assert performer.snapshot() == before
    for _ in range(MOST_RUNS):
        performer.play_clip(clip)
    with pytest.raises(ValueError, match="8 clips play already"):
        performer.play_clip(clip)


def test_a_panic_takes_over_the_speed_of_what_a_clip_shows(people: Cast) -> None:
    """As of the calls that it was recorded of: it began from a stand."""
    caller = Performer(people)
    caller.call_expression("jawOpen", seconds=0.5)
    shown = [(0.0, caller.advance(0.0)), *((tick * DT, caller.advance(DT)) for tick in range(1, 60))]
    clip = Clip([Lane(cut_curve(shown, people, start=0.0, stop=59 * DT))])
    called, played = Performer(people), Performer(people)
    called.call_expression("jawOpen", seconds=0.5)
    played.play_clip(clip, seconds=0)
    for performer in (called, played):
        performer.advance(0.25)
        performer.panic()
    for _ in range(20):
        weights = [performer.advance(DT).expressions.get("jawOpen", 0.0) for performer in (called, played)]
        assert weights[1] == pytest.approx(weights[0], abs=2e-3)


@pytest.mark.parametrize("tick", [240, 360])
def test_a_panic_takes_over_the_speed_of_channels(people: Cast, tick: int) -> None:
    """What a clip moved at 2.5 a second stood at once; the easing of a panic alone changes it by half of that."""
    step = 1.0 / 240.0
    times = np.arange(0.0, 4.0, DT)
    swings = 0.45 + 0.4 * np.sin(2.0 * np.pi * times)
    performer = Performer(people)
    performer.play_clip(
        Clip([Lane(make_curve(times.tolist(), {"jawOpen": swings.tolist()}, {"jawOpen": 2}))]), seconds=0
    )
    shown = [performer.advance(step).channels.get("jawOpen", 0.0) for _ in range(tick)]
    performer.panic()
    restored = Performer.restored(people, performer.snapshot())
    after = [performer.advance(step) for _ in range(80)]
    assert [restored.advance(step) for _ in range(80)] == after
    shown += [frame.channels.get("jawOpen", 0.0) for frame in after]
    assert np.abs(np.diff(np.array(shown), 2)).max() / step < 0.8
    assert -0.1 <= min(shown) <= shown[-1] == 0.0
    assert max(shown) < 1.0


def test_a_clip_that_cuts_after_a_panic_is_no_motion(people: Cast) -> None:
    """Its first value would have shown with the next step: no speed is taken from that."""
    still = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {"jawOpen": 2}))])
    performer = Performer(people)
    performer.play_clip(still, seconds=0)
    performer.panic()
    assert all(performer.advance(0.004).channels.get("jawOpen", 0.0) == 0.0 for _ in range(30))
