"""The performer as its callers see it: commands, frames, refusals, panic, snapshots."""

import math
from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.perform.frame import Frame, Gaze, Head, Home
from omote.perform.panic import PANIC_SECONDS, SAME_PRESS
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot
from tests.conftest import Command, commands, shows


def played(cast: Cast, show: list[Command]) -> Performer:
    performer = Performer(cast)
    for command in show:
        command.play(performer)
        performer.advance(command.wait)
    return performer


def mix_in(region: PlayRegion, frame: Frame) -> Mapping[str, float]:
    return frame.regions.get(region, frame.expressions)


def test_a_new_performer_shows_the_generic_face_at_rest(cast: Cast) -> None:
    assert Performer(cast).advance(0.0) == Frame({"generic": 1.0}, {"neutral": 1.0})


@given(shows)
def test_mixes_sum_to_one_and_channels_stand_beside_them(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    for command in show:
        command.play(performer)
        frame = performer.advance(command.wait)
        for mix in (frame.faces, frame.expressions, frame.light, *frame.regions.values()):
            assert math.fsum(mix.values()) == pytest.approx(1.0, abs=1e-9)
            assert all(-0.1 - 1e-9 <= weight <= 1.1 + 1e-9 for weight in mix.values())
    assert frame_time(show) == pytest.approx(performer.advance(0.0).time)


def frame_time(show: list[Command]) -> float:
    return math.fsum(command.wait for command in show)


@given(shows, st.lists(commands, max_size=8))
def test_a_restored_performer_plays_on_frame_by_frame_the_same(
    cast: Cast, before: list[Command], later: list[Command]
) -> None:
    original = played(cast, before)
    written = msgspec.msgpack.encode(original.snapshot())
    restored = Performer.restored(cast, msgspec.msgpack.decode(written, type=Snapshot))
    assert restored.snapshot() == original.snapshot()
    for command in [Command("release_face", wait=0.01), *later]:
        command.play(original)
        command.play(restored)
        assert restored.advance(command.wait) == original.advance(command.wait)


@given(shows, st.floats(0.0, 10.0))
def test_a_long_step_lands_where_short_ones_do(cast: Cast, show: list[Command], wait: float) -> None:
    performer = played(cast, show)
    stepped = Performer.restored(cast, performer.snapshot())
    for _ in range(20):
        small = stepped.advance(wait / 20)
    large = performer.advance(wait)
    for short, long in ((small.faces, large.faces), (small.expressions, large.expressions)):
        assert {**dict.fromkeys(long, 0.0), **short} == pytest.approx({**dict.fromkeys(short, 0.0), **long}, abs=1e-9)


def test_faces_and_expressions_move_independently(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_face("broad", seconds=2)
    performer.call_expression("smile", seconds=1)
    frame = performer.advance(1.0)
    assert frame.faces == pytest.approx({"generic": 0.5, "broad": 0.5})
    assert frame.expressions == {"smile": 1.0}
    assert frame.expression_call is None
    assert frame.face_call is not None
    assert (frame.face_call.target, frame.face_call.remaining) == ("broad", 1.0)


def test_a_light_changes_beside_the_face_and_from_what_shows(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_light("portrait", seconds=2.0)
    between = performer.advance(1.0)
    assert between.light["portrait"] == pytest.approx(0.5)
    assert between.faces == {"generic": 1.0}
    assert between.light_call is not None
    assert between.light_call.target == "portrait"
    performer.call_light("flat", seconds=1.0)
    assert performer.advance(0.0).light == pytest.approx(between.light)
    assert performer.advance(2.0).light == {"flat": 1.0}


@pytest.mark.parametrize("seconds", [math.nan, -1.0, math.inf, 1e9])
def test_a_light_waits_for_no_hand(cast: Cast, seconds: float) -> None:
    performer = Performer(cast)
    with pytest.raises(ValueError, match=r"the time of a call \(seconds\) is"):
        performer.call_light("flat", seconds=seconds)
    with pytest.raises(ValueError, match="there is no light 'candle'; choose one of theatre"):
        performer.call_light("candle")
    assert performer.snapshot() == Performer(cast).snapshot()


def test_panic_keeps_the_light(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_light("flat", seconds=2.0)
    before = performer.advance(1.0)
    performer.panic()
    assert performer.advance(0.0).light == before.light
    assert performer.advance(2.0).light == {"flat": 1.0}


def test_a_call_for_ever_waits_for_the_t_bar(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=math.inf)
    assert performer.advance(1000.0).expressions == {"neutral": 1.0}
    performer.fade_expression(0.5)
    frame = performer.advance(1.0)
    assert frame.expressions == {"neutral": 0.5, "smile": 0.5}
    assert frame.expression_fader == 0.5
    assert frame.expression_call is not None
    assert (frame.expression_call.by_hand, frame.expression_call.remaining) == (True, None)


def test_channels_head_and_gaze_are_shown_exactly_and_at_once(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_channel("jawOpen", 0.37)
    performer.set_channel("smile", -0.5)
    performer.set_head(0.1, -0.2, 0.3)
    performer.set_gaze(0.4, 0.5)
    frame = performer.advance(0.0)
    assert frame.channels == {"jawOpen": 0.37, "smile": -0.5}
    assert (frame.head, frame.gaze) == (Head(0.1, -0.2, 0.3), Gaze(0.4, 0.5))
    performer.set_channel("jawOpen", 0)
    assert performer.advance(0.0).channels == {"smile": -0.5}


@given(shows)
def test_after_panic_the_face_is_neutral_and_nothing_moves_until_somebody_plays(
    cast: Cast, show: list[Command]
) -> None:
    performer = played(cast, show)
    performer.panic()
    frame = performer.advance(PANIC_SECONDS)
    assert (frame.expressions, frame.regions, frame.region_calls) == ({"neutral": 1.0}, {}, {})
    assert (frame.channels, frame.head, frame.gaze) == ({}, Head(), Gaze())
    assert (frame.face_call, frame.expression_call, frame.face_fader, frame.expression_fader) == (None, None, 0.0, 0.0)
    later = performer.advance(100.0)
    assert (later.faces, later.expressions, later.channels) == (frame.faces, frame.expressions, {})
    assert math.fsum(later.faces.values()) == pytest.approx(1.0)
    assert all(0.0 < weight <= 1.0 for weight in later.faces.values())


@given(shows)
def test_panic_does_not_pop(cast: Cast, show: list[Command]) -> None:
    performer = played(cast, show)
    before = performer.advance(0.0)
    performer.panic()
    steps = [before, *(performer.advance(PANIC_SECONDS / 1000) for _ in range(1000))]
    for one, other in pairwise(steps):
        for mix, following in (
            (one.faces, other.faces),
            (one.expressions, other.expressions),
            (one.channels, other.channels),
            *((mix_in(each, one), mix_in(each, other)) for each in PLAY_REGIONS),
        ):
            moved = [abs(following.get(name, 0.0) - mix.get(name, 0.0)) for name in {*mix, *following}]
            assert max(moved, default=0.0) < 0.02
    assert steps[1].faces == pytest.approx(before.faces, abs=0.02)


def test_panic_stops_a_call_of_a_face_half_way_without_turning_back(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_face("broad", seconds=2.0)
    at_press = performer.advance(1.0).faces["broad"]
    performer.panic()
    way = [performer.advance(0.01).faces["broad"] for _ in range(40)]
    assert performer.advance(0.0).face_call is None
    assert all(one <= other for one, other in pairwise([at_press, *way]))
    assert at_press < way[-1] < at_press + 0.2
    assert way[-1] == way[-2]
    performer.call_face("generic", seconds=0.5)
    start = performer.advance(0.0).face_call
    assert start is not None
    assert start.start == pytest.approx({"broad": way[-1], "generic": 1 - way[-1]})
    assert performer.advance(0.5).faces == {"generic": 1.0}


def test_a_hand_is_free_at_once_after_panic(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_channel("jawOpen", 1.0)
    performer.set_head(0.5, 0.0, 0.0)
    performer.set_gaze(0.3, 0.0)
    performer.panic()
    half = performer.advance(PANIC_SECONDS / 2)
    assert 0.0 < half.channels["jawOpen"] < 0.5
    assert 0.0 < half.head.yaw < 0.25
    performer.set_channel("jawOpen", 0.7)
    performer.set_head(0.1, 0.0, 0.0)
    frame = performer.advance(0.01)
    assert (frame.channels["jawOpen"], frame.head.yaw) == (0.7, 0.1)
    assert 0.0 < frame.gaze.yaw < 0.15


def test_a_second_panic_brings_the_home_face_in_its_time(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_home("long", seconds=3.0)
    performer.call_face("broad", seconds=2.0)
    performer.advance(1.0)
    performer.panic()
    assert not performer.advance(0.1).home_next
    performer.panic()  # hammering is one press
    standing = performer.advance(SAME_PRESS)
    assert (standing.home_next, standing.face_call, standing.panics) == (True, None, 2)
    performer.panic()
    frame = performer.advance(1.5)
    assert frame.face_call is not None
    assert frame.face_call.remaining == pytest.approx(1.5)
    assert (frame.face_call.target, frame.home_next) == ("long", False)
    performer.panic()  # a third one does not stop it
    assert performer.advance(1.5).faces == {"long": 1.0}
    assert not performer.advance(10.0).home_next


@pytest.mark.parametrize(
    "play",
    [
        Command("call_expression", ("smile",)),
        Command("fade_face", (0.5,)),
        Command("set_channel", ("jawOpen", 0.1)),
        Command("set_gaze", (0.1, 0.0)),
    ],
    ids=lambda play: play.name,
)
def test_whoever_plays_after_panic_makes_the_next_one_a_first(cast: Cast, play: Command) -> None:
    performer = Performer(cast)
    performer.call_face("broad", seconds=0)
    performer.panic()
    assert performer.advance(1.0).home_next
    play.play(performer)
    assert not performer.advance(1.0).home_next
    performer.panic()
    assert performer.advance(1.0).faces == {"broad": 1.0}


def test_the_home_face_is_chosen_and_kept(cast: Cast) -> None:
    performer = Performer(cast)
    with pytest.raises(ValueError, match="no face 'brod' in this cast; near are broad"):
        performer.set_home("brod")
    for seconds in (math.nan, -1.0, math.inf, 1e9):
        with pytest.raises(ValueError, match=r"the time to the home face \(seconds\) is"):
            performer.set_home("broad", seconds=seconds)
    performer.set_home("broad", seconds=0)
    assert Performer.restored(cast, performer.snapshot()).advance(0.0).home == Home("broad", 0.0)
    with pytest.raises(ValueError, match="there is no face 'broad'"):
        performer.recast(Cast(cast.space, {"generic": cast.faces["generic"]}, cast.expressions))
    performer.panic()
    performer.advance(1.0)
    performer.panic()
    assert performer.advance(0.0).faces == {"broad": 1.0}


BAD_NUMBERS = [math.nan, -math.inf, -1.0, 1e300]


@pytest.mark.parametrize("number", BAD_NUMBERS)
@pytest.mark.parametrize(
    ("command", "before", "after"),
    [
        ("fade_face", (), ()), ("fade_expression", (), ()), ("set_channel", ("jawOpen",), ()), ("advance", (), ()),
        ("set_head", (), (0.0, 0.0)), ("set_head", (0.0,), (0.0,)), ("set_head", (0.0, 0.0), ()),
        ("set_gaze", (), (0.0,)), ("set_gaze", (0.0,), ()),
    ],
)  # fmt: skip
def test_numbers_out_of_range_are_refused_and_change_nothing(
    cast: Cast, command: str, before: tuple[Any, ...], after: tuple[Any, ...], number: float
) -> None:
    performer = Performer(cast)
    shown = performer.snapshot()
    bad = number * 2 if command.startswith("set_") else number  # -1 rad is a fine direction
    with pytest.raises(ValueError, match="give a number from"):
        getattr(performer, command)(*before, bad, *after)
    assert performer.snapshot() == shown


@pytest.mark.parametrize("seconds", [math.nan, -1.0, -math.inf, 1e9])
def test_a_call_in_no_time_at_all_is_refused(cast: Cast, seconds: float) -> None:
    performer = Performer(cast)
    for call, name in ((performer.call_face, "broad"), (performer.call_expression, "smile")):
        with pytest.raises(ValueError, match=r"the time of a call \(seconds\) is"):
            call(name, seconds=seconds)
    assert performer.snapshot() == Performer(cast).snapshot()


def test_unknown_names_and_easings_are_refused_with_what_there_is(cast: Cast) -> None:
    performer = Performer(cast)
    with pytest.raises(ValueError, match="no face 'brod' in this cast; near are broad"):
        performer.call_face("brod")
    with pytest.raises(ValueError, match="no expression 'smil' in this cast; near are smile"):
        performer.call_expression("smil")
    with pytest.raises(ValueError, match="no channel 'neutral'"):
        performer.set_channel("neutral", 0.5)
    with pytest.raises(ValueError, match="no easing 'linear'; choose one of smooth"):
        performer.call_face("broad", easing="linear")


def test_a_cast_without_the_generic_face_cannot_be_played(cast: Cast) -> None:
    headless = Cast(cast.space, {"broad": cast.faces["broad"]}, cast.expressions)
    with pytest.raises(ValueError, match="there is no face 'generic' in this cast"):
        Performer(headless)


def test_a_panic_in_a_gesture_counts_it_once(cast: Cast) -> None:
    """Where a layer played, what was found had the nod in it, and the nod went on beside: the head fell by 13 degrees
    in no time."""
    performer = Performer(cast)
    performer.set_motion(0.5)
    performer.advance(1.0)
    performer.gesture("nod")
    before = performer.advance(0.25).head
    performer.panic()
    assert performer.advance(0.0).head == before


@pytest.mark.parametrize("speed", [3.0, 12.0, 90.0, -90.0])
def test_a_panic_stops_a_head_and_a_gaze_however_fast_they_are(cast: Cast, speed: float) -> None:
    """A gaze that moved faster than its range is wide once made the panic itself fail."""
    times = [tick / 240 for tick in range(241)]
    swings = [0.3 * math.sin(speed * time / 0.3) for time in times]
    head, gaze = [(swing, 0.0, 0.0) for swing in swings], [(swing, 0.0) for swing in swings]
    curve = make_curve(times, {}, {}, head=head, gaze=gaze)
    performer = Performer(cast)
    performer.play_clip(Clip([Lane(curve)]), seconds=0)
    before = [performer.advance(1 / 240) for _ in range(50)][-1]
    performer.panic()
    at = performer.advance(0.0)
    assert (at.head, at.gaze.yaw) == (before.head, before.gaze.yaw)
    for _ in range(60):
        performer.advance(1 / 240)
    assert performer.advance(0.0).head == Head()


def test_a_panic_stops_what_cannot_go_on(cast: Cast, monkeypatch: pytest.MonkeyPatch) -> None:
    performer = Performer(cast)
    performer.set_motion(1.0)
    performer.set_channel("jawOpen", 0.5)
    performer.advance(1.0)

    def fail(*_: object) -> None:
        raise ArithmeticError

    monkeypatch.setattr(performer, "_find_sight", fail)
    with pytest.raises(ArithmeticError):
        performer.advance(0.1)
    performer.panic()
    monkeypatch.undo()
    assert performer.advance(1.0).channels == {}
