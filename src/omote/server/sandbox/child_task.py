"""Does work with what strangers made in a child process with limits on time, memory and descriptors, and follows it.

What the work returns is encoded there (MessagePack, arrays with their type and shape) and validated here: nothing that
a child sends is run.
"""

from __future__ import annotations

import contextlib
import os
import resource
import select
import signal
import struct
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar, get_args, get_origin

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.doubt import Doubt, DoubtKind

T = TypeVar("T")
Tell = Callable[[float, str], None]
"""Told how much is done, 0 to 1, and what is being done."""
_HEAD = struct.Struct("<cQ")
_PROGRESS = b"p"
_ANSWER = b"a"
_REFUSED = b"r"


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
    """Ignores how much is done (_) and what is being done (_what): nobody wants to know."""


def run_limited(
    work: Callable[[Tell], T], kind: Any, limits: Limits, *, exhausted: str, follow: Tell = ignore_progress
) -> T:  # fmt: skip
    """Does `work` in a child process and returns what it returns, decoded and validated as `kind`.

    limits: of that process; follow: told its progress. ValueError with the sentence of one that `work` raises, and with
    `exhausted` where it died, took more than the limits, or sent what is no `kind`; another one where it took longer
    than anyone waits, which says nothing of the work: the machine was busy. On any error here, Ctrl-C too, the child is
    killed.
    """
    come, go = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(come)
        _work_and_exit(work, limits, go)
    os.close(go)
    try:
        answer = _follow_child(come, limits, exhausted, follow)
    finally:
        os.close(come)
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
    try:
        value: T = msgspec.msgpack.decode(answer, type=kind, dec_hook=_decode_special)
    except msgspec.MsgspecError as error:
        raise ValueError(exhausted) from error
    return value


def _encode_special(value: object) -> object:
    """What MessagePack has no type for: arrays and single numbers of them, mappings that cannot be changed, doubts with
    their kinds."""
    match value:
        case np.generic():
            return value.item()
        case np.ndarray():
            return value.dtype.str, value.shape, value.tobytes()
        case Doubt():
            return str(value), value.kind
        case Mapping():
            return dict(value)
    raise NotImplementedError(f"a child cannot send a {type(value).__name__}")


def _decode_special(kind: Any, value: Any) -> object:
    if kind is Doubt:
        return Doubt(*msgspec.convert(value, tuple[str, DoubtKind]))
    if get_origin(kind) is not np.ndarray:
        raise NotImplementedError(f"a child cannot send a {kind}")
    name, shape, data = msgspec.convert(value, tuple[str, tuple[int, ...], bytes])
    (numbers,) = get_args(get_args(kind)[1])
    if not np.issubdtype(np.dtype(name), numbers):
        raise ValueError(f"an array is of {name}; expected {numbers.__name__}")
    array: NDArray[Any] = np.frombuffer(data, name).reshape(shape)
    return array


def _work_and_exit(work: Callable[[Tell], Any], limits: Limits, go: int) -> None:
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


def _try_work(work: Callable[[Tell], Any], tell: Tell) -> tuple[bytes, bytes]:
    try:
        return _ANSWER, msgspec.msgpack.encode(work(tell), enc_hook=_encode_special)
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
        if time.monotonic() >= end:
            raise ValueError(
                f"it was not done after {limits.patience:.0f} s: this machine is busy with other work; end some of it "
                "and try again"
            )
        if len(body) < size or kind not in (_PROGRESS, _ANSWER, _REFUSED):
            raise ValueError(exhausted)
        if kind == _REFUSED:
            raise ValueError(body.decode())
        if kind == _ANSWER:
            return body
        follow(*msgspec.msgpack.decode(body, type=tuple[float, str]))


def _read(come: int, size: int, end: float) -> bytes:
    """So many bytes, fewer where the child ends or is waited for too long."""
    parts = []
    left = size
    poll = select.poll()
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
    files = limits.files
    for number in sorted(int(descriptor.name) for descriptor in Path("/proc/self/fd").glob("*")):
        files += number < files  # the limit is of a descriptor's number: so many are free below it
    resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))
    if not limits.writes:
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
    if pages:
        most = pages * resource.getpagesize() + limits.memory
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
