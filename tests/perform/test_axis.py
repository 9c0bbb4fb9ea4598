"""One axis: calls, interruptions and the T-bar, in weights and their rates."""

import itertools
import math
from dataclasses import replace
from typing import Any

import msgspec
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.axis import (
    Axis,
    advanced,
    called,
    called_to_mix,
    faded,
    goal_of,
    halted,
    rates,
    released,
    slots,
    standing_mix,
    status,
    weights,
    with_pace,
)
from omote.perform.easing import EASINGS
from omote.perform.frame import Frame
from omote.perform.mix import HIGHEST, LOWEST
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot
from tests.conftest import Command, calls, regional_calls

NAMES = "abcd"
times = st.one_of(st.none(), st.floats(0.05, 4.0))
easings = st.sampled_from(sorted(EASINGS))
call_moves = st.tuples(st.just("call"), st.sampled_from(NAMES), times, easings, st.floats(0.0, 1.5))
fade_moves = st.tuples(st.just("fade"), st.floats(0.0, 1.0), st.none(), st.none(), st.floats(0.0, 0.5))
release_moves = st.tuples(st.just("release"), st.none(), st.none(), st.none(), st.floats(0.0, 0.5))
pace_moves = st.tuples(st.just("pace"), st.floats(0.0, 1.0), st.none(), st.none(), st.floats(0.0, 0.5))
histories = st.lists(st.one_of(call_moves, call_moves, fade_moves, release_moves, pace_moves), max_size=25)
Move = tuple[str, str | float | None, float | None, str | None, float]


def moved(axis: Axis, move: Move) -> Axis:
    """The axis right after a move, before its time passes."""
    kind, what, seconds, easing, _ = move
    if kind == "call":
        return called(axis, str(what), seconds, str(easing))
    if kind == "pace":
        return with_pace(axis, float(what or 0.0))
    return faded(axis, float(what or 0.0)) if kind == "fade" else released(axis)


def after(history: list[Move]) -> Axis:
    axis = Axis("a")
    for move in history:
        axis = advanced(moved(axis, move), move[-1])
    return axis


@given(histories)
def test_weights_always_sum_to_one_rates_to_nothing_and_none_leaves_the_range(history: list[Move]) -> None:
    axis = Axis("a")
    for move in history:
        axis = moved(axis, move)
        for _ in range(6):
            axis = advanced(axis, move[-1] / 6)
            mix = weights(axis)
            assert math.fsum(mix.values()) == pytest.approx(1.0, abs=1e-9)
            assert math.fsum(rates(axis).values()) == pytest.approx(0.0, abs=1e-7)
            assert min(mix.values()) >= LOWEST - 1e-9
            assert max(mix.values()) <= HIGHEST + 1e-9
            assert all(mix.values())


@given(histories, st.one_of(call_moves, fade_moves, release_moves))
def test_no_command_moves_a_weight_or_changes_its_rate(history: list[Move], move: Move) -> None:
    axis = after(history)
    following = moved(axis, move)
    assert weights(following) == pytest.approx(weights(axis), abs=1e-9)
    if slots(following).velocity == 0.0 and following.call is not None and following.call.decay == 0.0:
        assume(not any(rates(axis).values()) or move[0] != "call")  # no room at all is left for a velocity
    assert {**dict.fromkeys(NAMES, 0.0), **rates(following)} == pytest.approx(
        {**dict.fromkeys(NAMES, 0.0), **rates(axis)}, abs=1e-6, rel=1e-6
    )


@given(histories, call_moves, st.floats(0.0, 1.0))
def test_a_call_at_any_pace_takes_the_speed_over(history: list[Move], move: Move, pace: float) -> None:
    """A cue that is called while cues are paused stopped at once what moved."""
    axis = after(history)
    following = with_pace(moved(axis, move), pace)
    if following.call is not None and following.call.decay > 0.0:  # else there was no speed, or there is no room for it
        names = dict.fromkeys(NAMES, 0.0)
        assert {**names, **rates(following)} == pytest.approx({**names, **rates(axis)}, abs=1e-6, rel=1e-6)


