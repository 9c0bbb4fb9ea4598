"""Automatic motion as a whole: deterministic, smooth, within what the literature says."""

import itertools
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import Gaze, Head, Held, MotionSettings, with_fields
from omote.perform.layers.layer_names import DRIVEN
from omote.perform.layers.layer_vectors import Layers
from omote.perform.layers.layers import begin, drive
from omote.perform.layers.source_frame import AUTOMATIC, source_frame
from omote.perform.motion.automatic_motion import (
    LIDS,
    MOTION_LAYERS,
    AutomaticMotion,
    advance_motion,
    figure_idle,
    is_free,
    is_speaking,
    motion_frames,
    set_motion,
)
from omote.perform.motion.blinks import Blinks
from omote.perform.motion.breathing import BREATH_CHANNELS, NOISE_CHANNELS, Breath
from omote.perform.motion.gaze_motion import GazeMotion
from omote.perform.motion.head_following import Turn
from omote.perform.motion.sight import Sight
from omote.perform.performer import Performer

NAMES = {*LIDS, *BREATH_CHANNELS, *NOISE_CHANNELS}
SEEDS = st.integers(0, 2**31 - 1)
PEOPLE = MotionSettings(0.5)


def play(settings: MotionSettings, steps: int, dt: float = 1 / 60, *, speaking: bool = False) -> list[AutomaticMotion]:
    """The motion after each of some steps."""
    motion = set_motion(AutomaticMotion(), settings)
    return [motion := advance_motion(motion, dt, speaking=speaking) for _ in range(steps)]


@given(SEEDS)
@settings(max_examples=10)
def test_the_same_seed_moves_the_same_to_the_last_bit(seed: int) -> None:
    asked = MotionSettings(0.7, seed=seed)
    one = play(asked, 300)
    other = play(asked, 300)
    assert one == other
    assert one[:299] != play(MotionSettings(0.7, seed=seed + 1), 299)
    for first, second in zip(one, other, strict=True):
        for layer, frame in motion_frames(first, NAMES).items():
            same = motion_frames(second, NAMES)[layer]
            assert (frame.values == same.values).all()
            assert (frame.head, frame.gaze) == (same.head, same.gaze)


@given(SEEDS, st.floats(0.0, 1.0), st.floats(0.0, 2.0))
@settings(max_examples=20)
def test_nothing_leaves_its_range_whatever_is_set(seed: int, liveliness: float, detail: float) -> None:
    for motion in play(MotionSettings(liveliness, detail, detail, detail, seed), 400, 0.05):
        frames = motion_frames(motion, NAMES)
        assert bool(frames) == (liveliness > 0.0)
        if frames:
            assert np.abs(frames["breath"].values).max() <= 0.05
            assert 0.0 <= frames["blink"].values.min() <= frames["blink"].values.max() <= 1.0


def test_an_hour_has_the_statistics_of_the_literature() -> None:
    """15 to 20 blinks and 12 to 16 breaths a minute; contact in spells of 1 to 5 s; more blinks in speech."""
    hour = 3600.0
    dt = 0.04
    motion = set_motion(AutomaticMotion(), PEOPLE)
    spoken = set_motion(AutomaticMotion(), PEOPLE)
    began = list[float]()
    spells = list[float]()
    since = 0.0
    for _ in range(int(hour / dt)):
        before = motion
        motion = advance_motion(motion, dt)
        spoken = advance_motion(spoken, dt, speaking=True)
        if motion.blinks.count != before.blinks.count:
            began.append(motion.blinks.began)
        if motion.gaze.contact != before.gaze.contact:
            spells += [motion.time - since] if before.gaze.contact else []
            since = motion.time
    pauses = np.diff(began)
    assert 15.0 <= 60.0 * len(began) / hour <= 20.0
    assert 12.0 <= 60.0 * motion.breath.count / hour <= 16.0
    assert pauses.mean() > 1.15 * np.median(pauses)  # lognormal: a long tail of long pauses
    assert 1.0 <= np.quantile(spells, 0.05) <= np.quantile(spells, 0.95) <= 7.0
    assert spoken.blinks.count > 1.1 * motion.blinks.count


