"""Many pass the gate at once, or one alone."""

import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from omote.server.persistence.file_gate import FileGate


def test_many_are_inside_at_once() -> None:
    gate = FileGate()
    inside = threading.Barrier(4, timeout=60.0)

    def use() -> None:
        with gate:
            inside.wait()

    with ThreadPoolExecutor(4) as pool:
        for each in [pool.submit(use) for _ in range(4)]:
            each.result()


def test_whoever_is_alone_meets_nobody() -> None:
    gate = FileGate()
    users = list[int]()
    met = list[int]()

    def use(number: int) -> None:
        for _ in range(200):
            with gate:
                users.append(number)
                users.remove(number)

    def be_alone() -> None:
        for _ in range(50):
            with gate.alone():
                met.extend(users)

    with ThreadPoolExecutor(5) as pool:
        for each in [*(pool.submit(use, number) for number in range(3)), *(pool.submit(be_alone) for _ in range(2))]:
            each.result()
    assert met == []


def test_whoever_waits_for_a_disk_that_hangs_gives_up_and_lets_the_others_in() -> None:
    gate = FileGate(longest_wait=0.0)
    with gate:
        with pytest.raises(TimeoutError, match="the disk does not answer"), gate.alone():
            raise AssertionError
        with gate:
            pass
    with gate.alone():
        pass


def test_an_error_opens_the_gate() -> None:
    gate = FileGate()
    with pytest.raises(ArithmeticError), gate.alone():
        raise ArithmeticError
    with gate:
        pass