@given(histories, st.floats(0.01, 1.0))
def test_rates_are_the_derivative_of_the_weights(history: list[Move], wait: float) -> None:
    axis = advanced(after(history), wait)
    step = 1e-6
    before = weights(axis)
    later = weights(advanced(axis, step))
    assume(axis.call is not None and axis.call.decay in (0.0, min(0.33, axis.call.seconds or 0.33)))
    for name in NAMES:
        slope = (later.get(name, 0.0) - before.get(name, 0.0)) / step
        assert slope == pytest.approx(rates(axis).get(name, 0.0), abs=2e-2)


@given(histories, st.floats(0.0, 10.0), st.integers(2, 40))
def test_one_long_step_lands_where_many_short_ones_do(history: list[Move], wait: float, count: int) -> None:
    axis = after(history)
    stepped = axis
    for _ in range(count):
        stepped = advanced(stepped, wait / count)
    names = dict.fromkeys(NAMES, 0.0)
    assert {**names, **weights(stepped)} == pytest.approx({**names, **weights(advanced(axis, wait))}, abs=1e-9)


@pytest.mark.parametrize("easing", EASINGS)
def test_a_call_from_rest_follows_its_easing_and_ends_exactly(easing: str) -> None:
    axis = called(Axis("a"), "b", 2.0, easing)
    for share in (0.0, 0.25, 0.5, 0.9):
        expected = EASINGS[easing].value(share)
        assert weights(advanced(axis, 2.0 * share)).get("b", 0.0) == pytest.approx(expected, abs=1e-12)
    assert advanced(axis, 2.0) == Axis("b")


def test_calling_what_is_alone_on_air_changes_nothing() -> None:
    for seconds in (0.0, 1.0, None):
        assert called(Axis("a", hand=0.4), "a", seconds, "smooth") == Axis("a", hand=0.4)


def test_no_time_is_a_cut() -> None:
    running = advanced(called(Axis("a"), "b", 1.0, "smooth"), 0.5)
    assert called(running, "c", 0.0, "smooth") == Axis("c")


def test_calling_back_the_start_turns_the_move_around_without_a_kick() -> None:
    axis = called(advanced(called(Axis("a"), "b", 1.0, "smooth"), 0.5), "a", 1.0, "smooth")
    assert weights(advanced(axis, 0.05))["b"] > 0.5
    assert advanced(axis, 1.0) == Axis("a")


# --- the T-bar --------------------------------------------------------------------------------------------------------


def settled(axis: Axis) -> Axis:
    return advanced(axis, 0.5)


def test_a_call_by_hand_waits_and_follows_the_hand_exactly() -> None:
    axis = called(Axis("a"), "b", None, "smooth")
    assert weights(advanced(axis, 100.0)) == {"a": 1.0}
    for hand in (0.3, 0.8, 0.1):
        axis = settled(faded(axis, hand))
        assert weights(axis)["b"] == hand
    assert advanced(released(axis), 60.0).call is not None
    assert settled(faded(axis, 1.0)) == Axis("b", hand=1.0)


def test_a_step_of_the_hand_is_smoothed_and_never_overshoots() -> None:
    axis = faded(called(Axis("a"), "b", None, "smooth"), 0.5)
    ways = [weights(advanced(axis, 0.001 * step)).get("b", 0.0) for step in range(100)]
    assert ways[0] == 0.0
    assert ways == sorted(ways)
    assert ways[-1] == 0.5
    assert max(abs(b - a) for a, b in itertools.pairwise(ways)) < 0.02


def test_the_hand_takes_a_running_call_over_only_once_it_has_passed_it() -> None:
    running = advanced(called(Axis("a"), "b", 2.0, "smooth"), 1.0)
    short = faded(running, 0.4)
    shown = status(short)
    assert shown is not None
    assert not shown.by_hand
    assert weights(advanced(short, 0.2)) == weights(advanced(running, 0.2))
    passed = settled(faded(short, 0.7))
    assert weights(passed)["b"] == 0.7


def test_a_hand_that_rests_is_not_picked_up_by_the_call_that_passes_it() -> None:
    running = advanced(replace(called(Axis("a"), "b", 2.0, "smooth"), hand=0.3), 1.5)
    nudged = faded(running, 0.31)
    assert weights(advanced(nudged, 0.1)) == weights(advanced(running, 0.1))


