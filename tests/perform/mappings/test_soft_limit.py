"""The sum of sources: exact up to the knee, within the limit above it, without a kink and in any order."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.mappings import soft_limit

RANGE = (-0.5, 1.0)
INSIDE = st.floats(-0.49, 0.99)
TINY = 1e-6


def soft_sum(values: list[float], lowest: float, highest: float) -> float:
    return float(soft_limit.soft_sum(np.array(values), lowest, highest))


@given(st.floats(-0.5, 1.5), st.integers(0, 3))
def test_one_source_alone_is_what_it_is(value: float, others: int) -> None:
    assert soft_sum([0.0] * others + [value], *RANGE) == value


@given(st.lists(st.floats(0.0, 0.25), max_size=3))
def test_up_to_the_knee_it_is_plain_addition(values: list[float]) -> None:
    assert soft_sum(values, *RANGE) == sum(values)


@given(st.lists(INSIDE, min_size=1, max_size=6), st.randoms())
def test_it_stays_within_the_limit_and_no_order_counts(values: list[float], random: object) -> None:
    total = soft_sum(values, *RANGE)
    assert RANGE[0] <= total <= RANGE[1]
    random.shuffle(values)  # type: ignore[attr-defined]
    assert soft_sum(values, *RANGE) == pytest.approx(total, abs=1e-9)


@given(INSIDE, INSIDE, st.floats(0.0, 0.3))
def test_more_of_a_source_is_never_less(one: float, other: float, more: float) -> None:
    assert soft_sum([one, other], *RANGE) <= soft_sum([min(one + more, 0.99), other], *RANGE) + 1e-9


@given(st.sampled_from([-0.5, -0.4, 0.0, 0.8, 1.0, 1.2]), st.floats(-0.3, 0.6))
def test_it_has_no_kink_where_a_source_passes_the_knee_or_the_limit(at: float, other: float) -> None:
    low, here, high = (soft_sum([at + step, other], *RANGE) for step in (-TINY, 0.0, TINY))
    assert high - here == pytest.approx(here - low, abs=2e-3 * TINY)


def test_many_full_sources_come_to_the_limit_itself() -> None:
    assert soft_sum([0.7] * 8, *RANGE) == pytest.approx(1.0, abs=0.02)
    assert soft_sum([1.0, 0.7], *RANGE) == 1.0
    assert soft_sum([1.3, 1.1], *RANGE) == 1.3
