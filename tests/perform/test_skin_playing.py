"""Blood, tears and sweat on air: they follow expressions in seconds, go with a panic, and play again to the bit."""

from __future__ import annotations

import dataclasses

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_cast
from omote.model.space.complexion import PALE, Complexion
from omote.perform.complexion import FALLS, RISES
from omote.perform.frame import Frame
from omote.perform.performer import Performer

TICK = 1 / 60


def played(performer: Performer, seconds: float) -> Frame:
    frame = performer.advance(TICK)
    for _ in range(round(seconds / TICK) - 1):
        frame = performer.advance(TICK)
    return frame


def crying() -> Performer:
    performer = Performer(load_cast())
    performer.call_expression("cry", seconds=0)
    return performer


def test_a_face_at_rest_has_none_and_keeps_no_state_of_it() -> None:
    performer = Performer(load_cast())
    performer.call_expression("doubt", seconds=0)
    frame = played(performer, 1.0)
    assert (frame.complexion, frame.folds, frame.drops, dict(frame.skin)) == (PALE, 1.0, 0.0, {})
    assert performer.snapshot().skin is None


def test_blood_comes_in_seconds_and_goes_more_slowly() -> None:
    performer = crying()
    goal = load_cast().expressions["cry"].complexion
    assert performer.advance(0.0).complexion == PALE
    assert 0.05 < played(performer, 0.5).complexion.nose / goal.nose < 0.5
    risen = played(performer, RISES.nose - 0.5).complexion
    assert risen.nose == pytest.approx(0.9 * goal.nose, rel=0.03)
    assert played(performer, 20.0).complexion == goal
    performer.call_expression("neutral", seconds=0)
    left = played(performer, RISES.nose).complexion
    assert left.nose > 0.3 * goal.nose
    assert played(performer, FALLS.nose - RISES.nose).complexion.nose == pytest.approx(0.1 * goal.nose, abs=0.01)
    assert played(performer, 40.0).complexion == PALE
    assert performer.snapshot().skin is None


def test_tears_run_while_there_are_any_and_begin_anew() -> None:
    performer = crying()
    first = played(performer, 4.0)
    later = played(performer, 2.0)
    assert 0.0 < first.drops < later.drops
    performer.call_expression("neutral", seconds=0)
    assert played(performer, 60.0).drops == 0.0


def test_a_panic_takes_all_of_it_in_its_quarter_of_a_second() -> None:
    performer = crying()
    played(performer, 10.0)
    performer.panic()
    frame = performer.advance(0.125)
    assert 0.1 < frame.complexion.tears < 0.4
    assert played(performer, 0.15).complexion == PALE
    assert performer.snapshot().skin is None
    performer.call_expression("cry", seconds=0)
    assert 0.0 < played(performer, 0.3).complexion.nose < 0.3


def test_the_fader_of_blood_takes_colour_alone_and_that_of_folds_is_followed() -> None:
    performer = crying()
    performer.set_skin("blood", 0.0)
    performer.set_skin("folds", 0.5)
    assert 0.5 < performer.advance(TICK).folds < 1.0
    frame = played(performer, 30.0)
    assert frame.complexion == Complexion(tears=1.0)
    assert (frame.folds, dict(frame.skin)) == (0.5, {"folds": 0.5, "blood": 0.0})
    performer.set_skin("blood", 1.0)
    performer.set_skin("folds", 1.0)
    assert dict(played(performer, 1.0).skin) == {}


@given(st.lists(st.sampled_from(["cry", "angry", "fear", "joy", "neutral"]), min_size=1, max_size=4))
def test_a_restored_performer_goes_on_to_the_bit(called: list[str]) -> None:
    performer = Performer(load_cast())
    for name in called:
        performer.call_expression(name, seconds=0.3)
        played(performer, 0.7)
    other = Performer.restored(load_cast(), performer.snapshot())
    assert played(performer, 1.0) == played(other, 1.0)


def test_long_steps_and_short_ones_agree_while_nothing_is_called() -> None:
    short = crying()
    long = crying()
    assert tuple(played(short, 12.0).complexion) == pytest.approx(tuple(long.advance(12.0).complexion), abs=2e-3)


def test_own_expressions_have_theirs() -> None:
    cast = load_cast()
    blush = dataclasses.replace(cast.expressions["smile"], complexion=Complexion(cheeks=1.0), name="")
    performer = Performer(cast.with_expressions(blush=blush))
    performer.call_expression("blush", seconds=0)
    assert played(performer, 20.0).complexion == Complexion(cheeks=1.0)


def test_sweat_breaks_out_in_half_a_minute_and_dries_in_a_minute() -> None:
    performer = Performer(load_cast())
    performer.call_expression("fear", seconds=0)
    goal = load_cast().expressions["fear"].complexion.sweat
    assert played(performer, 3.0).complexion.sweat < 0.2 * goal
    risen = played(performer, RISES.sweat - 3.0)
    assert risen.complexion.sweat == pytest.approx(0.9 * goal, rel=0.03)
    assert played(performer, 5.0).drops > risen.drops > 0.0
    performer.call_expression("neutral", seconds=0)
    assert played(performer, FALLS.whole).complexion.sweat > 0.8 * goal  # longer than the pallor
    assert played(performer, FALLS.sweat - FALLS.whole).complexion.sweat == pytest.approx(0.1 * goal, abs=0.02)
    assert performer.advance(200.0).complexion == PALE
