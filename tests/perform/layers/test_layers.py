"""Sources, calls and hands on one face: nothing jumps or leaves its range, and without a source all is as ever."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.model.space.expression import Title
from omote.perform.blending.evaluate import check_playable, evaluate, evaluate_parts
from omote.perform.channels import GAZE_UNITS, channels_of, effective_channels
from omote.perform.frame import Frame, Gaze, Head, Held
from omote.perform.layers.drivers import BACK_ACCELERATION
from omote.perform.layers.layer_names import LAYER_PARTS, LAYERS, LayerName
from omote.perform.layers.layer_vectors import Layers
from omote.perform.layers.layers import advance, are_hands_still, begin, drive, drive_direct, hold_by, leave
from omote.perform.layers.source_frame import SourceFrame
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS
from omote.perform.mix import mix_in
from omote.perform.performer import Performer
from tests.conftest import Command, commands, shows

DT = 1.0 / 60.0
FULL = {"jawOpen": 0.8, "smile": 0.4}
yaws, pitches = (st.floats(-limit, limit) for limit in GAZE_LIMITS.values())


def plain(frame: Frame) -> Frame:
    """A frame without what it tells of layers."""
    return replace(frame, layers={}, held=None)


def played(
    cast: Cast, performer: Performer, seconds: float, drive: Callable[[int], None] | None = None
) -> Iterator[Frame]:
    for n in range(round(seconds / DT)):
        if drive is not None:
            drive(n)
        yield performer.advance(DT)


def last(frames: Iterator[Frame]) -> Frame:
    *_, frame = frames
    return frame


quiet_shows = st.lists(commands.filter(lambda each: each.name != "panic"), max_size=20)


@given(quiet_shows)
@settings(max_examples=30)
def test_layers_that_nothing_drives_change_no_bit(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    layered = Performer(cast)
    layered.set_layer("breath", influence=0.5)
    for command in show:
        command.play(performer)
        command.play(layered)
        frame = performer.advance(command.wait)
        other = layered.advance(command.wait)
        assert set(other.layers) == {"breath"}
        assert channels_of(cast.expressions, other) == channels_of(cast.expressions, frame)
        assert (other.expressions, other.regions, other.head, other.gaze) == (
            frame.expressions, frame.regions, frame.head, frame.gaze,
        )  # fmt: skip


@given(quiet_shows)
@settings(max_examples=3)
def test_positions_are_those_without_layers(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    layered = Performer(cast)
    layered.set_layer("breath", influence=0.5)
    for command in show:
        command.play(performer)
        command.play(layered)
    frame = performer.advance(0.1)
    other = layered.advance(0.1)
    assert np.abs(evaluate(cast, frame) - evaluate(cast, other)).max() < 1e-6, "a micrometre: sums in another order"
    parts = evaluate_parts(cast, frame)
    others = evaluate_parts(cast, other)
    assert all(np.abs(parts[name] - others[name]).max() < 1e-6 for name in parts)


@pytest.fixture(scope="session")
def slow_eyes(cast: Cast) -> Cast:
    """A cast like the built-in one, whose units turn an eye by so little that a wide gaze makes a weight of three."""
    units = {name: cast.expressions[name] for name in GAZE_UNITS}
    return cast.with_expressions(**{name: replace(unit, eyes=0.4 * unit.eyes) for name, unit in units.items()})


@given(yaws, pitches)
@settings(max_examples=20)
def test_eyes_look_as_far_with_layers_as_without(slow_eyes: Cast, yaw: float, pitch: float) -> None:
    performer = Performer(slow_eyes)
    layered = Performer(slow_eyes)
    layered.set_layer("breath", influence=0.5)
    for each in (performer, layered):
        each.set_gaze(yaw, pitch)
    frame = performer.advance(DT)
    other = layered.advance(DT)
    assert channels_of(slow_eyes.expressions, other) == channels_of(slow_eyes.expressions, frame)
    check_playable(slow_eyes, other)


@given(yaws, pitches)
@settings(max_examples=20)
def test_a_show_whose_eyes_look_far_is_restored(slow_eyes: Cast, yaw: float, pitch: float) -> None:
    performer = Performer(slow_eyes)
    last(played(slow_eyes, performer, 1.0, lambda _: performer.drive(FULL, gaze=(yaw, pitch))))
    assert Performer.restored(slow_eyes, performer.snapshot()).snapshot() == performer.snapshot()
    performer.panic()
    assert Performer.restored(slow_eyes, performer.snapshot()).advance(0.1) == performer.advance(0.1)


def test_eyes_that_another_cast_turns_farther_stay_in_its_range(cast: Cast, slow_eyes: Cast) -> None:
    performer = Performer(slow_eyes)
    last(played(slow_eyes, performer, 1.0, lambda _: performer.drive(FULL, gaze=(GAZE_LIMITS["yaw"], 0.0))))
    performer.recast(cast)
    performer.advance(DT)
    assert Performer.restored(cast, performer.snapshot()).snapshot() == performer.snapshot()


@given(shows)
@settings(max_examples=20)
def test_without_a_source_and_a_changed_layer_there_are_none(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    for command in show:
        command.play(performer)
        frame = performer.advance(command.wait)
        assert (frame.layers, frame.held, performer.snapshot().layers) == ({}, None, None)
        assert channels_of(cast.expressions, frame) == effective_channels(cast.expressions, frame.channels, frame.gaze)


def test_a_source_that_has_gone_leaves_a_performer_as_one_without(cast: Cast) -> None:
    performer = Performer(cast)
    other = Performer(cast)
    for each in (performer, other):
        each.call_expression("smile", seconds=0.0)
        each.set_channel("jawOpen", 0.25)
    last(played(cast, performer, 2.0, lambda _: performer.drive(FULL, layer="tracker", head=(0.2, 0, 0))))
    performer.leave_layer("tracker", "")
    frame = last(played(cast, performer, 8.0))
    assert replace(frame, time=0.0) == other.advance(0.0)
    assert performer.snapshot().layers is None


def test_a_tracker_takes_the_face_over_and_neutral_takes_the_rest(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0)
    frame = last(played(cast, performer, 6.0, lambda _: performer.drive({"jawOpen": 0.5}, layer="tracker")))
    assert frame.expressions == {"neutral": pytest.approx(1.0)} or frame.expressions["neutral"] > 0.999
    assert frame.channels["jawOpen"] == pytest.approx(0.5, abs=1e-3)


def test_overlap_averages_and_never_doubles(cast: Cast) -> None:
    performer = Performer(cast)

    def both(_: int) -> None:
        performer.drive({"jawOpen": 0.6}, layer="tracker")
        performer.drive({"jawOpen": 0.6}, layer="playback")

    performer.set_layer("playback", influence=0.5)
    assert last(played(cast, performer, 6.0, both)).channels["jawOpen"] == pytest.approx(0.6, abs=1e-3)


def test_silence_lets_a_source_go_and_its_return_brings_it_back_without_a_jump(cast: Cast) -> None:
    performer = Performer(cast)
    shown = [f.channels.get("jawOpen", 0.0) for f in played(cast, performer, 3.0, lambda _: performer.drive(FULL))]
    assert shown[-1] == pytest.approx(0.8, abs=0.01)
    lost = list(played(cast, performer, 0.4))
    assert lost[-1].layers["playback"].trust == pytest.approx(1.0, abs=0.01), "half a second is waited for"
    gone = last(played(cast, performer, 3.0))
    assert gone.layers["playback"].trust < 0.01
    back = list(played(cast, performer, 3.0, lambda _: performer.drive(FULL)))
    shown += [f.channels.get("jawOpen", 0.0) for f in (*lost, gone)]
    assert back[-1].channels["jawOpen"] == pytest.approx(0.8, abs=0.01)
    assert np.abs(np.diff([f.channels.get("jawOpen", 0.0) for f in back])).max() < 0.03


def test_a_source_that_does_not_see_its_performer_is_one_that_is_silent(cast: Cast) -> None:
    silent = Performer(cast)
    blind = Performer(cast)
    for each in (silent, blind):
        last(played(cast, each, 2.0, lambda _, each=each: each.drive(FULL)))  # type: ignore[misc]
    frames = played(cast, blind, 2.0, lambda _: blind.drive({"jawOpen": 1.5, "smile": 0.0}, found=False))
    assert [plain(f) for f in frames] == [plain(f) for f in played(cast, silent, 2.0)]


def test_a_recalibrated_source_lets_go_before_it_is_followed_again(cast: Cast) -> None:
    performer = Performer(cast)
    last(played(cast, performer, 3.0, lambda _: performer.drive({"jawOpen": 0.8})))
    performer.recalibrate_layer("playback", "")
    frames = list(played(cast, performer, 4.0, lambda _: performer.drive({"jawOpen": 0.2})))
    trust = [frame.layers["playback"].trust for frame in frames]
    assert min(trust) < 0.02
    assert trust[-1] > 0.9
    shown = np.array([frame.channels.get("jawOpen", 0.0) for frame in frames])
    assert shown.min() < 0.01, "it lets go of the old measure before it shows the new one"
    assert np.abs(np.diff(shown, 2)).max() < 0.01


def test_a_hand_holds_a_channel_over_a_source_and_lets_it_go(cast: Cast) -> None:
    performer = Performer(cast)
    last(played(cast, performer, 3.0, lambda _: performer.drive(FULL)))
    performer.set_channel("jawOpen", 0.1)
    held = last(played(cast, performer, 3.0, lambda _: performer.drive(FULL)))
    assert held.channels["jawOpen"] == pytest.approx(0.1, abs=1e-3)
    assert held.channels["smile"] == pytest.approx(0.4, abs=1e-3)
    assert held.held == Held({"jawOpen": 0.1})
    performer.set_channel("jawOpen", 0.0)
    free = last(played(cast, performer, 3.0, lambda _: performer.drive(FULL)))
    assert free.channels["jawOpen"] == pytest.approx(0.8, abs=1e-3)


def test_a_head_and_a_gaze_are_followed_and_left_alone_by_a_source_without(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_head(0.3, 0.0, 0.0)
    frame = last(played(cast, performer, 3.0, lambda _: performer.drive({"jawOpen": 0.5}, gaze=(0.2, -0.1))))
    assert frame.head.yaw == 0.3
    assert [frame.gaze.yaw, frame.gaze.pitch] == pytest.approx([0.2, -0.1], abs=1e-3)
    turned = last(played(cast, performer, 3.0, lambda _: performer.drive({"jawOpen": 0.5}, head=(-0.5, 0.1, 0.0))))
    assert turned.head.yaw == pytest.approx(0.3, abs=1e-3), "a hand holds it"
    performer.set_head(0.0, 0.0, 0.0)
    turned = last(played(cast, performer, 3.0, lambda _: performer.drive({"jawOpen": 0.5}, head=(-0.5, 0.1, 0.0))))
    assert turned.head.yaw == pytest.approx(-0.5, abs=1e-3)


def test_breath_adds_a_little_and_what_is_more_is_refused(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_channel("jawOpen", 0.0)
    frame = last(played(cast, performer, 3.0, lambda _: performer.drive({"jawOpen": 0.04}, layer="breath")))
    assert frame.channels["jawOpen"] == pytest.approx(0.04, abs=1e-3)
    with pytest.raises(ValueError, match=r"jawOpen of the layer breath is 0.4; give a number from -0.05 to 0.05"):
        performer.drive({"jawOpen": 0.4}, layer="breath")
    with pytest.raises(ValueError, match=r"the layer blink closes what is open; it takes no head and no gaze"):
        performer.drive({"jawOpen": 0.4}, layer="blink", head=(0.1, 0.0, 0.0))


def test_a_blink_closes_what_is_still_open(cast: Cast) -> None:
    def blinked(breath: float) -> float:
        performer = Performer(cast)

        def drive(_: int) -> None:
            performer.drive({"smile": breath}, layer="breath")
            performer.drive({"smile": 1.0}, layer="blink")

        return last(played(cast, performer, 3.0, drive)).channels["smile"]

    assert blinked(0.0) == pytest.approx(1.0, abs=1e-3)
    assert blinked(0.05) == pytest.approx(1.0, abs=1e-3), "one closed lid, not more"


def test_a_panic_takes_sources_off_and_in_a_quarter_of_a_second_all_is_still(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0)
    performer.set_channel("jawOpen", 0.2)
    before = last(
        played(cast, performer, 1.0, lambda _: performer.drive({"browInnerUp": 1.0}, head=(0.4, 0, 0), layer="tracker"))
    )
    performer.panic()
    frames = list(
        played(cast, performer, 0.5, lambda _: performer.drive({"browInnerUp": 1.0}, head=(0.4, 0, 0), layer="tracker"))
    )
    assert abs(frames[0].head.yaw - before.head.yaw) < 0.06
    assert abs(frames[0].expressions.get("smile", 0.0) - before.expressions["smile"]) < 0.2
    for frame in frames[16:]:
        assert (frame.channels, frame.head.yaw, dict(frame.expressions)) == ({}, 0.0, {"neutral": 1.0})
        assert not frame.layers["tracker"].on
    performer.set_layer("tracker", on=True)
    again = last(
        played(cast, performer, 4.0, lambda _: performer.drive({"browInnerUp": 1.0}, head=(0.4, 0, 0), layer="tracker"))
    )
    assert again.head.yaw == pytest.approx(0.4, abs=1e-3)


names = st.sampled_from(["smile", "jawOpen", "browInnerUp"])
drives = st.builds(
    lambda layer, values, head, gaze: ("drive", values, {"layer": layer, "head": head, "gaze": gaze}),
    st.sampled_from(["tracker", "lips", "playback", "gaze"]),
    st.dictionaries(names, st.floats(-0.5, 1.5), max_size=3),
    st.none() | st.tuples(*[st.floats(-1.5, 1.5)] * 3),
    st.none() | st.tuples(st.floats(-0.69, 0.69), st.floats(-0.52, 0.52)),
)
sets = st.builds(
    lambda layer, region, influence, on: ("set_layer", layer, {"region": region, "influence": influence, "on": on}),
    st.sampled_from(LAYERS),
    st.none() | st.sampled_from(LAYER_PARTS),
    st.none() | st.floats(0.0, 1.0),
    st.none() | st.booleans(),
)
hands = st.builds(lambda name, value: ("set_channel", name, {"value": value}), names, st.floats(-0.5, 1.5))
blinks = st.builds(lambda value: ("drive", {"browInnerUp": value}, {"layer": "blink"}), st.floats(0.0, 1.0))
deeds = st.lists(st.tuples(st.one_of(drives, drives, blinks, sets, hands), st.floats(0.0, 0.5)), max_size=25)


@given(deeds, st.lists(commands, max_size=25))
@settings(max_examples=20)
def test_whatever_is_driven_set_and_called_stays_in_range_and_sums_to_one(
    cast: Cast, show: list[tuple[tuple[str, Any, dict[str, Any]], float]], calls: list[Command]
) -> None:
    performer = Performer(cast)
    for ((name, first, options), wait), command in zip(show, [*calls, *[Command("panic")] * 25], strict=False):
        getattr(performer, name)(first, **options)
        command.play(performer)
        frame = performer.advance(wait)
        assert all(CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST for value in frame.channels.values())
        for region in PLAY_REGIONS:
            assert sum(mix_in(region, frame.expressions, frame.regions).values()) == pytest.approx(1.0, abs=1e-9)
        for limits, turned in ((HEAD_LIMITS, frame.head), (GAZE_LIMITS, frame.gaze)):
            assert all(abs(getattr(turned, name)) <= limit for name, limit in limits.items())


@given(deeds)
@settings(max_examples=20)
def test_the_same_deeds_give_the_same_bits_and_a_snapshot_goes_on(
    cast: Cast, show: list[tuple[tuple[str, Any, dict[str, Any]], float]]
) -> None:
    performer = Performer(cast)
    again = Performer(cast)
    for (name, first, options), wait in show:
        for each in (performer, again):
            getattr(each, name)(first, **options)
        again = Performer.restored(cast, again.snapshot())
        assert performer.advance(wait) == again.advance(wait)
    assert performer.snapshot() == again.snapshot()


def test_a_cast_that_lacks_what_a_source_sends_is_refused_and_another_goes_on(cast: Cast) -> None:
    performer = Performer(cast)
    other = Performer(cast)
    for each in (performer, other):
        last(played(cast, each, 0.5, lambda _, each=each: each.drive(FULL)))  # type: ignore[misc]
    performer.recast(cast.with_expressions(beam=cast.expressions["smile"]))
    assert performer.advance(DT) == other.advance(DT)
    few = replace(cast, expressions={name: e for name, e in cast.expressions.items() if name != "jawOpen"}, titles={})
    with pytest.raises(ValueError, match=r"there is no channel 'jawOpen' in this cast"):
        performer.recast(few)
    assert performer.advance(DT) == other.advance(DT)


@given(st.lists(st.sampled_from([0.0, 0.2, 0.8]), min_size=2, max_size=6), st.sampled_from([0.5, 1.0, 2.0]))
@settings(max_examples=5)
def test_a_source_that_is_smoothed_moves_slower_never_farther_and_arrives(
    cast: Cast, steps: list[float], smoothing: float
) -> None:
    plain = Performer(cast)
    smooth = Performer(cast)
    ways = [0.0, 0.0]
    for goal in [*[0.0] * 6, *steps, *[steps[-1]] * 20]:
        for _ in range(30):
            shown = []
            for place, (performer, seconds) in enumerate([(plain, 0.0), (smooth, smoothing)]):
                before = performer.advance(0.0).channels.get("jawOpen", 0.0)
                performer.drive({"jawOpen": goal}, smoothing=seconds)
                shown.append(performer.advance(DT).channels.get("jawOpen", 0.0))
                ways[place] = max(ways[place], abs(shown[-1] - before))
            assert -1e-9 <= min(shown) <= max(shown) <= 0.8 + 1e-9
    assert shown[1] == pytest.approx(shown[0], abs=1e-3)
    assert ways[1] <= ways[0] + 1e-9


def test_a_smoothed_source_goes_nine_tenths_of_a_step_in_its_seconds(cast: Cast) -> None:
    performer = Performer(cast)
    last(played(cast, performer, 2.0, lambda _: performer.drive({"jawOpen": 0.0}, smoothing=1.0)))
    frame = last(played(cast, performer, 1.0, lambda _: performer.drive({"jawOpen": 0.8}, smoothing=1.0)))
    assert 0.85 <= frame.channels["jawOpen"] / 0.8 <= 0.97
    with pytest.raises(ValueError, match=r"the smoothing of a source \(seconds\) is 3.0; give a number from 0 to 2"):
        performer.drive({"jawOpen": 0.8}, smoothing=3.0)


@pytest.mark.parametrize(("layer", "least"), [("lips", (0.9, 0.85)), ("tracker", (0.8, 0.65))])
def test_speech_arrives(cast: Cast, layer: str, least: tuple[float, float]) -> None:
    """Mouths that open and close four and six times a second; the layer of lips shows seven tenths of them."""
    titled = replace(cast, titles={**cast.titles, "jawOpen": Title("jaw", region="jaw")})
    for hertz, share in zip((4.0, 6.0), least, strict=True):
        performer = Performer(titled)
        performer.set_layer(layer, influence=1.0)

        def speak(n: int, performer: Performer = performer, hertz: float = hertz) -> None:
            opened = 0.4 + 0.3 * math.sin(math.tau * hertz * n * DT)
            performer.drive({"jawOpen": opened}, layer=layer)

        shown = [f.channels.get("jawOpen", 0.0) for f in played(titled, performer, 4.0, speak)][120:]
        assert max(shown) - min(shown) > share * 0.6


@given(st.floats(0.01, 0.5), st.floats(1.0, 4.0))
@settings(max_examples=5)
def test_calmer_is_slower_and_livelier_is_sooner(cast: Cast, smoothing: float, ratio: float) -> None:
    ways = []
    for seconds in (smoothing, ratio * smoothing):
        performer = Performer(cast)
        last(played(cast, performer, 1.0, lambda _, p=performer, s=seconds: p.drive({"jawOpen": 0.2}, smoothing=s)))  # type: ignore[misc]
        frames = played(cast, performer, 0.1, lambda _, p=performer, s=seconds: p.drive({"jawOpen": 0.4}, smoothing=s))  # type: ignore[misc]
        ways.append(last(frames).channels["jawOpen"])
    assert ways[1] <= ways[0] + 1e-9


def test_what_comes_back_elsewhere_after_a_gap_is_no_jump(cast: Cast) -> None:
    performer = Performer(cast)
    before = list(played(cast, performer, 2.0, lambda _: performer.drive({"jawOpen": 0.0}, layer="lips")))
    before += played(cast, performer, 0.3)
    back = before + list(played(cast, performer, 1.0, lambda _: performer.drive({"jawOpen": 1.0}, layer="lips")))
    shown = [frame.channels.get("jawOpen", 0.0) for frame in back]
    assert np.abs(np.diff(shown, 2)).max() < 0.08


HEAD_STEP = math.radians(20.0)
"""By how much a head's speed may change in a tick, radians a second: what a turn of 30 degrees, once a second, does."""


