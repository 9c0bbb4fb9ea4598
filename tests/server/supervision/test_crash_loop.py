"""A state is suspected for crashes that it may have caused, and for no others."""

import signal

from omote.server.supervision.crash_loop import DEATHS, WITHIN_SECONDS, CrashLoop


def after(codes: list[int], *, apart: float = 0.1) -> bool:
    """Whether the state is blamed after servers ended with these codes."""
    crash_loop = CrashLoop()
    for number, code in enumerate(codes):
        crash_loop.record_end(number * apart, code)
    return crash_loop.suspects_state((len(codes) - 1) * apart)


def test_crashes_in_a_row_are_the_fault_of_the_state() -> None:
    assert after([1] * DEATHS)
    assert after([1, -signal.SIGSEGV, -signal.SIGABRT])
    assert not after([1] * (DEATHS - 1))


def test_kills_from_outside_are_not() -> None:
    assert not after([-signal.SIGKILL] * 20)
    assert not after([-signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP] * 5)
    assert not after([0] * 20)
    assert after([1, -signal.SIGKILL, 1, -signal.SIGKILL, 1])


def test_crashes_long_apart_are_not() -> None:
    assert after([1] * DEATHS, apart=WITHIN_SECONDS / DEATHS)
    assert not after([1] * 20, apart=WITHIN_SECONDS)


def test_hanging_counts_like_crashing() -> None:
    crash_loop = CrashLoop()
    for now in range(DEATHS):
        assert not crash_loop.suspects_state(float(now))
        crash_loop.record_hang(float(now))
    assert crash_loop.suspects_state(float(DEATHS))


def test_a_suspected_state_is_suspected_once() -> None:
    crash_loop = CrashLoop()
    for _ in range(DEATHS):
        crash_loop.record_hang(0.0)
    assert crash_loop.suspects_state(0.0)
    assert not crash_loop.suspects_state(0.0)
