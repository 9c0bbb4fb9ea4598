"""Counted random numbers: even, independent, the same everywhere."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion.counter_hash import uniform

KEYS = st.integers(0, 2**31 - 1)


@given(KEYS, KEYS, st.integers(-(2**40), 2**40))
def test_a_key_has_one_number_from_0_to_below_1(seed: int, kind: int, count: int) -> None:
    number = uniform(seed, kind, count)
    assert 0.0 <= number < 1.0
    assert number == uniform(seed, kind, count)
    assert (number * 2.0**53).is_integer()  # exact on every machine


@given(KEYS)
def test_numbers_are_even_and_do_not_follow_each_other(seed: int) -> None:
    numbers = np.array([[uniform(seed, kind, count) for count in range(400)] for kind in range(4)])
    assert abs(numbers.mean() - 0.5) < 0.06
    assert abs(numbers.std() - 12**-0.5) < 0.04
    following = np.corrcoef(numbers[:, 1:].ravel(), numbers[:, :-1].ravel())[0, 1]
    beside = np.corrcoef(numbers)[np.triu_indices(4, 1)]
    assert abs(following) < 0.15
    assert np.abs(beside).max() < 0.3