@pytest.mark.parametrize("rate", [10, 20, 60])
@pytest.mark.parametrize("gap", [0.3, 0.45, 0.6, 0.8, 1.0, 1.4, 3.0])
def test_a_head_that_comes_back_elsewhere_is_followed_slowly(cast: Cast, gap: float, rate: int) -> None:
    performer = Performer(cast)
    every = round(1.0 / rate / DT)
    yaws = list[float]()

    def see(seconds: float, yaw: float) -> None:
        for n in range(round(seconds / DT)):
            if n % every == 0:
                performer.drive({"jawOpen": 0.0}, head=(yaw, 0.0, 0.0))
            yaws.append(performer.advance(DT).head.yaw)

    see(4.0, 0.0)
    yaws += [frame.head.yaw for frame in played(cast, performer, gap)]
    see(3.0, math.radians(29.0))
    speeds = np.diff(yaws) / DT
    assert np.abs(np.diff(speeds)).max() < HEAD_STEP
    assert yaws[-60] == pytest.approx(math.radians(29.0), rel=0.02), "two seconds later it is there"


@given(st.floats(0.02, 0.45), st.floats(-0.5, 1.5), st.floats(-0.5, 1.5))
@settings(max_examples=10)
def test_what_is_lost_and_seen_elsewhere_comes_back_without_a_jump_of_speed(
    cast: Cast, gap: float, before: float, after: float
) -> None:
    performer = Performer(cast)
    last(played(cast, performer, 1.5, lambda _: performer.drive({"jawOpen": before})))
    performer.drive({"jawOpen": 0.0}, found=False)
    shown = [frame.channels.get("jawOpen", 0.0) for frame in played(cast, performer, gap)]
    back = played(cast, performer, 2.0, lambda _: performer.drive({"jawOpen": after}))
    shown += [frame.channels.get("jawOpen", 0.0) for frame in back]
    assert np.abs(np.diff(shown, 2)).max() < 1.25 * BACK_ACCELERATION * DT * DT
    assert shown[-1] == pytest.approx(after, abs=1e-3)


