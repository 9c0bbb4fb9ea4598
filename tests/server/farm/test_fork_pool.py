"""Work in forked processes: all is done once, a death costs its own piece, and nobody outlives the parent."""

import os
import signal
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest

from omote.server.farm.fork_pool import WorkOutcome, work_in_processes


@pytest.mark.parametrize("jobs", [1, 3])
def test_every_piece_is_done_once_in_other_processes(jobs: int) -> None:
    outcomes = list(work_in_processes(lambda number: f"{number} {os.getpid()}".encode(), range(7), jobs))
    told = [outcome.result.decode().split() for outcome in outcomes]
    assert sorted(int(number) for number, _ in told) == [*range(7)] == sorted(o.number for o in outcomes)
    assert os.getpid() not in {int(pid) for _, pid in told}
    assert len({pid for _, pid in told}) <= jobs


def fail(number: int) -> bytes:
    """Fails in each way there is."""
    match number:
        case 0:
            raise ValueError("this face does not fit")
        case 1:
            raise OSError(28, "No space left on device")
        case 2:
            raise ZeroDivisionError("oh")
        case 3:
            os.kill(os.getpid(), signal.SIGKILL)
    return b"done"


def test_what_fails_says_why_and_the_others_go_on() -> None:
    found = {outcome.number: outcome for outcome in work_in_processes(fail, range(6), 2)}
    assert found[0] == WorkOutcome(0, failure="this face does not fit")
    assert (found[1].final, "the disk is full" in found[1].failure) == (True, True)
    assert "a fault of Omote (ZeroDivisionError: oh)" in found[2].failure
    assert "ended without a word (signal 9)" in found[3].failure
    assert [found[number].result for number in (4, 5)] == [b"done", b"done"]


def test_closing_ends_the_processes_in_order(tmp_path: Path) -> None:
    """A worker that is ended cleans up what it was writing."""
    ready = tmp_path / "ready"

    def work(number: int) -> bytes:
        if number:
            try:
                ready.write_text(str(os.getpid()))
                signal.pause()
            finally:
                (tmp_path / "cleaned").touch()
        return b""

    with closing(work_in_processes(work, range(2), 2)) as outcomes:
        assert next(outcomes).number == 0
        while not (ready.exists() and ready.read_text()):
            os.sched_yield()
    assert (tmp_path / "cleaned").exists()
    with pytest.raises(ProcessLookupError):
        os.kill(int(ready.read_text()), 0)


KILLED = """
import os
from omote.server.farm.fork_pool import work_in_processes
def work(number):
    print(os.getpid(), flush=True)
    return b""
for outcome in work_in_processes(work, range(100_000), 2):
    pass
"""


def test_workers_end_with_a_parent_that_is_killed() -> None:
    parent = subprocess.Popen([sys.executable, "-c", KILLED], stdout=subprocess.PIPE, text=True)
    assert parent.stdout is not None
    with parent.stdout as said:
        workers = set[str]()
        while len(workers) < 2:
            workers.add(said.readline())
        parent.kill()
        parent.wait()
        said.read()  # ends when no worker holds it any more
