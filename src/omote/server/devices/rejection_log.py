"""Says on the terminal what devices sent that was not obeyed: one line a second at most, however much comes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from omote.inputs.rejection import Rejection

REPORT_SECONDS = 1.0


class Rejects(Protocol):
    """What counts its rejections and keeps the newest."""

    @property
    def rejected(self) -> int:
        """How many."""

    @property
    def last_rejection(self) -> Rejection | None:
        """The newest; None before the first."""


class RejectionLog:
    """What was rejected since the last line, by all devices together; report: prints a sentence."""

    def __init__(self, report: Callable[[str], None]) -> None:
        self._report = report
        self._newest, self._count = "", 0
        self._reported = -REPORT_SECONDS
        self.total = 0

    def note(self, sentence: str, count: int = 1) -> None:
        """Notes so many rejections, of which the newest is told."""
        self._newest, self._count, self.total = sentence, self._count + count, self.total + count

    def note_new(self, rejects: Rejects, told: int, prefix: str = "") -> int:
        """Notes what was rejected after the first `told` of it; returns how much is noted now. prefix: of a sender."""
        new, newest = rejects.rejected - told, rejects.last_rejection
        if not new or newest is None:
            return told
        self.note(f"{prefix}{newest.sender}: {newest.reason}", new)
        return told + new

    def tell(self, now: float) -> None:
        """Prints the newest, with the count of all, where the last line is a second ago."""
        if not self._count or now - self._reported < REPORT_SECONDS:
            return
        more = f" ({self._count} were rejected)" if self._count > 1 else ""
        self._report(f"{self._newest.rstrip('.')}{more}.")
        self._reported, self._count = now, 0
