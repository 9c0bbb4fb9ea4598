"""Detects a crash loop: servers that keep dying because of the state that they start from."""

from __future__ import annotations

import signal
from collections import deque

DEATHS = 3
WITHIN_SECONDS = 30.0
FROM_OUTSIDE = {-signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP}
"""Exit codes of servers that were ended from outside: no fault of the state."""


class CrashLoop:
    """Counts the crashes that a state may have caused; time is passed in."""

    def __init__(self) -> None:
        self._deaths: deque[float] = deque(maxlen=DEATHS)

    def record_end(self, now: float, code: int) -> None:
        """Records that a server ended; code: its exit status, or minus the signal that killed it.

        now: seconds, monotonic.
        """
        if code != 0 and code not in FROM_OUTSIDE:
            self._deaths.append(now)

    def record_hang(self, now: float) -> None:
        """Records that a server hung before its first tick and had to be killed."""
        self._deaths.append(now)

    def suspects_state(self, now: float) -> bool:
        """Whether the next server should start from neutral; if so, the count starts anew."""
        blamed = len(self._deaths) == DEATHS and now - self._deaths[0] <= WITHIN_SECONDS
        if blamed:
            self._deaths.clear()
        return blamed
