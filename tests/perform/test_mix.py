"""The algebra of mixes, and the range that no weight leaves."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.mix import HIGHEST, LOWEST, Weights, combine, mix_of_one, normalise, share_in_range

weights = st.dictionaries(st.sampled_from("abcd"), st.floats(-2.0, 2.0))
bases = st.dictionaries(st.sampled_from("abcd"), st.floats(LOWEST, HIGHEST))


@given(weights, weights, st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
def test_combining_is_linear_in_every_name(first: Weights, second: Weights, a: float, b: float) -> None:
    mixed = combine(((a, first), (b, second)))
    for name in "abcd":
        assert mixed.get(name, 0.0) == pytest.approx(a * first.get(name, 0.0) + b * second.get(name, 0.0), abs=1e-12)
    assert all(mixed.values())


def test_one_name_alone_is_the_unit_of_mixing() -> None:
    assert combine(((1.0, mix_of_one("a")), (0.0, mix_of_one("b")))) == {"a": 1.0}


@given(bases, weights)
def test_the_share_keeps_all_in_range_and_is_the_largest_that_does(base: Weights, offset: Weights) -> None:
    share = share_in_range(base, offset)
    assert 0.0 <= share <= 1.0
    moved = {name: base.get(name, 0.0) + share * change for name, change in offset.items()}
    assert all(LOWEST - 1e-12 <= weight <= HIGHEST + 1e-12 for weight in moved.values())
    if share < 1.0:
        ends = [(HIGHEST if change > 0 else LOWEST) for change in offset.values()]
        assert any(math.isclose(weight, end, abs_tol=1e-9) for weight, end in zip(moved.values(), ends, strict=True))


def test_a_mix_is_normalised_in_its_own_proportions() -> None:
    assert normalise({"a": 0.3, "b": 0.1}) == pytest.approx({"a": 0.75, "b": 0.25})