@given(SEEDS, st.lists(st.floats(0.0, 1.0), min_size=3, max_size=6))
@settings(max_examples=20)
def test_nothing_jumps_when_it_is_set_otherwise(seed: int, given_values: list[float]) -> None:
    """The eyes make saccades, which are quick; all else moves by little in a frame."""
    motion = set_motion(AutomaticMotion(), MotionSettings(1.0, seed=seed))
    shown = []
    for value in given_values:
        motion = set_motion(motion, MotionSettings(max(value, 0.01), seed=seed))
        for _ in range(30):
            motion = advance_motion(motion, 1 / 60)
            frame = motion_frames(motion, NAMES)["breath"]
            head = motion_frames(motion, NAMES)["gaze"].head
            assert frame.head is not None
            assert head is not None
            shown.append([*frame.values, frame.head.yaw, frame.head.pitch, frame.head.roll, head.yaw, head.pitch])
    assert np.abs(np.diff(shown, axis=0)).max() < 0.02


@pytest.mark.parametrize("yaw", [0.5, -0.5, 0.9])
def test_eyes_and_head_together_look_at_what_is_seen(yaw: float) -> None:
    """The eyes turn back by what the head has come, so that the look stays."""
    motion = set_motion(AutomaticMotion(), MotionSettings(0.5, gaze=0.0, breath=0.0))
    seen = Turn(yaw)
    for _ in range(240):
        motion = advance_motion(motion, 1 / 60, sight=Sight(seen))
    shown = motion_frames(motion, NAMES)["gaze"]
    assert shown.head is not None
    assert shown.gaze is not None
    assert shown.head.yaw + shown.gaze.yaw == pytest.approx(yaw, abs=1e-3)
    assert abs(shown.gaze.yaw) < abs(yaw)


def test_a_figure_breathes_with_the_face_and_shifts_its_weight_slowly_from_foot_to_foot() -> None:
    moving = np.array([figure_idle(motion) for motion in play(PEOPLE, 60 * 600)])[120:]
    breath, left = moving.T
    assert 0.0 <= breath.min() < 0.01
    assert 0.95 < breath.max() <= 1.0
    assert -1.0 <= left.min() < -0.2
    assert 0.2 < left.max() <= 1.0
    assert np.abs(np.diff(left)).max() * 60 < 0.5, "a second"
    assert 20 <= np.count_nonzero(np.diff(np.sign(left))) <= 200, "in ten minutes"
    assert [figure_idle(motion) for motion in play(MotionSettings(0.0), 60)] == [(0.0, 0.0)] * 60


def test_lids_lead_a_far_shift_of_the_gaze() -> None:
    motion = set_motion(AutomaticMotion(), PEOPLE)
    motion = advance_motion(motion, 0.5)
    shifted = advance_motion(motion, 1 / 60, sight=Sight(Turn(0.7)))
    assert shifted.blinks.count > motion.blinks.count
    assert shifted.blinks.began < shifted.gaze.saccade.began


@given(SEEDS, st.floats(1.0, 1e7))
@settings(max_examples=20)
def test_a_gap_of_any_length_goes_on(seed: int, gap: float) -> None:
    motion = advance_motion(play(MotionSettings(0.5, seed=seed), 10)[-1], gap)
    later = list(itertools.accumulate([1 / 60] * 60, advance_motion, initial=motion))
    assert all(math.isfinite(each.time) for each in later)
    assert later[-1].gaze.fixation > later[-1].time - 2.0


def test_channels_that_there_are_not_are_left_out() -> None:
    frames = motion_frames(play(PEOPLE, 1)[0], {"jawOpen"})
    assert frames["breath"].names == ("jawOpen",)
    assert frames["blink"].names == ()


def lively(cast: Cast, liveliness: float = 0.5) -> Performer:
    """A performer that moves by itself for two seconds."""
    performer = Performer(cast)
    performer.set_motion(liveliness, seed=5)
    for _ in range(120):
        performer.advance(1 / 60)
    return performer


