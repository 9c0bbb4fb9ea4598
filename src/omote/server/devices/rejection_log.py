"""Says on the terminal what devices sent that was not obeyed: one line a second at most, however much comes."""

from __future__ import annotations

from collections.abc import Callable

REPORT_SECONDS = 1.0


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

    def tell(self, now: float) -> None:
        """Prints the newest, with the count of all, where the last line is a second ago."""
        if not self._count or now - self._reported < REPORT_SECONDS:
            return
        more = f" ({self._count} were rejected)" if self._count > 1 else ""
        self._report(f"{self._newest.rstrip('.')}{more}.")
        self._reported, self._count = now, 0
