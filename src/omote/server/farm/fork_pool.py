"""Works in several processes at once, each a fork of this one with the cast that it has loaded.

`concurrent.futures` would do but for two deaths: where the parent is killed its workers wait for ever, for each holds
the end of the pipe that they listen to; and where one worker is killed (want of memory, a crash in a library) all
others are given up. Here a worker sees its line end, and a dead one costs its own piece of work.
"""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Callable, Generator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait

import msgspec

from omote.interchange.formats.error_reasons import explain_error
from omote.server.process.fork import close_descriptors, fork_process
from omote.server.process.priority import lower_priority

Work = Callable[[int], bytes]
"""Does a numbered piece of work; ValueError or FileExistsError where it cannot be done, OSError where nothing can."""
ORDER = 8
"""Bytes of the number of a piece of work."""


class WorkOutcome(msgspec.Struct, frozen=True):
    """What became of a piece of work: its result, or why it failed; final: so would all others."""

    number: int
    result: bytes = b""
    failure: str = ""
    final: bool = False


@dataclass(eq=False)
class _Worker:
    pid: int
    line: Connection
    number: int = -1


_outcome: msgspec.msgpack.Decoder[WorkOutcome] = msgspec.msgpack.Decoder(WorkOutcome)


def work_in_processes(work: Work, numbers: Sequence[int], jobs: int) -> Generator[WorkOutcome]:
    """Yields the outcome of each piece of work as it is done, in so many processes at once; close it to end them.

    Call it while this process has one thread. A worker that dies is replaced; what it was at has failed. work: does a
    piece; numbers: of the pieces; jobs: how many processes.
    """
    gc.freeze()  # what is loaded stays shared: the collector would write into every object
    left = list(numbers)
    workers = list[_Worker]()
    try:
        while left or workers:
            while left and len(workers) < jobs:
                workers.append(_start(work))
                _order(workers[-1], left)
            for line in wait([worker.line for worker in workers]):
                worker = next(worker for worker in workers if worker.line is line)
                outcome = _hear(worker)
                if worker.pid and left:
                    _order(worker, left)
                else:
                    workers.remove(worker)
                    _end(worker)
                yield outcome
    finally:
        for worker in workers:
            _end(worker)
        gc.unfreeze()


def try_work(work: Work, number: int, /) -> WorkOutcome:
    """The outcome of a piece of work in this process. work: does it; number: of the piece."""
    try:
        return WorkOutcome(number, work(number))
    except (ValueError, FileExistsError) as error:
        return WorkOutcome(number, failure=explain_error(error))
    except OSError as error:
        return WorkOutcome(number, failure=explain_error(error), final=True)
    except Exception as error:
        return WorkOutcome(number, failure=f"it failed by a fault of Omote ({type(error).__name__}: {error})")


def _start(work: Work) -> _Worker:
    ours, theirs = Pipe()
    try:
        pid = fork_process(lambda: _serve(theirs, work))
    finally:
        theirs.close()
    return _Worker(pid, ours)


def _order(worker: _Worker, left: list[int]) -> None:
    worker.number = left.pop(0)
    with suppress(OSError):  # it is dead already, which is seen when it is heard
        worker.line.send_bytes(worker.number.to_bytes(ORDER, "big"))


def _hear(worker: _Worker) -> WorkOutcome:
    """What a worker says, or that it died; then it has no process any more."""
    try:
        return _outcome.decode(worker.line.recv_bytes())
    except (EOFError, OSError):
        _, status = os.waitpid(worker.pid, 0)
        worker.pid = 0
        how = f"signal {os.WTERMSIG(status)}" if os.WIFSIGNALED(status) else f"status {os.WEXITSTATUS(status)}"
        why = f"the process that did it ended without a word ({how}), perhaps for want of memory"
        return WorkOutcome(worker.number, failure=why)


def _end(worker: _Worker) -> None:
    """Ends a worker; one that writes a file removes its draft first."""
    if worker.pid:
        with suppress(ProcessLookupError):
            os.kill(worker.pid, signal.SIGTERM)
    worker.line.close()  # after the signal, which may be lost in a finalizer; this end is not
    if worker.pid:
        with suppress(ChildProcessError):
            os.waitpid(worker.pid, 0)


class _Ended(BaseException):
    """This worker is to end now."""


def _stop(*_: object) -> None:
    raise _Ended


def _serve(line: Connection, work: Work) -> None:
    """Does what is ordered until the line ends: with the parent, however that ends."""
    with suppress(_Ended, EOFError, ConnectionError):
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's, which ends this process in order
        signal.signal(signal.SIGTERM, _stop)
        close_descriptors([line.fileno()])
        lower_priority()
        while True:
            number = int.from_bytes(line.recv_bytes(), "big")
            line.send_bytes(msgspec.msgpack.encode(try_work(work, number)))
