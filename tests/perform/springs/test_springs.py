"""The springs of a character: amounts that are followed, panics, and snapshots that no show wrote."""

from __future__ import annotations

from dataclasses import replace

import pytest

from omote.perform.frame import Frame, Head
from omote.perform.springs.cast_springs import SPRINGS
from omote.perform.springs.spring import SpringState
from omote.perform.springs.springs import (
    AT_HOME,
    AT_REST,
    Springs,
    Travel,
    advance_springs,
    amount_of,
    check_springs,
    release_springs,
    set_amount,
)

STILL = Frame({"generic": 1.0}, {"neutral": 1.0})


def after(
    springs: Springs, *, frame: Frame = STILL, travel: Travel = AT_HOME, scale: float = 1.0, ticks: int = 60
) -> Springs:
    for _ in range(ticks):
        springs = advance_springs(springs, SPRINGS, frame, travel, scale, 1 / 60)
    return springs


def test_amounts_are_followed_within_half_a_second_and_forgotten_where_none_is_left() -> None:
    half = after(set_amount(AT_REST, "ears-flap", 0.0), ticks=15)
    assert set(half.moving) == {*SPRINGS} - {"ears-flap"}
    assert 0.1 < half.moving["ears-sway"].second < 0.9
    whole = after(half, ticks=120)
    assert {state.second for state in whole.moving.values()} == {1.0}
    assert after(whole, scale=0.0, ticks=240).moving == {}


def test_only_what_is_not_as_at_first_is_kept() -> None:
    once = set_amount(set_amount(AT_REST, "jowls-sway", 2.0), "ears-sway", 0.5)
    assert [*once.amounts] == ["ears-sway", "jowls-sway"]
    assert [amount_of(each, "jowls-sway") for each in (once, AT_REST, None)] == [2.0, 1.0, 1.0]
    assert set_amount(set_amount(once, "jowls-sway", 1.0), "ears-sway", 1.0) == AT_REST


@pytest.mark.parametrize(
    ("frame", "travel", "moved"),
    [
        (replace(STILL, head=Head(yaw=0.02)), AT_HOME, {"ears-sway", "jowls-sway"}),
        (replace(STILL, head=Head(pitch=0.02)), AT_HOME, {"ears-flap", "cheeks-bounce"}),
        (replace(STILL, head=Head(roll=0.02)), AT_HOME, {"ears-sway", "jowls-sway"}),
        (replace(STILL, channels={"jawOpen": 0.3}), AT_HOME, {"cheeks-bounce"}),
        (STILL, Travel(x=0.02), {"ears-sway", "jowls-sway"}),
        (STILL, Travel(turn=0.02), {"ears-sway", "jowls-sway"}),
    ],
)
def test_each_spring_is_driven_by_its_drivers_alone(frame: Frame, travel: Travel, moved: set[str]) -> None:
    begun = after(AT_REST)
    kicked = after(begun, frame=frame, travel=travel, ticks=1)
    assert {name for name, state in kicked.moving.items() if state.turn} == moved


def test_a_panic_brings_them_to_rest_in_its_time() -> None:
    swinging = after(after(AT_REST), frame=replace(STILL, head=Head(yaw=0.05)), ticks=1)
    released = release_springs(swinging)
    assert released is not None
    assert release_springs(released) is released
    later = after(released, ticks=14)
    assert later.released == pytest.approx(14 / 60)
    assert after(later, ticks=1) == replace(later, moving={}, released=None)
    assert release_springs(None) is None
    assert release_springs(AT_REST) is AT_REST


@pytest.mark.parametrize(
    "wrong",
    [
        Springs(amounts={"tail": 1.0}),  # type: ignore[dict-item]
        Springs(amounts={"ears-sway": 3.0}),
        Springs(moving={"tail": SpringState()}),  # type: ignore[dict-item]
        Springs(moving={"ears-sway": SpringState(turn=float("nan"))}),
        Springs(moving={"ears-sway": SpringState(speed=1e9)}),
        Springs(moving={"ears-sway": SpringState(driver=1e9)}),
        Springs(moving={"ears-sway": SpringState(driver_speed=13.0)}),
        Springs(moving={"ears-sway": SpringState(second=5.0)}),
        Springs(released=1.0),
    ],
)
def test_a_snapshot_that_no_show_wrote_is_refused(wrong: Springs) -> None:
    with pytest.raises(ValueError, match="spring"):
        check_springs(wrong)
