"""Runs long jobs of pages (imports, exports) in processes forked from the loaded server, one each, so that no tick
waits for them: such a process begins within milliseconds, tells of its progress, and is ended at any time.

The server forks the job server before it has a thread or an event loop. A job writes its answers into a pipe of its
own; what it has not answered by its end has failed. Jobs end with the server's socket.
"""

from __future__ import annotations

import asyncio
import itertools
import os
import signal
import socket
import struct
import traceback
from collections.abc import Callable
from contextlib import suppress

import msgspec

from omote.server.process.fork import close_descriptors, fork_beside, fork_process
from omote.server.process.priority import lower_priority
from omote.server.workers.workshop import frame, receive

Follow = Callable[[int, int, str], None]
"""Told of progress: steps done, all steps, and what is done now."""

RunJob = Callable[[bytes, Follow], bytes]
"""Does an encoded job and returns its encoded result; ValueError with a sentence for what cannot be done."""
_length = struct.Struct("!I")


class JobError(Exception):
    """A job was rejected or failed; the text is a sentence for the person who asked."""


class _Start(msgspec.Struct, frozen=True, tag=True):
    number: int
    job: bytes


class _End(msgspec.Struct, frozen=True, tag=True):
    number: int


class _Step(msgspec.Struct, frozen=True, tag=True):
    done: int
    total: int
    what: str


class _Made(msgspec.Struct, frozen=True, tag=True):
    result: bytes


class _Failed(msgspec.Struct, frozen=True, tag=True):
    sentence: str


_request: msgspec.msgpack.Decoder[_Start | _End] = msgspec.msgpack.Decoder(_Start | _End)


_answer: msgspec.msgpack.Decoder[_Step | _Made | _Failed] = msgspec.msgpack.Decoder(_Step | _Made | _Failed)


class JobServer:
    """The server's end: runs jobs, several at once."""

    def __init__(self, line: socket.socket, pid: int) -> None:
        self._line = line
        self._pid = pid
        self._numbers = itertools.count(1)

    async def run(self, job: bytes, follow: Follow) -> bytes:
        """Runs a job and returns its result; JobError where it fails. Cancelling this ends the job's process.

        job: encoded; follow: told of its progress.
        """
        number = next(self._numbers)
        reader, transport = await self._start(number, job)
        try:
            while True:
                (size,) = _length.unpack(await reader.readexactly(_length.size))
                match _answer.decode(await reader.readexactly(size)):
                    case _Step(done, total, what):
                        follow(done, total, what)
                    case _Made(result):
                        return result
                    case _Failed(sentence):
                        raise JobError(sentence)
        except asyncio.IncompleteReadError:
            raise JobError(
                "the process that did it ended without a word, perhaps for want of memory; try again."
            ) from None
        finally:
            with suppress(OSError):
                self._line.sendall(frame(msgspec.msgpack.encode(_End(number))))
            transport.close()

    def close(self) -> None:
        """Ends all jobs at once."""
        self._line.close()
        with suppress(ChildProcessError):
            os.waitpid(self._pid, 0)

    async def _start(self, number: int, job: bytes) -> tuple[asyncio.StreamReader, asyncio.ReadTransport]:
        come, go = os.pipe()
        try:
            socket.send_fds(self._line, [frame(msgspec.msgpack.encode(_Start(number, job)))], [go])
        except OSError as error:
            os.close(come)
            raise JobError("the process that starts such work is gone; restart the show when it may pause.") from error
        finally:
            os.close(go)
        reader = asyncio.StreamReader()
        transport, _ = await asyncio.get_running_loop().connect_read_pipe(
            lambda: asyncio.StreamReaderProtocol(reader), os.fdopen(come, "rb", 0)
        )
        return reader, transport


def open_job_server(run: RunJob) -> JobServer:
    """Forks a job server that does jobs with `run`, while this process has one thread; OSError where that fails."""

    def work(line: socket.socket) -> None:
        lower_priority(leaves_session=True)
        serve_jobs(line, run)

    pid, line = fork_beside(work)
    return JobServer(line, pid)


def serve_jobs(line: socket.socket, run: RunJob) -> None:
    """Starts and ends jobs as they are asked for, until the line ends; then ends them all.

    line: to the server; run: does a job.
    """
    running: dict[int, int] = {}
    try:
        while (asked := _receive(line)) is not None:
            request, pipes = asked
            if isinstance(request, _End):
                _kill(running.pop(request.number, None))
            elif pipes:
                running[request.number] = _fork_job(request.job, pipes[0], run)
            for pipe in pipes:
                os.close(pipe)
    finally:
        for pid in running.values():
            _kill(pid)


def do_job(job: bytes, pipe: int, run: RunJob) -> None:
    """Does a job in this process and writes its answers into a pipe.

    job: encoded; pipe: its descriptor; run: does it.
    """
    with suppress(BrokenPipeError), os.fdopen(pipe, "wb", closefd=False) as stream:  # nobody may wait for it any more

        def write(answer: _Step | _Made | _Failed) -> None:
            stream.write(frame(msgspec.msgpack.encode(answer)))
            stream.flush()

        try:
            answer: _Made | _Failed = _Made(run(job, lambda *step: write(_Step(*step))))
        except ValueError as error:
            answer = _Failed(str(error))
        except BrokenPipeError:
            return
        except Exception as error:
            traceback.print_exc()
            answer = _Failed(f"it failed by a fault of Omote ({type(error).__name__}: {error}).")
        write(answer)


def _fork_job(job: bytes, pipe: int, run: RunJob) -> int:
    def work() -> None:
        with suppress(OSError):
            os.setpgid(0, 0)  # so that its own children end with it
        close_descriptors([pipe])
        do_job(job, pipe, run)

    pid = fork_process(work)
    with suppress(OSError):  # here too: whoever comes first
        os.setpgid(pid, pid)
    return pid


def _kill(pid: int | None) -> None:
    """Ends a job with its children; one that has ended already is a zombie, whose number nobody else has."""
    if pid is None:
        return
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(pid, signal.SIGKILL)
    with suppress(ChildProcessError):
        os.waitpid(pid, 0)


def _receive(line: socket.socket) -> tuple[_Start | _End, list[int]] | None:
    """The next request and the pipe that came with it; None when the line has ended."""
    pipes: list[int] = []
    body = receive(line, pipes)
    return None if body is None else (_request.decode(body), pipes)
