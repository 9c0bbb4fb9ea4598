"""The point of a pad: what shows follows it, as the follower of one number does, in value and in speed."""

from __future__ import annotations

import pytest

from omote.perform.layers.follower import follow_number, rate_of
from omote.perform.pads.pad_point import FOLLOW_SECONDS, point_after, point_at, point_moved, point_rates

STEP = 1.0 / 60.0
RATE = rate_of(FOLLOW_SECONDS)


def test_each_weight_follows_as_one_number_does_and_nine_tenths_are_gone_in_time() -> None:
    point = point_moved(point_at("pad", (0.0,), {"a": 1.0}), (1.0,), {"b": 0.75, "c": 0.25})
    first = second = 0.0
    for _ in range(30):
        point = point_after(point, STEP)
        first, second = follow_number(first, second, 0.75, RATE, STEP)
        assert point.second["b"] == pytest.approx(second, abs=1e-7)  # what is as near as that is there
        assert sum(point.second.values()) == pytest.approx(1.0, abs=1e-12)
        assert all(0.0 <= weight <= 1.0 for weight in point.second.values())
    gone = point_after(point_moved(point_at("pad", (0.0,), {"a": 1.0}), (1.0,), {"b": 1.0}), FOLLOW_SECONDS)
    assert gone.second["b"] == pytest.approx(0.9, abs=0.03)


def test_it_comes_to_stand_where_it_goes_and_costs_nothing_from_then_on() -> None:
    point = point_moved(point_at("pad", (0.0,), {"a": 1.0}), (1.0,), {"b": 1.0})
    stands = point_after(point, 1.0)
    assert (stands.second, point_rates(stands)) == ({"b": 1.0}, {})
    assert point_after(stands, STEP) is stands
    assert point_after(point, 0.0) is point


def test_its_speed_is_what_it_moves_by() -> None:
    point = point_moved(point_at("pad", (0.0,), {"a": 1.0}), (1.0,), {"b": 1.0})
    for _ in range(3):
        point = point_after(point, STEP)
    moved = point_after(point, 1e-6)
    rates = point_rates(point)
    assert rates["a"] == pytest.approx(-rates["b"])
    assert rates["b"] == pytest.approx((moved.second["b"] - point.second["b"]) / 1e-6, rel=1e-4)