def test_a_character_that_moves_by_itself_drives_layers_that_no_source_drives(cast: Cast) -> None:
    performer = lively(cast)
    frame = performer.advance(1 / 60)
    assert {layer: each.source for layer, each in frame.layers.items()} == dict.fromkeys(MOTION_LAYERS, AUTOMATIC)
    assert frame.motion == MotionSettings(0.5, seed=5)
    for _ in range(240):
        performer.drive({}, layer="gaze", gaze=(0.3, 0.0))
        frame = performer.advance(1 / 60)
    assert frame.layers["gaze"].source == ""
    assert frame.gaze.yaw == pytest.approx(0.3, abs=1e-3)
    for _ in range(300):  # the source is silent: it fades out, and stays the one that drives
        frame = performer.advance(1 / 60)
    assert frame.layers["gaze"].trust < 0.01


def test_it_goes_on_from_a_snapshot_bit_for_bit(cast: Cast) -> None:
    performer = lively(cast)
    other = Performer.restored(cast, performer.snapshot())
    for _ in range(120):
        assert performer.advance(1 / 60) == other.advance(1 / 60)


def test_panic_ends_it_and_it_can_be_set_again_at_once(cast: Cast) -> None:
    """No layer is switched off by it: only sources are."""
    performer = lively(cast, 1.0)
    performer.panic()
    frames = [performer.advance(1 / 60) for _ in range(60)]
    assert frames[-1].motion == MotionSettings(0.0, seed=5)
    assert (frames[-1].head, frames[-1].gaze, dict(frames[-1].channels)) == (Head(), Gaze(), {})
    assert frames[-1].layers == {}
    performer.set_motion(0.5)
    assert all(each.on for each in performer.advance(1 / 60).layers.values())


def test_what_is_switched_off_fades_out_and_leaves_nothing(cast: Cast) -> None:
    performer = lively(cast, 1.0)
    performer.set_motion(0.0)
    heads = [performer.advance(1 / 60).head for _ in range(600)]
    steps = [abs(later.yaw - before.yaw) for before, later in itertools.pairwise(heads)]
    assert max(steps) < 0.02
    assert performer.advance(1 / 60).layers == {}
    assert performer.snapshot().layers is None


def test_settings_that_do_nothing_change_no_bit(cast: Cast) -> None:
    performer = Performer(cast)
    plain = Performer(cast)
    performer.set_motion(0.0, blinks=2.0)
    for each in (performer, plain):
        each.call_expression("smile", seconds=1.0)
    for _ in range(90):
        frame = performer.advance(1 / 60)
        assert replace(frame, motion=None) == plain.advance(1 / 60)


@pytest.mark.parametrize(
    "broken",
    [
        {"time": math.nan},
        {"depth": (0.0, 9.0)},
        {"blinks": Blinks(depth=2.0)},
        {"breath": Breath(seconds=0.0)},
        {"gaze": GazeMotion(seen=Turn(99.0))},
        {"gaze": GazeMotion(fixation=math.inf)},
    ],
    ids=["time", "depth", "lids", "breath", "gaze", "fixation"],
)
def test_a_snapshot_that_none_can_have_written_is_rejected(cast: Cast, broken: dict[str, Any]) -> None:
    snapshot = lively(cast).snapshot()
    assert snapshot.motion is not None
    with pytest.raises(ValueError, match=r"expected|between|finite|is"):
        Performer.restored(cast, replace(snapshot, motion=replace(snapshot.motion, **broken)))


def looks(performer: Performer, steps: int) -> list[list[float]]:
    """Head and eyes of some frames."""
    frames = [performer.advance(1 / 60) for _ in range(steps)]
    return [[each.head.yaw, each.head.pitch, each.channels.get("jawOpen", 0.0)] for each in frames]


def track(performer: Performer, steps: int) -> list[list[float]]:
    """The same, while a tracker sends."""
    shown = []
    for _ in range(steps):
        performer.drive({"jawOpen": 0.8}, layer="tracker", head=(0.5, 0.1, 0.0), gaze=(0.1, 0.0))
        shown += looks(performer, 1)
    return shown


