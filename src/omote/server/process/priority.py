"""Scheduling priority of processes: the show before other programs, where the system allows it."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

RAISED = -10
"""Well before ordinary programs, well behind what the system itself needs."""
AUTOGROUP = Path("/proc/self/autogroup")
"""The niceness of this session beside others (`sched(7)`)."""
LOWERED = 2
"""A little behind ordinary programs: a stage in a browser on this machine draws first, yet expressions come soon."""


def raise_priority(*, leads_session: bool = False) -> bool:
    """Raises the priority of this process and its children; False where that needs privileges that we lack.

    leads_session: whether it has a session of its own, whose share of the processors rises too. Linux divides them
    among sessions first (`sched_autogroup`): a process goes first within its own alone.
    """
    try:
        os.setpriority(os.PRIO_PROCESS, 0, RAISED)
        if leads_session:
            _set_session_priority(RAISED)
    except OSError:
        return False
    return True


def lower_priority(*, leaves_session: bool = False) -> None:
    """Lowers the priority of this process and its children.

    leaves_session: in a session of their own, for that of the show goes before other programs, and they do not.
    """
    os.setpriority(os.PRIO_PROCESS, 0, LOWERED)
    if leaves_session:
        with suppress(OSError):  # it leads one already
            os.setsid()
        with suppress(OSError):
            _set_session_priority(LOWERED)


def _set_session_priority(niceness: int) -> None:
    """Sets the share of this process's session; nothing where the system has no such shares. OSError without rights."""
    if AUTOGROUP.exists():
        AUTOGROUP.write_text(str(niceness))


def waiting_seconds(pid: int) -> float:
    """Seconds that the main thread of a process has been ready and waited for a processor; 0 where the system does not
    tell (macOS), or there is no such process."""
    return _waited(Path(f"/proc/{pid}/schedstat"))


def others_waiting_seconds(pid: int) -> float:
    """Seconds that the other threads of a process have been ready and waited for a processor, in sum: one of them may
    hold what the main thread needs (the interpreter's lock), which then waits without being ready; 0 as above."""
    threads = Path(f"/proc/{pid}/task").glob("*/schedstat")
    return sum(_waited(thread) for thread in threads if thread.parent.name != str(pid))


def _waited(schedstat: Path) -> float:
    with suppress(OSError, ValueError, IndexError):
        return int(schedstat.read_text().split()[1]) / 1e9
    return 0.0
