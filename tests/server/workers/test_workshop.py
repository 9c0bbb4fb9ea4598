"""Orders are made beside the server, whatever happens to who makes them."""

import asyncio
import os
import signal
import socket
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from omote.server.process import fork
from omote.server.workers import workshop as module
from omote.server.workers.workshop import (
    ClosedWorkshopError,
    FailedOrderError,
    Make,
    RefusedOrderError,
    Workshop,
    frame,
    open_workshop,
    receive,
)

Orders = tuple[str, ...]


def made(make: Make, *orders: str, before: Callable[[Workshop], None] = lambda _: None) -> list[bytes | str]:
    """What a workshop answers to these orders; a refusal as its sentence."""
    workshop = open_workshop(make)

    async def ask(order: str) -> bytes | str:
        try:
            return await workshop.make(order.encode())
        except (FailedOrderError, RefusedOrderError, ClosedWorkshopError) as error:
            return str(error)

    async def ask_all() -> list[bytes | str]:
        try:
            answers = [await ask(orders[0])]
            before(workshop)
            return answers + [await ask(each) for each in orders[1:]]
        finally:
            workshop.close()

    return asyncio.run(ask_all())


def worn(order: bytes) -> bytes:
    """The expression on the face that is the oldest."""
    return b"old " + order


def test_orders_are_made_in_another_process() -> None:
    pids = made(lambda _: str(os.getpid()).encode(), "smile", "cry")
    assert pids[0] == pids[1] != str(os.getpid()).encode()
    assert made(worn, "smile", "cry") == [b"old smile", b"old cry"]


def test_an_order_may_be_answered_with_nothing() -> None:
    assert made(lambda _: b"", "smile", "cry") == [b"", b""]


def test_long_orders_and_answers_come_whole() -> None:
    assert made(bytes.upper, "smile" * 1_000_000) == [b"SMILE" * 1_000_000]
    assert made(lambda order: order * 1_000_000, "smile") == [b"smile" * 1_000_000]


def test_what_cannot_be_made_is_refused_and_the_next_is_made(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", open(2, "w", closefd=False, buffering=1))  # noqa: SIM115  (a terminal's)

    def make(order: bytes) -> bytes:
        if order == b"cry":
            raise ArithmeticError("no tears")
        return worn(order)

    answers = made(make, "smile", "cry", "smile")
    assert answers[::2] == [b"old smile", b"old smile"]
    assert answers[1] == "this cannot be computed (a fault of Omote, ArithmeticError: no tears)"
    assert "no tears" in capfd.readouterr().err


def test_what_is_refused_comes_back_as_its_sentence_and_the_next_is_made() -> None:
    def make(order: bytes) -> bytes:
        if order == b"cry":
            raise ValueError("there is no muscle \u00ab\u6d99\u00bb; near are zygomatic")
        return worn(order)

    refused = "there is no muscle \u00ab\u6d99\u00bb; near are zygomatic"
    assert made(make, "smile", "cry", "smile") == [b"old smile", refused, b"old smile"]


def test_a_worker_that_dies_is_replaced_and_its_order_repeated(tmp_path: Path) -> None:
    def make(order: bytes) -> bytes:
        if order == b"cry" and not (tmp_path / "died").exists():
            (tmp_path / "died").touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return worn(order)

    assert made(make, "smile", "cry", "smile") == [b"old smile", b"old cry", b"old smile"]
    assert (tmp_path / "died").exists()


def test_an_order_that_kills_every_worker_fails_and_the_next_is_made(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", open(2, "w", closefd=False, buffering=1))  # noqa: SIM115  (a terminal's)

    def make(order: bytes) -> bytes:
        if order == b"cry":
            os.kill(os.getpid(), signal.SIGKILL)
        return worn(order)

    answers = made(make, "smile", "cry", "smile")
    assert answers[::2] == [b"old smile", b"old smile"]
    assert "cannot be computed (the process that computes ended" in str(answers[1])
    assert "omote: something cannot be computed: the process that computes ended" in capfd.readouterr().err


def test_a_worker_that_hangs_is_replaced_and_its_order_made_by_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "HANG_SECONDS", 5.0)  # enough for the others on a busy machine

    def make(order: bytes) -> bytes:
        if order == b"cry" and not (tmp_path / "hung").exists():
            (tmp_path / "hung").touch()
            os.kill(os.getpid(), signal.SIGSTOP)
        return worn(order)

    assert made(make, "smile", "cry", "smile") == [b"old smile", b"old cry", b"old smile"]
    assert (tmp_path / "hung").exists()


def test_without_its_supervisor_the_workshop_is_closed() -> None:
    answers = made(worn, "smile", "cry", before=lambda workshop: os.kill(workshop.supervisor_pid, signal.SIGKILL))
    assert answers == [b"old smile", "the process that computes beside the show is gone"]


def test_worker_and_supervisor_end_with_the_server() -> None:
    end, held = os.pipe()  # ends when the last copy of the server is gone

    def keep_open(_: bytes) -> bytes:
        return b"!"

    pid = os.fork()
    if pid == 0:
        try:
            workshop = open_workshop(keep_open)
            asyncio.run(workshop.make(b"smile"))
            os.write(held, f"{workshop.supervisor_pid}\n".encode())
        finally:
            os._exit(0)  # as if it were killed: it closes nothing
    os.close(held)
    supervisor_pid = int(os.read(end, 20))
    assert os.read(end, 1) == b""
    os.waitpid(pid, 0)
    ended(supervisor_pid)
    os.close(end)


def ended(pid: int) -> None:
    """Waits until a process that is not our child has ended."""
    while Path(f"/proc/{pid}").exists() and "State:\tZ" not in Path(f"/proc/{pid}/status").read_text():
        os.sched_yield()


def test_workshop_without_a_process_to_spare(monkeypatch: pytest.MonkeyPatch) -> None:
    def none_left(_: object) -> int:
        raise BlockingIOError("no process to spare")

    monkeypatch.setattr(fork, "fork_process", none_left)
    with pytest.raises(OSError, match="no process to spare"):
        open_workshop(worn)


def test_frames_arrive_as_they_were_sent() -> None:
    ours, theirs = socket.socketpair()
    for data in (b"", b"a", bytes(1000)):
        ours.sendall(frame(data))
        assert receive(theirs) == data
    ours.sendall(frame(b"cut off")[:-1])
    ours.close()
    assert receive(theirs) is None
    theirs.close()


def test_a_line_whose_other_end_died_has_ended() -> None:
    ours, theirs = socket.socketpair()
    ours.sendall(frame(b"unread"))
    theirs.close()
    assert receive(ours) is None
    ours.close()
