"""Says on the terminal what devices sent that was not obeyed: one line a second at most, however much comes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol
from weakref import WeakKeyDictionary

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
        self._newest = ""
        self._count = 0
        self._reported = -REPORT_SECONDS
        self.total = 0
        self._noted = WeakKeyDictionary[Rejects, int]()

    def note(self, sentence: str, count: int = 1) -> None:
        """Notes so many rejections (count), of which the newest is told by its sentence."""
        self._newest = sentence
        self._count = self._count + count
        self.total = self.total + count

    def note_new(self, rejects: Rejects, prefix: str = "") -> None:
        """Notes what was rejected since the last call. rejects: a device; prefix: what stands before its sender."""
        new = rejects.rejected - self._noted.get(rejects, 0)
        newest = rejects.last_rejection
        if new and newest is not None:
            self._noted[rejects] = rejects.rejected
            self.note(f"{prefix}{newest.sender}: {newest.reason}", new)

    def tell(self, now: float) -> None:
        """Prints the newest, with the count of all, where the last line is a second ago."""
        if not self._count or now - self._reported < REPORT_SECONDS:
            return
        more = f" ({self._count} were rejected)" if self._count > 1 else ""
        self._report(f"{self._newest.rstrip('.')}{more}.")
        self._reported = now
        self._count = 0