def test_a_source_that_falls_silent_on_its_way_back_goes_on_without_a_jump_of_speed(cast: Cast) -> None:
    """Behind a gap of 80 ms the follower's rate fell in one step, and the speed of what was far behind with it."""
    performer = Performer(cast)
    step = 1.0 / 240.0

    def play(seconds: float, value: float | None = None) -> list[float]:
        shown = []
        for _ in range(round(seconds / step)):
            if value is not None:
                performer.drive({"jawOpen": value}, layer="tracker")
            shown.append(performer.advance(step).channels.get("jawOpen", 0.0))
        return shown

    play(1.5, 0.0)
    performer.drive({"jawOpen": 0.0}, layer="tracker", found=False)
    shown = [*play(0.02), *play(0.12, 0.9), *play(0.3)]
    assert np.abs(np.diff(shown, 2)).max() < 1.25 * BACK_ACCELERATION * step * step


@given(st.floats(0.02, 1.0), st.floats(0.0, 1.0))
@settings(max_examples=5)
def test_a_hand_takes_a_channel_from_a_source_without_a_jump_of_speed(cast: Cast, source: float, hand: float) -> None:
    performer = Performer(cast)
    play = partial(performer.drive, {"jawOpen": source})
    before = [frame.channels["jawOpen"] for frame in played(cast, performer, 1.5, lambda _: play())]
    performer.set_channel("jawOpen", hand)
    shown = before[-3:] + [
        frame.channels.get("jawOpen", 0.0) for frame in played(cast, performer, 1.0, lambda _: play())
    ]
    assert np.abs(np.diff(shown, 2)).max() < 33.0 * abs(source - hand) * DT * DT + 1e-6


