"""Scheduling priority of processes: the show before other programs, where the system allows it."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

RAISED = -10
"""Well before ordinary programs, well behind what the system itself needs."""
LOWERED = 2
"""A little behind ordinary programs: a stage in a browser on this machine draws first, yet expressions come soon."""


def raise_priority() -> bool:
    """Raises the priority of this process and its children; False where that needs privileges that we lack."""
    try:
        os.setpriority(os.PRIO_PROCESS, 0, RAISED)
    except OSError:
        return False
    return True


def lower_priority() -> None:
    """Lowers the priority of this process and its children."""
    os.setpriority(os.PRIO_PROCESS, 0, LOWERED)


def waiting_seconds(pid: int) -> float:
    """Seconds that the main thread of a process has been ready and waited for a processor; 0 where the system does not
    tell (macOS), or there is no such process."""
    return _waited(Path(f"/proc/{pid}/schedstat"))


def others_waiting_seconds(pid: int) -> float:
    """Seconds that the other threads of a process have been ready and waited for a processor, in sum: one of them may
    hold what the main thread needs (the interpreter's lock), which then waits without being ready; 0 as above."""
    threads = Path(f"/proc/{pid}/task").glob("*/schedstat")
    return sum(_waited(each) for each in threads if each.parent.name != str(pid))


def _waited(schedstat: Path) -> float:
    with suppress(OSError, ValueError, IndexError):
        return int(schedstat.read_text().split()[1]) / 1e9
    return 0.0