@pytest.mark.parametrize("leaves", [False, True], ids=["silent", "gone"])
def test_a_character_idles_while_its_tracker_is_lost_and_gives_way_upon_return(cast: Cast, leaves: bool) -> None:
    performer = Performer(cast)
    performer.set_motion(idle=True)
    shown = track(performer, 240)
    assert set(performer.advance(0.0).layers) == {"tracker"}
    if leaves:
        performer.leave_layer("tracker", "")
    shown += looks(performer, 600)
    frame = performer.advance(0.0)
    assert frame.layers["gaze"].source == AUTOMATIC
    assert frame.layers["gaze"].trust == pytest.approx(1.0)
    assert frame.channels["browInnerUp"] != 0.0
    shown += track(performer, 600)
    assert set(performer.advance(0.0).layers) == {"tracker"}
    assert np.abs(np.diff(shown, n=2, axis=0)).max() < 0.01


def test_what_is_not_to_idle_holds_still(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_motion(idle=False)
    track(performer, 240)
    looks(performer, 600)
    frame = performer.advance(0.0)
    assert set(frame.layers) == {"tracker"}
    assert (frame.head, dict(frame.channels)) == (Head(), {})


@pytest.mark.parametrize("leaves", [False, True], ids=["silent", "gone"])
def test_panic_ends_the_idle_motion_and_the_look(cast: Cast, leaves: bool) -> None:
    """Also of a tracker that has long gone: its layer is none that a panic would switch off."""
    performer = Performer(cast)
    performer.set_motion(idle=not leaves)
    performer.look_at("direction", yaw=0.4)
    track(performer, 240)
    if leaves:
        performer.leave_layer("tracker", "")
    looks(performer, 600)
    performer.set_motion(idle=True)
    looks(performer, 300)
    assert performer.advance(0.0).channels["browInnerUp"] != 0.0
    performer.panic()
    looks(performer, 120)
    frame = performer.advance(0.0)
    assert (frame.head, frame.gaze, dict(frame.channels)) == (Head(), Gaze(), {})
    assert frame.motion == MotionSettings(idle=True)


def test_what_moves_in_small_steps_is_followed_without_a_step(cast: Cast) -> None:
    """A camera that a stage tells of once a second."""
    performer = Performer(cast)
    shown = []
    for second in range(6):
        performer.look_at("direction", yaw=0.04 * second)
        shown += [performer.advance(1 / 60).gaze.yaw for _ in range(60)]
    assert np.abs(np.diff(shown)).max() < 0.02
    assert shown[-1] == pytest.approx(0.2, abs=1e-3)


def driven(cast: Cast, layer: str, source: str) -> Layers:
    """Layers of which a source drives one."""
    frame = with_fields(source_frame(cast.expressions, {"jawOpen": 0.04}, None, None), source=source)
    return drive(cast, begin(cast, Held()), next(each for each in DRIVEN if each == layer), frame)


@pytest.mark.parametrize("layer", ["gaze", "breath"])
def test_a_layer_is_free_where_nothing_drives_it_or_the_character_itself_does(cast: Cast, layer: str) -> None:
    name = next(each for each in DRIVEN if each == layer)
    assert is_free(begin(cast, Held()), name)
    assert is_free(driven(cast, layer, AUTOMATIC), name)
    assert not is_free(driven(cast, layer, "phone"), name)
    assert is_free(driven(cast, "lips", "phone"), name)


def test_lips_speak_while_a_source_moves_them(cast: Cast) -> None:
    performer = Performer(cast)
    spoken = []
    for weight in [0.0] * 60 + [0.6] * 60 + [0.0] * 60:
        performer.drive({"jawOpen": weight}, layer="lips")
        performer.advance(1 / 60)
        assert performer._layers is not None
        spoken.append(is_speaking(performer._layers))
    assert (spoken[50], spoken[110], spoken[-1]) == (False, True, False)
    assert not is_speaking(driven(cast, "gaze", "phone"))