def test_who_is_lost_for_a_frame_and_seen_where_it_was_is_followed_as_ever(cast: Cast) -> None:
    ways = []
    for is_lost in (False, True):
        performer = Performer(cast)
        last(played(cast, performer, 1.0, lambda _, p=performer: p.drive({"jawOpen": 0.2})))  # type: ignore[misc]
        if is_lost:
            performer.drive({}, found=False)
        last(played(cast, performer, DT, lambda _, p=performer: p.drive({"jawOpen": 0.2})))  # type: ignore[misc]
        again = played(cast, performer, 0.2, lambda n, p=performer: p.drive({"jawOpen": 0.2 + 0.03 * n}))  # type: ignore[misc]
        ways.append([frame.channels["jawOpen"] for frame in again])
    assert ways[0] == ways[1]


def test_who_is_seen_elsewhere_comes_back_after_a_snapshot_as_without_one(cast: Cast) -> None:
    performer = Performer(cast)
    last(played(cast, performer, 1.0, lambda _: performer.drive({"jawOpen": 0.1}, head=(0.2, 0.0, 0.0))))
    last(played(cast, performer, 0.3))
    last(played(cast, performer, 0.2, lambda _: performer.drive({"jawOpen": 0.8}, head=(-0.2, 0.0, 0.0))))
    other = Performer.restored(cast, performer.snapshot())
    assert list(played(cast, performer, 1.0)) == list(played(cast, other, 1.0))


