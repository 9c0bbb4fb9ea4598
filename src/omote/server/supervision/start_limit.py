"""The start limit: how often a show that has never played is started again, and how long to wait between tries.

As in systemd: a number of failed starts ends it, and one whose exit status says that another would end alike does so at
once. A show that has played is never given up.
"""

from __future__ import annotations

from dataclasses import dataclass

from omote.server.process.process_messages import REJECTED

FAILURES = 6
"""Standbys that end before they are ready, and servers that die before their first tick, until the show is given up."""
PAUSE_SECONDS = 2.0
"""Pause before another try when a standby, or a server that never ticked, died."""
LONGEST_PAUSE_SECONDS = 64.0
"""Pause at most before another standby beside a server that plays: twice as long with each that never got ready."""


@dataclass(eq=False)
class StartLimit:
    """What became of the processes of one show.

    played: whether a server has ever ticked; rejected: whether a standby has said that it cannot start; failures since
    a server last ticked; unready: standbys in a row that never got ready.
    """

    played: bool = False
    rejected: bool = False
    failures: int = 0
    unready: int = 0

    @property
    def reached(self) -> bool:
        """Whether to give up."""
        return not self.played and (self.rejected or self.failures >= FAILURES)

    def record_play(self) -> bool:
        """A server ticked for the first time; says whether none had before it."""
        first = not self.played
        self.played = True
        self.failures = 0
        return first

    def record_server(self) -> float:
        """A server died before its first tick; seconds to wait before the next."""
        self.failures += 1  # trying again and again at once would help nobody
        return PAUSE_SECONDS if self.failures >= FAILURES else 0.0

    def record_standby(self, status: int, *, ready: bool, plays: bool) -> float:
        """A standby ended with an exit status; ready: whether it ever was; plays: whether a server does now.

        Seconds to wait before the next one.
        """
        self.unready = 0 if ready else self.unready + 1
        if ready:
            return 0.0
        if not self.played:
            self.failures += 1  # no server can come of it
            self.rejected = status == REJECTED
            return 0.0
        return min(PAUSE_SECONDS * 2.0 ** min(self.unready - 1, 10), LONGEST_PAUSE_SECONDS if plays else PAUSE_SECONDS)
