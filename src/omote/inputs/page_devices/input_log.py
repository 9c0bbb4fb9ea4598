"""The log of inputs: what came from which source, and why something was rejected; bounded, however much comes."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping

import msgspec

from omote.show.objects.devices import InputLine

MOST_LINES = 200
AGAIN_SECONDS = 1.0
"""Seconds in which the same counts as one line."""
LINES_A_SECOND = 4
"""New lines of one source within a second; more are counted in its newest line of the same kind."""
OTHERS = ", among others"
"""Behind the newest in a line that counts other things too."""
MOST_SOURCES = 64
LONGEST_LINE = 300


class LineLog:
    """Lines of all sources, oldest first. started: the time since 1970 at the show's clock 0."""

    def __init__(self, started: float = 0.0) -> None:
        self._started = started
        self._lines: deque[InputLine] = deque(maxlen=MOST_LINES)
        self._newest: dict[tuple[str, bool], tuple[float, int]] = {}
        self._followed: dict[tuple[str, str], int] = {}
        self.number = 0

    @property
    def lines(self) -> list[InputLine]:
        """The lines as they are now."""
        return list(self._lines)

    def note(self, source: str, text: str, now: float, *, rejected: bool = False, count: int = 1) -> None:
        """Notes what came, or why it was rejected; count: how often; source: where it came from; text: it, or the
        reason; now: seconds of the show's clock."""
        text = text[:LONGEST_LINE]
        begun, made = self._newest.get((source, rejected), (now, 0))
        begun, made = (now, 0) if now - begun >= AGAIN_SECONDS else (begun, made)
        for place in _newest_first(len(self._lines)):
            line = self._lines[place]
            if self._started + now - line.time >= AGAIN_SECONDS:
                break
            alike = (line.source, line.rejected) == (source, rejected)
            if alike and (line.text == text or made >= LINES_A_SECOND):
                self._lines[place] = InputLine(
                    line.number,
                    line.time,
                    source,
                    text if line.text == text else f"{text}{OTHERS}",
                    rejected,
                    line.count + count,
                )
                self.number += 1
                return
        self._newest[source, rejected] = begun, made + 1
        if len(self._newest) > 2 * MOST_SOURCES:
            del self._newest[next(iter(self._newest))]
        self.number += 1
        self._lines.append(InputLine(self.number, self._started + now, source, text, rejected, count))

    def follow(self, source: str, text: str, now: float, *, count: int, rate: float, bars: Mapping[str, float]) -> None:
        """Notes what comes without end, as a face does: one line, the newest, until nothing comes for a second. rate:
        of it, a second; bars: what moves, and where it stands; source: where it came from; text: whose it is; now:
        seconds of the show's clock; count: how many came since the last."""
        text = text[:LONGEST_LINE]
        self.number = self.number + 1
        line = InputLine(self.number, self._started + now, source, text, False, count, rate, dict(bars))
        for place in _newest_first(len(self._lines)):
            before = self._lines[place]
            if line.time - before.time >= AGAIN_SECONDS:
                break
            if before.number == self._followed.get((source, text)):
                del self._lines[place]
                line = msgspec.structs.replace(line, number=before.number, count=before.count + count)
                break
        self._followed[source, text] = line.number
        if len(self._followed) > MOST_SOURCES:
            del self._followed[next(iter(self._followed))]
        self._lines.append(line)


def _newest_first(count: int) -> Iterable[int]:
    """The places of the newest lines, of which alone one can be within a second."""
    return range(count - 1, max(-1, count - 1 - 4 * LINES_A_SECOND), -1)
