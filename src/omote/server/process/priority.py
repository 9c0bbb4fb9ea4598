"""The show before everything else on the machine, where the system lets us."""

from __future__ import annotations

import os

RAISED = -10
"""Well before ordinary programs, well behind what the system itself needs."""
LOWERED = 2
"""A little behind ordinary programs: a stage in a browser on this machine draws first, yet expressions come soon."""


def raise_priority() -> bool:
    """Lets this process, and those it makes, run before others; False where that takes rights that we have not."""
    try:
        os.setpriority(os.PRIO_PROCESS, 0, RAISED)
    except OSError:
        return False
    return True


def lower_priority() -> None:
    """Lets this process, and those it makes, run after others."""
    os.setpriority(os.PRIO_PROCESS, 0, LOWERED)
