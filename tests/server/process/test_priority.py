"""The show goes first where the system allows it, and plays on where it does not."""

import os
import threading

import pytest

from omote.server.process.priority import (
    AUTOGROUP,
    LOWERED,
    RAISED,
    lower_priority,
    others_waiting_seconds,
    raise_priority,
    waiting_seconds,
)


def test_a_process_goes_first_or_says_that_it_may_not() -> None:
    pid = os.fork()
    if pid == 0:  # in a copy: what is gained here could not be given back
        before = os.getpriority(os.PRIO_PROCESS, 0)
        gained = raise_priority()
        os._exit(0 if os.getpriority(os.PRIO_PROCESS, 0) == (RAISED if gained else before) else 1)
    assert os.waitpid(pid, 0) == (pid, 0)


def test_no_right_to_it_is_no_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    def forbidden(*_: int) -> None:
        raise PermissionError

    monkeypatch.setattr(os, "setpriority", forbidden)
    assert not raise_priority()


def niceness_of_session() -> int:
    """What the system says of the share of this process's session: `/autogroup-12 nice 0`."""
    return int(AUTOGROUP.read_text().split()[-1])


@pytest.mark.skipif(not AUTOGROUP.exists(), reason="this system divides no processors among sessions")
def test_a_session_goes_first_with_its_leader_and_those_who_work_for_it_leave_it() -> None:
    pid = os.fork()
    if pid == 0:
        os.setsid()
        before = niceness_of_session()
        gained = raise_priority(leads_session=True)
        right = niceness_of_session() == (RAISED if gained else before)
        worker = os.fork()
        if worker == 0:
            lower_priority(leaves_session=True)
            os._exit(0 if niceness_of_session() == LOWERED and os.getsid(0) == os.getpid() else 1)
        os._exit(0 if right and os.waitpid(worker, 0)[1] == 0 else 1)
    assert os.waitpid(pid, 0) == (pid, 0)


def test_a_process_goes_behind_the_show() -> None:
    pid = os.fork()
    if pid == 0:
        lower_priority()
        os._exit(0 if os.getpriority(os.PRIO_PROCESS, 0) == LOWERED else 1)
    assert os.waitpid(pid, 0) == (pid, 0)


def test_waiting_for_a_processor_only_grows_and_what_is_not_there_waits_for_none() -> None:
    first = waiting_seconds(os.getpid())
    assert 0.0 <= first <= waiting_seconds(os.getpid())
    pid = os.fork()
    if pid == 0:
        os._exit(0)
    os.waitpid(pid, 0)
    assert waiting_seconds(pid) == others_waiting_seconds(pid) == 0.0


def test_other_threads_are_told_apart_from_the_main_one() -> None:
    """Of a process of one thread there are none; of one with more what they waited only grows."""
    pid = os.getpid()
    begun = threading.Event()
    done = threading.Event()

    def count() -> None:
        begun.set()
        done.wait()

    thread = threading.Thread(target=count)
    thread.start()
    begun.wait()
    assert 0.0 <= (first := others_waiting_seconds(pid)) <= others_waiting_seconds(pid) + 1e-9
    assert first >= 0.0
    done.set()
    thread.join()
