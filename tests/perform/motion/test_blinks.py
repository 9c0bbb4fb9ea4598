"""Blinks: their shape, their order, and what draws them."""

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion.blinks import Blinks, advance_blinks, begin_blink, is_blinking, lid_closure
from omote.perform.motion.quantiles import BLINK_DOWN, BLINK_UP

SEEDS = st.integers(0, 2**31 - 1)


@given(SEEDS)
def test_a_blink_closes_and_opens_without_a_jump_in_its_time(seed: int) -> None:
    blink = begin_blink(Blinks(), seed, 1.0)
    assert BLINK_DOWN.values[0] <= blink.down <= BLINK_DOWN.values[-1]
    assert BLINK_UP.values[0] <= blink.up <= BLINK_UP.values[-1]
    curve = [lid_closure(blink, 1.0 + step / 1000) for step in range(500)]
    assert curve[0] == curve[-1] == 0.0
    assert max(curve) <= blink.depth <= 1.0
    assert max(abs(later - before) for before, later in pairwise(curve)) < 0.03
    top = curve.index(max(curve))
    assert curve[:top] == sorted(curve[:top])
    assert curve[top:] == sorted(curve[top:], reverse=True)


@given(SEEDS, st.floats(0.0, 0.3))
def test_no_blink_begins_within_another(seed: int, after: float) -> None:
    blink = begin_blink(Blinks(), seed, 1.0)
    again = begin_blink(blink, seed, 1.0 + after, whole=True)
    assert again == blink if is_blinking(blink, 1.0 + after) else again.count == blink.count + 1


@given(SEEDS)
def test_a_rate_of_nothing_never_blinks_and_a_higher_one_blinks_oftener(seed: int) -> None:
    def count(rate: float) -> int:
        blinks = Blinks()
        for step in range(6000):
            blinks = advance_blinks(blinks, seed, step / 50, 0.02, rate=rate, speaking=False)
        return blinks.count

    assert count(0.0) == 0
    assert count(0.5) < count(2.0)


def test_the_end_of_speech_draws_blinks() -> None:
    drawn = 0
    for seed in range(200):
        spoken = advance_blinks(Blinks(), seed, 1.0, 0.02, rate=1.0, speaking=True)
        drawn += advance_blinks(spoken, seed, 1.02, 0.02, rate=1.0, speaking=False).count
    assert 70 < drawn < 150