def test_the_ends_flip_after_a_completed_call() -> None:
    done = settled(faded(called(Axis("a"), "b", None, "smooth"), 1.0))
    back = called(done, "a", None, "smooth")
    assert weights(settled(faded(back, 0.75)))["a"] == 0.25
    assert settled(faded(back, 0.0)) == Axis("a", hand=0.0, flipped=True)


def test_where_the_hand_takes_over_is_shown() -> None:
    back = called(Axis("b", hand=1.0), "a", None, "smooth")
    shown = status(settled(faded(back, 0.75)))
    assert shown is not None
    assert (shown.fader, shown.pickup, shown.progress, shown.by_hand) == (0.75, 0.75, 0.25, True)


def test_a_released_timed_call_goes_on_over_the_remaining_share_of_its_time() -> None:
    held = settled(faded(called(Axis("a"), "b", 2.0, "smooth"), 0.25))
    free = released(held)
    shown = status(free)
    assert shown is not None
    assert shown.remaining == pytest.approx(1.5)
    assert not shown.by_hand
    assert advanced(free, 1.4).call is not None
    assert advanced(free, 1.5) == Axis("b", hand=0.25)


def test_letting_go_of_nothing_changes_nothing() -> None:
    for axis in (Axis("a"), called(Axis("a"), "b", 1.0, "smooth")):
        assert released(axis) == axis


def test_a_slam_of_the_t_bar_after_an_interruption_stays_in_range() -> None:
    fast = advanced(called(Axis("a"), "b", 0.2, "smooth"), 0.1)
    axis = faded(called(fast, "b", 1.0, "smooth"), 1.0)
    tops = [weights(advanced(axis, 0.002 * step)).get("b", 0.0) for step in range(200)]
    assert max(tops) <= HIGHEST + 1e-9


@given(histories, st.floats(0.05, 0.5))
def test_an_axis_comes_to_a_stand_without_a_jump_and_no_t_bar_moves_it(history: list[Move], seconds: float) -> None:
    axis = after(history)
    halting = halted(axis, seconds)
    assert weights(halting) == pytest.approx(weights(axis), abs=1e-9)
    assert (halting.hand, status(halting)) == (0.0, None)
    assert faded(halting, 0.9).call == halting.call
    assert halted(halting, seconds) == halting
    still = advanced(halting, seconds)
    assert still.call is None
    assert weights(still) == pytest.approx(weights(advanced(still, 100.0)), abs=0.0)
    assert all(0.0 < weight <= 1.0 for weight in weights(still).values())
    assert called(still, "b", 0.0, "smooth") == replace(still, on_air="b", stands=None)


timed_calls = st.one_of(calls, regional_calls).filter(lambda each: each.seconds != math.inf)


def shown(frame: Frame, region: PlayRegion) -> dict[str, float]:
    return dict(frame.regions.get(region, frame.expressions))