def test_a_head_that_plays_on_is_followed_as_ever(cast: Cast) -> None:
    performer = Performer(cast)
    for n in range(120):
        if n % 6 == 0:
            performer.drive({}, head=(0.0, 0.0, 0.0))
        performer.advance(DT)
    shown = []
    for n in range(30):
        if n % 6 == 0:  # ten frames a second are no gap
            performer.drive({}, head=(0.4, 0.0, 0.0))
        shown.append(performer.advance(DT).head.yaw)
    assert shown[8] > 0.85 * 0.4


def test_a_hand_is_immediate_where_nothing_plays(cast: Cast) -> None:
    layers = hold_by(cast, begin(cast, Held()), Held({"jawOpen": 0.5}))
    place = layers.columns.index["jawOpen"]
    assert layers.columns.rows(layers.second, "hands")[place] == 0.5
    assert layers.columns.rows(layers.second, "hold")[place] == 1.0
    assert are_hands_still(layers)


def test_what_is_let_go_keeps_its_value(cast: Cast) -> None:
    layers = hold_by(cast, begin(cast, Held({"jawOpen": 0.5})), Held())
    place = layers.columns.index["jawOpen"]
    assert layers.columns.rows(layers.goal, "hold")[place] == 0.0
    assert layers.columns.rows(layers.goal, "hands")[place] == 0.5


