"""A performer whose macros play several targets: of hands, without a jump, and the same after a snapshot."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import pytest

from omote.model.cast import Cast
from omote.perform.channels import channels_of
from omote.perform.frame import Frame
from omote.perform.mappings.mapping import HalfBelow, MacroCondition, MacroMapping, MacroTarget
from omote.perform.performer import Performer

TICK = 1 / 60
SOFT = MacroTarget("channel/jawOpen", high=0.8, rise=0.1, fall=0.3)


@pytest.fixture(name="performer")
def _performer(cast: Cast) -> Performer:
    return Performer(cast)


def jaw_of(frame: Frame) -> float:
    return frame.channels.get("jawOpen", 0.0)


def play(performer: Performer, ticks: int) -> list[Frame]:
    return [performer.advance(TICK) for _ in range(ticks)]


def largest_step(values: list[float]) -> float:
    return max(abs(after - before) for before, after in pairwise(values))


def test_one_number_plays_channels_head_and_gaze_each_by_its_curve(performer: Performer) -> None:
    targets = [
        MacroTarget("channel/jawOpen", low=0.1, high=0.5, curve=((0.0, 0.0), (0.5, 1.0), (1.0, 0.0))),
        MacroTarget("head/yaw", high=0.4, below=HalfBelow(-0.2)),
        MacroTarget("gaze/pitch", high=-0.3),
    ]
    performer.set_mapping(MacroMapping("all", tuple(targets)))
    performer.move_macro("all", 0.5)
    frame = performer.advance(1.0)
    assert (jaw_of(frame), frame.head.yaw, frame.gaze.pitch) == (0.5, 0.2, -0.15)
    performer.move_macro("all", -1.0)
    frame = performer.advance(1.0)
    assert (jaw_of(frame), frame.head.yaw, frame.gaze.pitch) == (0.1, -0.2, 0.0)


def test_faders_and_macros_are_added_and_faders_show_what_faders_hold(performer: Performer) -> None:
    performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen"),)))
    performer.set_channel("jawOpen", 0.25)
    performer.move_macro("mouth", 0.25)
    frame = performer.advance(0.0)
    assert jaw_of(frame) == 0.5
    assert frame.held is not None
    assert frame.held.channels == {"jawOpen": 0.25}
    performer.set_channel("jawOpen", 1.0)
    assert jaw_of(performer.advance(0.0)) == 1.0


def test_a_gaze_that_a_macro_turns_turns_the_eyes(performer: Performer, cast: Cast) -> None:
    performer.set_mapping(MacroMapping("look", (MacroTarget("gaze/yaw", high=0.3),)))
    performer.move_macro("look", 1.0)
    by_macro = performer.advance(0.0)
    other = Performer(cast)
    other.set_gaze(0.3, 0.0)
    turned = channels_of(cast.expressions, other.advance(0.0))
    assert dict(by_macro.channels) == turned


def test_a_step_rises_and_falls_in_its_own_time(performer: Performer) -> None:
    performer.set_mapping(MacroMapping("mouth", (SOFT,)))
    performer.move_macro("mouth", 1.0)
    assert jaw_of(performer.advance(0.1)) == pytest.approx(0.9 * 0.8, abs=0.02)
    performer.advance(2.0)
    performer.move_macro("mouth", 0.0)
    assert jaw_of(performer.advance(0.3)) == pytest.approx(0.1 * 0.8, abs=0.02)
    assert performer.advance(3.0).channels == {}


def test_a_condition_fades_and_does_not_chatter(performer: Performer) -> None:
    performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen"),), MacroCondition("macro/on", 0.5)))
    performer.set_mapping(MacroMapping("on", (MacroTarget("channel/browInnerUp"),)))
    performer.move_macro("mouth", 0.5)
    assert jaw_of(performer.advance(1.0)) == 0.0
    performer.move_macro("on", 0.51)
    shown = [jaw_of(frame) for frame in play(performer, 60)]
    assert shown[-1] == 0.5
    assert largest_step([0.0, *shown]) < 0.1
    for trembling in (0.49, 0.51, 0.47) * 10:
        performer.move_macro("on", trembling)
        assert jaw_of(performer.advance(TICK)) == 0.5
    performer.move_macro("on", 0.4)
    assert jaw_of(play(performer, 120)[-1]) == 0.0


@pytest.mark.parametrize("reads", ["channel/browInnerUp", "expression/smile"])
def test_a_condition_reads_what_hands_and_calls_hold(performer: Performer, reads: str) -> None:
    when = MacroCondition(reads, 0.5, above=False)
    performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen"),), when))
    performer.move_macro("mouth", 0.5)
    assert jaw_of(performer.advance(0.0)) == 0.5
    performer.set_channel("browInnerUp", 0.8)
    performer.call_expression("smile", seconds=0.0)
    performer.advance(TICK)
    assert jaw_of(performer.advance(3.0)) == 0.0


def test_changes_on_air_go_on_from_what_shows(performer: Performer) -> None:
    performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen", high=0.6),)))
    performer.move_macro("mouth", 1.0)
    values = [jaw_of(performer.advance(TICK))]
    changes: list[Callable[[], None]] = [
        lambda: performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen", high=0.2),))),
        lambda: performer.rename_mapping("mouth", "jaw"),
        lambda: performer.drop_mapping("jaw"),
        lambda: performer.restore_mapping("jaw"),
        lambda: performer.set_mappings([]),
    ]
    for change in changes:
        change()
        values += [jaw_of(performer.advance(0.0)), *(jaw_of(frame) for frame in play(performer, 30))]
    assert largest_step(values) < 0.1
    assert values[-1] == pytest.approx(0.0, abs=1e-3)


def test_a_renamed_macro_is_found_by_conditions(performer: Performer) -> None:
    performer.set_mapping(MacroMapping("on", (MacroTarget("channel/browInnerUp"),)))
    performer.set_mapping(MacroMapping("mouth", (SOFT,), MacroCondition("macro/on", 0.5)))
    performer.rename_mapping("on", "switch")
    when = performer.mappings["mouth"].when
    assert when is not None
    assert when.reads == "macro/switch"
    assert list(performer.mappings) == ["switch", "mouth"]
    performer.restore_mapping("on")
    assert list(performer.mappings) == ["on", "mouth"]


def test_a_panic_takes_macros_to_rest_until_they_are_moved_again(performer: Performer) -> None:
    performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen", low=0.2, high=0.6),)))
    performer.move_macro("mouth", 1.0)
    before = jaw_of(performer.advance(2.0))
    performer.panic()
    shown = [before, *(jaw_of(frame) for frame in play(performer, 18))]
    assert before == 0.6
    assert shown[-1] == 0.0
    assert largest_step(shown) < 0.12
    assert performer.advance(0.0).macros["mouth"].value == 0.0
    performer.move_macro("mouth", 0.0)
    shown = [jaw_of(frame) for frame in play(performer, 60)]
    assert shown[-1] == 0.2
    assert largest_step([0.0, *shown]) < 0.05


def test_a_snapshot_goes_on_bit_for_bit(performer: Performer, cast: Cast) -> None:
    performer.set_mapping(MacroMapping("mouth", (SOFT,), MacroCondition("macro/on", 0.5)))
    performer.set_mapping(MacroMapping("on", (MacroTarget("head/roll", high=0.3, rise=0.2),)))
    performer.move_macro("mouth", 0.7)
    performer.move_macro("on", 0.9)
    play(performer, 5)
    performer.drop_mapping("mouth")
    second = Performer.restored(cast, performer.snapshot())
    assert play(performer, 40) == play(second, 40)
    assert performer.snapshot() == second.snapshot()


def test_a_channel_that_another_cast_has_not_gives_nothing(performer: Performer, cast: Cast) -> None:
    beaming = cast.with_expressions(beam=cast.expressions["smile"])
    performer.recast(beaming)
    performer.set_mapping(MacroMapping("beam", (MacroTarget("channel/beam"), MacroTarget("channel/jawOpen"))))
    performer.recast(cast)
    performer.move_macro("beam", 0.5)
    assert dict(performer.advance(0.0).channels) == {"jawOpen": 0.5}


def test_what_there_is_not_is_refused(performer: Performer) -> None:
    with pytest.raises(ValueError, match="channel"):
        performer.set_mapping(MacroMapping("mouth", (MacroTarget("channel/jaw0pen"),)))
    with pytest.raises(ValueError, match="there is no macro 'mouth' of this character"):
        performer.move_macro("mouth", 0.5)
    performer.set_mapping(MacroMapping("mouth", (SOFT,)))
    with pytest.raises(ValueError, match="-1 to 1"):
        performer.move_macro("mouth", 1.5)
    performer.set_mapping(MacroMapping("eyes", (SOFT,)))
    with pytest.raises(ValueError, match="already"):
        performer.rename_mapping("mouth", "Eyes")
    for number in range(62):
        performer.set_mapping(MacroMapping(f"m{number}", (SOFT,)))
    with pytest.raises(ValueError, match="64"):
        performer.set_mapping(MacroMapping("one-more", (SOFT,)))
