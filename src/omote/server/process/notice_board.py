"""What the crew of a show must know: sentences that stay on consoles and editors until they are dismissed."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterable
from typing import Protocol

from omote.show.objects.link import Notice

MOST_NOTICES = 16
"""The newest of a show; older ones have been seen, or nobody is there."""
LONGEST_NOTICE = 400
"""Characters: a notice goes through a pipe at once, whole."""

Report = Callable[[str], None]


class CrewReport(Protocol):
    """Reports a sentence; solves: the one about what is well again, which goes."""

    def __call__(self, sentence: str, solves: str = "") -> None:
        """Reports it."""


class NoticeBoard:
    """Collects notices, from any thread; notices: what was posted before, in this show.

    The same sentence again takes the place of the former.
    """

    def __init__(self, notices: Iterable[Notice] = (), *, clock: Callable[[], int] = time.time_ns) -> None:
        self._notices = list(notices)
        self._new = list[Notice]()
        self._lock = threading.Lock()
        self._clock = clock
        self._last = 0

    @property
    def notices(self) -> list[Notice]:
        """All notices, oldest first."""
        with self._lock:
            return list(self._notices)

    def post(self, sentence: str, solves: str = "") -> None:
        """Adds a sentence for the crew. solves: the sentence about what is well again, which goes."""
        text = _text_of(sentence)
        gone = {text, _text_of(solves)}
        with self._lock:
            self._last = max(self._last + 1, self._clock())
            notice = Notice(str(self._last), self._last / 1e9, text, solves != "")
            others = [older for older in self._notices if older.text not in gone]
            self._notices = [*others, notice][-MOST_NOTICES:]
            self._new.append(notice)

    def take_new(self) -> list[Notice]:
        """Returns what was posted since the last call."""
        if not self._new:  # sixty times a second
            return []
        with self._lock:
            new = self._new
            self._new = []
            return new

    def with_report(self, report: Report) -> CrewReport:
        """A function that reports a sentence to the operator's terminal, and posts it for the crew."""

        def tell(sentence: str, solves: str = "") -> None:
            report(sentence)
            self.post(sentence, solves)

        return tell


def _text_of(sentence: str) -> str:
    return sentence[:1].upper() + sentence[1:LONGEST_NOTICE]