def frames(step: int) -> dict[LayerName, SourceFrame]:
    """What a character's own motion sends at a step."""
    way = 0.01 * (step % 50)
    return {
        "breath": SourceFrame(("jawOpen",), np.array([way / 20]), Head(way, 0.0, 0.0), source="own", direct=True),
        "gaze": SourceFrame((), np.zeros(0), Head(way, -way, 0.0), Gaze(way, -way), source="own", direct=True),
        "blink": SourceFrame(("smile",), np.array([way]), source="own", direct=True),
    }


def same(one: Layers, other: Layers) -> bool:
    """Whether two characters' layers are the same in all that follows."""
    vectors = zip((one.goal, one.first, one.second), (other.goal, other.first, other.second), strict=True)
    return all(np.array_equal(*each) for each in vectors) and (one.drivers, one.owners) == (other.drivers, other.owners)


@given(st.lists(st.sampled_from(["send", "send", "send", "rest", "leave"]), min_size=5, max_size=40))
@settings(max_examples=25, deadline=None)
def test_at_once_is_one_after_the_other(cast: Cast, events: list[str]) -> None:
    one = other = begin(cast, Held())
    for step, event in enumerate(events):
        if event == "send":
            one = drive_direct(cast, one, frames(step))
            for layer, frame in frames(step).items():
                other = drive(cast, other, layer, frame)
        if event == "leave":
            one = leave(one, "gaze", "own")
            other = leave(other, "gaze", "own")
        dt = 1.0 if event == "rest" else 1 / 60
        one, other = (advance(cast, each, Held(), dt, still=True) for each in (one, other))
        assert same(one, other)
