"""Curves through knots: exact at them, between two of them elsewhere, and of one slope at each."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from omote.perform.mappings.monotone_curve import STRAIGHT, Knots, check_knots, curve_at

PARTS = st.floats(0.0, 1.0)
TINY = 1e-6


@st.composite
def knots(draw: st.DrawFn, *, rises: bool = False) -> Knots:
    places = sorted(draw(st.sets(st.integers(1, 49), max_size=5)))
    values = [draw(PARTS) for _ in range(len(places) + 1)]
    ats = [0.0, *(place / 50 for place in places), 1.0]
    return check_knots([*zip(ats, [0.0, *(sorted(values) if rises else values)], strict=True)], "the curve")


@given(knots())
def test_it_goes_through_its_knots_and_nowhere_beyond_two_neighbours(curve: Knots) -> None:
    assert [curve_at(curve, at) for at, _ in curve] == [gives for _, gives in curve]
    for (begin, low), (end, high) in pairwise(curve):
        between = [curve_at(curve, begin + (end - begin) * part / 16) for part in range(1, 16)]
        assert min(low, high) <= min(between)
        assert max(between) <= max(low, high)


@given(knots(rises=True), PARTS, PARTS)
def test_it_rises_where_its_knots_rise(curve: Knots, one: float, other: float) -> None:
    assert curve_at(curve, min(one, other)) <= curve_at(curve, max(one, other)) + 1e-12


@given(knots())
@example(((0.0, 0.0), (0.46, 2.3e-309), (1.0, 1.0)))  # a slope over it was endless
def test_it_has_one_slope_at_a_knot(curve: Knots) -> None:
    for at, gives in curve[1:-1]:
        before = (gives - curve_at(curve, at - TINY)) / TINY
        after = (curve_at(curve, at + TINY) - gives) / TINY
        assert before == pytest.approx(after, abs=TINY * 1e6)


@given(PARTS)
def test_two_knots_are_a_straight_line(at: float) -> None:
    assert curve_at(STRAIGHT, at) == at


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ([(0, 0)], "2 to 7"),
        ([(0, 0), *[(n / 9, 0.5) for n in range(1, 8)], (1, 1)], "2 to 7"),
        ([(0, 0.2), (1, 1)], "begin at"),
        ([(0, 0), (0.9, 1)], "end where"),
        ([(0, 0), (0.5, 0.2), (0.505, 0.3), (1, 1)], "further on"),
        ([(0, 0), (1, 1.2)], "from 0 to 1"),
        ([(0, 0), (1, 1, 1)], "a knot"),
    ],
)
def test_what_no_curve_goes_through_is_refused(wrong: list[tuple[float, ...]], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        check_knots(wrong, "the curve")
