"""A state is blamed for deaths it may have caused, and for no others."""

import signal

from omote.server.supervision.crash_loop import DEATHS, WITHIN_SECONDS, Blame


def after(codes: list[int], *, apart: float = 0.1) -> bool:
    """Whether the state is blamed after servers ended with these codes."""
    blame = Blame()
    for number, code in enumerate(codes):
        blame.ended(number * apart, code)
    return blame.blames_state((len(codes) - 1) * apart)


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
    blame = Blame()
    for now in range(DEATHS):
        assert not blame.blames_state(float(now))
        blame.hung(float(now))
    assert blame.blames_state(float(DEATHS))


def test_a_blamed_state_is_blamed_once() -> None:
    blame = Blame()
    for _ in range(DEATHS):
        blame.hung(0.0)
    assert blame.blames_state(0.0)
    assert not blame.blames_state(0.0)
