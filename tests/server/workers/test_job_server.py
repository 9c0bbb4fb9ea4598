"""Jobs are done beside the show, tell how far they are, and end when they are cancelled."""

import asyncio
import os
import signal
import sys
import time
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest

from omote.server.process import fork
from omote.server.workers import job_server as module
from omote.server.workers.job_server import Follow, JobError, JobServer, RunJob, open_job_server

Asking = Callable[[JobServer], Awaitable[list[object]]]


def asked(run: RunJob, ask: Asking) -> list[object]:
    """What a page that asks a job server is answered."""
    server = open_job_server(run)

    async def ask_all() -> list[object]:
        try:
            return await ask(server)
        finally:
            server.close()

    return asyncio.run(ask_all())


def ignore(*_: object) -> None:
    """Follows nothing."""


def test_a_job_is_done_in_a_process_of_its_own_which_tells_its_progress() -> None:
    def run(job: bytes, follow: Follow) -> bytes:
        follow(0, 2, "first")
        follow(1, 2, "second")
        return job.upper() * 100_000 + f" {os.getpid()}".encode()

    async def ask(server: JobServer) -> list[object]:
        steps: list[object] = []
        made = [await server.run(b"smile", lambda *step: steps.append(step)), await server.run(b"cry", ignore)]
        return [steps, *made]

    steps, smile, cry = asked(run, ask)
    assert steps == [(0, 2, "first"), (1, 2, "second")]
    assert isinstance(smile, bytes)
    assert isinstance(cry, bytes)
    assert smile.startswith(b"SMILE" * 100_000)
    pids = {int(made.split()[-1]) for made in (smile, cry)}
    assert len(pids) == 2
    assert os.getpid() not in pids


def test_jobs_are_done_at_the_same_time(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "meet")

    def run(job: bytes, _: Follow) -> bytes:
        with (tmp_path / "meet").open("rb" if job == b"reads" else "wb"):  # each waits for the other
            return job

    async def ask(server: JobServer) -> list[object]:
        return list(await asyncio.gather(server.run(b"reads", ignore), server.run(b"writes", ignore)))

    assert asked(run, ask) == [b"reads", b"writes"]


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (ValueError("there is no face in it."), "there is no face in it."),
        (ArithmeticError("no tears"), "it failed by a fault of Omote (ArithmeticError: no tears)."),
        (None, "without a word"),
    ],
)
def test_a_job_that_fails_says_why_and_the_next_is_done(
    error: Exception | None, told: str, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", open(2, "w", closefd=False, buffering=1))  # noqa: SIM115  (a terminal's)

    def run(job: bytes, _: Follow) -> bytes:
        if job == b"cry" and error is None:
            os.kill(os.getpid(), signal.SIGKILL)
        if job == b"cry" and error is not None:
            raise error
        return job

    async def ask(server: JobServer) -> list[object]:
        with pytest.raises(JobError) as failed:
            await server.run(b"cry", ignore)
        return [str(failed.value), await server.run(b"smile", ignore)]

    sentence, smile = asked(run, ask)
    assert told in str(sentence)
    assert smile == b"smile"
    assert ("no tears" in capfd.readouterr().err) == isinstance(error, ArithmeticError), "faults are for the terminal"


def test_a_cancelled_job_ends_with_its_children_and_the_next_is_done() -> None:
    def run(job: bytes, follow: Follow) -> bytes:
        if job == b"cry":
            child = os.fork()
            follow(os.getpid(), child or os.getpid(), "weeping")
            while True:
                time.sleep(60.0)
        return job

    async def ask(server: JobServer) -> list[object]:
        weeping = asyncio.Event()
        pids = set[int]()

        def follow(parent: int, child: int, _: str) -> None:
            pids.update((parent, child))
            if len(pids) > 1:
                weeping.set()

        job = asyncio.create_task(server.run(b"cry", follow))
        await weeping.wait()
        job.cancel()
        with pytest.raises(asyncio.CancelledError):
            await job
        return [await server.run(b"smile", ignore), *pids]

    smile, *pids = asked(run, ask)
    assert smile == b"smile"
    for pid in pids:
        ended(int(str(pid)))


def ended(pid: int) -> None:
    """Waits until a process that is not our child has ended."""
    while Path(f"/proc/{pid}").exists() and "State:\tZ" not in Path(f"/proc/{pid}/status").read_text():
        os.sched_yield()


def test_jobs_end_with_the_server() -> None:
    pids: list[int] = []

    def run(_: bytes, follow: Follow) -> bytes:
        follow(os.getpid(), 0, "")
        while True:
            time.sleep(60.0)

    async def ask(server: JobServer) -> list[object]:
        begun = asyncio.Event()

        def follow(pid: int, _: int, __: str) -> None:
            pids.append(pid)
            begun.set()

        job = asyncio.create_task(server.run(b"", follow))
        await begun.wait()
        server.close()
        with pytest.raises(JobError, match="without a word"):
            await job
        with pytest.raises(JobError, match="is gone"):
            await server.run(b"", ignore)
        return []

    asked(run, ask)
    ended(pids[0])


def test_a_job_that_nobody_waits_for_ends_without_a_word(capsys: pytest.CaptureFixture[str]) -> None:
    for told in (0, 1):  # progress and result, the result alone
        come, go = os.pipe()
        os.close(come)

        def run(job: bytes, follow: Follow, told: int = told) -> bytes:
            for done in range(told):
                follow(done, told, "smile")
            return job

        module.do_job(b"smile", go, run)
        os.close(go)
    assert capsys.readouterr().err == ""


def test_without_a_process_to_spare_there_is_no_job_server(monkeypatch: pytest.MonkeyPatch) -> None:
    def none_left(_: object) -> int:
        raise BlockingIOError("no process to spare")

    monkeypatch.setattr(fork, "fork_process", none_left)
    with pytest.raises(OSError, match="no process to spare"):
        open_job_server(lambda job, _: job)
