"""Forks this process with everything it has loaded: a child starts in milliseconds and ends with its task."""

from __future__ import annotations

import os
import signal
import socket
import sys
import traceback
from collections.abc import Callable, Collection
from contextlib import suppress
from pathlib import Path

STANDARD = 3
"""Descriptors below are standard input, output and errors."""


def fork_process(work: Callable[[], None]) -> int:
    """Forks a child that calls `work` and exits, with status 1 if that raises; returns its process id."""
    pid = os.fork()
    if pid:
        return pid
    code = 1
    try:
        try:
            signal.set_wakeup_fd(-1)
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            work()
            code = 0
        except BaseException:
            traceback.print_exc()
        sys.stderr.flush()
    finally:
        # Not further up: what follows there belongs to the parent. A signal's handler may raise after any call, so none
        # comes before this one.
        os._exit(code)


def close_descriptors(keep: Collection[int]) -> None:
    """Closes every inherited descriptor but these and the standard ones, so that their readers see the end of file."""
    for descriptor in [int(entry.name) for entry in Path("/dev/fd").iterdir()]:
        if descriptor >= STANDARD and descriptor not in keep:
            with suppress(OSError):  # the one that listed the folder is closed already
                os.close(descriptor)


def fork_beside(work: Callable[[socket.socket], None]) -> tuple[int, socket.socket]:
    """Forks a child that does `work` with its end of a line and has no other descriptor; returns its process id and our
    end. OSError where no process can be made."""
    ours, theirs = socket.socketpair()

    def begin() -> None:
        close_descriptors([theirs.fileno()])
        work(theirs)

    try:
        return fork_process(begin), ours
    except OSError:
        ours.close()
        raise
    finally:
        theirs.close()
