"""The gate before the show file: many threads use it at once, or one alone, who puts another file in its place."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

LONGEST_WAIT = 10.0
"""Seconds until whoever wants the file alone gives up: a disk that hangs holds the others."""


class FileGate:
    """A lock that is shared (`with gate:`) or exclusive (`with gate.alone():`); no thread enters it twice."""

    def __init__(self, *, longest_wait: float = LONGEST_WAIT) -> None:
        self._changed = threading.Condition()
        self._longest_wait = longest_wait
        self._users = 0
        self._closed = False

    def __enter__(self) -> None:
        with self._changed:
            self._changed.wait_for(lambda: not self._closed)
            self._users += 1

    def __exit__(self, *_: object) -> None:
        with self._changed:
            self._users -= 1
            self._changed.notify_all()

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Lets nobody else in until the end; TimeoutError where somebody does not come out."""
        with self._changed:
            self._changed.wait_for(lambda: not self._closed)
            self._closed = True
        try:
            with self._changed:
                if not self._changed.wait_for(lambda: self._users == 0, timeout=self._longest_wait):
                    raise TimeoutError("the disk does not answer")
            yield
        finally:
            with self._changed:
                self._closed = False
                self._changed.notify_all()