@given(st.lists(timed_calls, max_size=12))
def test_a_region_plays_as_a_whole_face_that_is_called_likewise(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    alone = {region: Performer(cast) for region in PLAY_REGIONS}
    whole = Performer(cast)
    for command in show:
        command.play(performer)
        for region, other in alone.items():
            if command.region in (None, region):
                replace(command, region=None).play(other)
        if command.region is None:
            command.play(whole)
        frame = performer.advance(command.wait)
        rest = whole.advance(command.wait)
        assert (frame.expressions, frame.faces, frame.expression_call) == (
            rest.expressions, rest.faces, rest.expression_call,
        )  # fmt: skip
        for region, other in alone.items():
            assert shown(frame, region) == dict(other.advance(command.wait).expressions)


@given(st.lists(timed_calls, max_size=8), regional_calls)
def test_a_call_of_the_whole_face_brings_its_regions_together(cast: Cast, show: list[Command], last: Command) -> None:
    performer = Performer(cast)
    for command in [*show, last]:
        command.play(performer)
        performer.advance(command.wait)
    performer.call_expression("smile", seconds=0.5)
    frame = performer.advance(10.0)
    assert (frame.expressions, frame.regions, frame.region_calls) == ({"smile": 1.0}, {}, {})
    assert performer.snapshot().regions == {}


def test_a_region_that_comes_to_show_what_the_face_does_goes_with_it(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=1.0, region="mouth")
    assert performer.advance(0.4).region_calls["mouth"].remaining == pytest.approx(0.6)
    assert shown(performer.advance(1.0), "mouth") == {"smile": 1.0}
    assert performer.advance(0.0).region_calls == {}
    performer.call_expression("neutral", seconds=1.0, region="mouth")
    assert performer.advance(1.0).regions == {}


def test_the_t_bar_moves_regions_that_were_called_with_the_face_and_passes_others_by(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0, region="mouth")
    performer.call_expression("jawOpen", seconds=math.inf)
    performer.call_expression("browInnerUp", seconds=2.0, region="brows")
    performer.fade_expression(0.5)
    frame = performer.advance(1.0)
    assert frame.expressions == pytest.approx({"neutral": 0.5, "jawOpen": 0.5})
    assert shown(frame, "mouth") == pytest.approx({"smile": 0.5, "jawOpen": 0.5})
    assert frame.region_calls["brows"].by_hand is False
    assert frame.region_calls["brows"].remaining == pytest.approx(1.0)
    performer.fade_expression(1.0)
    frame = performer.advance(1.0)
    assert shown(frame, "mouth") == shown(frame, "rest") == {"jawOpen": 1.0}
    assert shown(frame, "brows") == {"browInnerUp": 1.0}


def test_a_bar_left_at_its_far_end_begins_the_next_call_of_all_regions_there(cast: Cast) -> None:
    """Its end is the start of a call for regions too, whichever end it was when they were called alone."""
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0, region="mouth")
    performer.fade_expression(1.0)
    performer.call_expression("jawOpen", seconds=math.inf)
    performer.fade_expression(0.5)
    frame = performer.advance(1.0)
    assert shown(frame, "mouth") == pytest.approx({"smile": 0.5, "jawOpen": 0.5})
    assert shown(frame, "rest") == pytest.approx({"neutral": 0.5, "jawOpen": 0.5})


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"region": "nose"}, "there is no region 'nose' to play in; expected one of brows, eyes, mouth, rest"),
        ({"region": "mouth", "seconds": math.inf}, "the time of a call"),
        ({"region": "mouth", "easing": "jumpy"}, "jumpy"),
    ],
    ids=["no region", "by hand", "no easing"],
)
def test_a_call_in_a_region_that_cannot_be_is_refused_and_changes_nothing(
    cast: Cast, options: dict[str, Any], said: str
) -> None:
    performer = Performer(cast)
    before = performer.snapshot()
    with pytest.raises(ValueError, match=said):
        performer.call_expression("smile", **options)
    assert performer.snapshot() == before


def test_a_snapshot_of_a_region_that_is_none_is_refused(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", region="mouth")
    plain = msgspec.to_builtins(performer.snapshot())
    plain["regions"]["mouth"]["on_air"] = "nobody"
    with pytest.raises(ValueError, match="nobody"):
        Performer.restored(cast, msgspec.convert(plain, Snapshot))
    strange: Any = {"tail": performer.snapshot().expression}
    with pytest.raises(ValueError, match="no region 'tail'"):
        Performer.restored(cast, replace(performer.snapshot(), regions=strange))


def test_a_mix_that_shows_is_kept_without_what_is_less_than_nothing() -> None:
    assert standing_mix({"a": 1.05, "b": -0.05}) == {"a": 1.0}
    assert sum(standing_mix({"a": 0.5, "b": 0.6, "c": -0.1}).values()) == pytest.approx(1.0)


@given(st.floats(0.0, 5.0), st.floats(0.05, 3.0), st.sampled_from([{"b": 1.0}, {"a": 0.25, "b": 0.75}]))
def test_an_axis_comes_to_the_goal_that_it_is_called_to(begun: float, seconds: float, goal: dict[str, float]) -> None:
    on = called_to_mix(called(Axis("a"), "c", begun, "smooth"), goal, seconds, "smooth")
    assert goal_of(on) == goal
    cut = called_to_mix(on, goal, 0.0, "smooth")
    assert weights(cut) == goal_of(cut) == goal
