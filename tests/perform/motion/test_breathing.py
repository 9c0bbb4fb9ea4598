"""Breath and noise."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.perform.motion.breathing import Breath, advance_breath, air, noise
from omote.perform.motion.quantiles import BREATH

SEEDS = st.integers(0, 2**31 - 1)


@given(SEEDS)
def test_breaths_follow_each_other_without_a_jump(seed: int) -> None:
    breath = Breath()
    drawn = []
    for step in range(3000):
        breath = advance_breath(breath, seed, step / 60)
        drawn.append(air(breath, step / 60))
        assert BREATH.values[0] <= breath.seconds <= BREATH.values[-1]
    assert np.abs(np.diff(drawn)).max() < 0.03
    assert min(drawn) == 0.0
    assert 0.99 < max(drawn) <= 1.0


@given(SEEDS, st.floats(0.0, 1e9))
def test_any_gap_ends_in_a_breath_that_is_drawn(seed: int, now: float) -> None:
    breath = advance_breath(Breath(), seed, now)
    assert breath.began <= now <= breath.began + breath.seconds + 1e-6


@given(SEEDS, st.integers(0, 6), st.floats(0.0, 1e5))
def test_noise_is_smooth_and_stays_in_range(seed: int, kind: int, begin: float) -> None:
    values = np.array([noise(seed, kind, begin + step / 60) for step in range(120)])
    assert np.abs(values).max() <= 1.0
    assert np.abs(np.diff(values)).max() < 0.05
    assert np.abs(np.diff(values, 2)).max() < 0.01


@given(SEEDS)
@settings(max_examples=20)
def test_noise_does_not_repeat(seed: int) -> None:
    """An hour is like no other hour."""
    first, *others = ([noise(seed, 0, begin + step * 3.7) for step in range(1000)] for begin in (0.0, 3600.0, 7310.0))
    assert all(abs(np.corrcoef(first, each)[0, 1]) < 0.25 for each in others)
