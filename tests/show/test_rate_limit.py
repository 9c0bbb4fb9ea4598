"""The bucket lets through what was promised, and no more."""

from hypothesis import given
from hypothesis import strategies as st

from omote.show.rate_limit import TokenBucket


@given(st.lists(st.floats(0.0, 0.1), max_size=300))
def test_no_more_passes_than_burst_and_rate_allow(waits: list[float]) -> None:
    bucket = TokenBucket(rate=50.0, burst=10.0)
    now = 0.0
    passed = 0
    for wait in waits:
        now += wait
        passed += bucket.take(now)
    assert passed <= 10.0 + 50.0 * now + 1e-6


def test_who_keeps_to_the_rate_is_never_held_up() -> None:
    bucket = TokenBucket(rate=64.0, burst=1.0)
    assert all(bucket.take(number / 64.0) for number in range(1000))


def test_a_clock_that_goes_back_gives_nothing() -> None:
    bucket = TokenBucket(rate=1.0, burst=1.0)
    assert bucket.take(100.0)
    assert not bucket.take(50.0)
    assert not bucket.take(50.5)
