"""Does work with what strangers made in a child process with limits on time, memory and descriptors, and follows it."""

from __future__ import annotations

import contextlib
import os
import resource
import select
import signal
import struct
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import msgspec

Tell = Callable[[float, str], None]
"""Told how much is done, 0 to 1, and what is being done."""
_HEAD = struct.Struct("<cQ")
_PROGRESS, _ANSWER, _REFUSED = b"p", b"a", b"r"


@dataclass(frozen=True)
class Limits:
    """Limits of a child: CPU seconds, seconds that anyone waits, bytes of memory beyond its first, open files.

    writes: whether it may write files, as compilers do.
    """

    seconds: int = 60
    patience: float = 300.0
    memory: int = 2 * 2**30
    files: int = 16
    writes: bool = False


def ignore_progress(_: float, _what: str, /) -> None:
    """Where nobody wants to know."""


def run_limited(
    work: Callable[[Tell], bytes], limits: Limits, *, exhausted: str, follow: Tell = ignore_progress
) -> bytes:  # fmt: skip
    """Does `work` in a child process; returns the bytes that it returns.

    ValueError with its sentence where it raises one, and with `exhausted` where it died, took more than the limits or
    longer than anyone waits. On any error here, Ctrl-C too, the child is killed.
    """
    come, go = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(come)
        _work_and_exit(work, limits, go)
    os.close(go)
    try:
        return _follow_child(come, limits, exhausted, follow)
    finally:
        os.close(come)
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)


def _work_and_exit(work: Callable[[Tell], bytes], limits: Limits, go: int) -> None:
    with contextlib.suppress(BaseException):
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)  # decoders of other people talk to the terminal
        _limit_resources(limits)
        with os.fdopen(go, "wb") as pipe:
            kind, body = _try_work(work, lambda done, what: _send(pipe.fileno(), done, what))
            pipe.write(_HEAD.pack(kind, len(body)))
            pipe.write(body)
    os._exit(0)  # not further up: what follows there belongs to the parent


def _send(pipe: int, done: float, what: str) -> None:
    body = msgspec.msgpack.encode((done, what))
    os.write(pipe, _HEAD.pack(_PROGRESS, len(body)) + body)


def _try_work(work: Callable[[Tell], bytes], tell: Tell) -> tuple[bytes, bytes]:
    try:
        return _ANSWER, work(tell)
    except ValueError as error:
        return _REFUSED, str(error).encode("utf-8", "replace")
    except (MemoryError, OSError):
        raise  # it met a limit
    except Exception as error:
        what = f"{type(error).__name__}: {error}"
        return _REFUSED, f"Omote failed at it ({what[:200]}); please report this".encode("utf-8", "replace")


def _follow_child(come: int, limits: Limits, exhausted: str, follow: Tell) -> bytes:
    end = time.monotonic() + limits.patience
    while True:
        head = _read(come, _HEAD.size, end)
        kind, size = _HEAD.unpack(head) if len(head) == _HEAD.size else (b"", 0)
        body = _read(come, min(size, limits.memory), end)
        if len(body) < size or kind not in (_PROGRESS, _ANSWER, _REFUSED):
            raise ValueError(exhausted)
        if kind == _REFUSED:
            raise ValueError(body.decode())
        if kind == _ANSWER:
            return body
        follow(*msgspec.msgpack.decode(body, type=tuple[float, str]))


def _read(come: int, size: int, end: float) -> bytes:
    """So many bytes, fewer where the child ends or is waited for too long."""
    parts, left, poll = [], size, select.poll()
    poll.register(come, select.POLLIN)
    while left:
        if not poll.poll(1000.0 * max(end - time.monotonic(), 0.0)):
            break
        part = os.read(come, min(left, 2**20))
        if not part:
            break
        parts.append(part)
        left -= len(part)
    return b"".join(parts)


def _limit_resources(limits: Limits) -> None:
    """Limits this process: CPU time, memory, file writes, descriptors; no core dumps."""
    pages = int(Path("/proc/self/statm").read_text().split()[0]) if Path("/proc/self/statm").exists() else 0
    resource.setrlimit(resource.RLIMIT_CPU, (limits.seconds, limits.seconds))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_NOFILE, (limits.files, limits.files))
    if not limits.writes:
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
    if pages:
        most = pages * resource.getpagesize() + limits.memory
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
