"""Keeps what one source does wrong from ending a tick: it is said, and the show goes on."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable
from contextlib import suppress

from omote.interchange.formats.error_reasons import explain_error
from omote.server.devices.device_source import DeviceSource
from omote.show.objects.state import State

AGAIN_SECONDS = 10.0
"""Between two reports of one source, which may fail in each tick."""


class GuardedSource(DeviceSource):
    """Another source, whose errors are reported. source: what is asked; report: tells the crew a sentence."""

    def __init__(self, source: DeviceSource, report: Callable[[str], None]) -> None:
        self.source = source
        self._report = report
        self._reported = -AGAIN_SECONDS

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick. now: seconds, monotonic."""
        self._ask(lambda: self.source.hear(now), now)

    def tell(self, state: State, now: float) -> None:
        """Tells its devices what is on air. state: the newest; now: seconds, monotonic."""
        self._ask(lambda: self.source.tell(state, now), now)

    def _ask(self, ask: Callable[[], None], now: float) -> None:
        try:
            ask()
        except Exception as error:
            if now - self._reported < AGAIN_SECONDS:
                return
            self._reported = now
            with suppress(OSError):
                sys.stderr.write(traceback.format_exc())
            name = type(self.source).__name__
            self._report(f"an input failed and is tried again ({name}: {explain_error(error)}); the show goes on.")
