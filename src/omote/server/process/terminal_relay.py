"""Standard output and errors that never make a writer wait: a pipe before each, and threads that carry it on.

A terminal that is not read (Ctrl-S, a frozen window, a full pipe) blocks `write()`; one that is gone fails it. What a
show, its supervisor and their libraries write goes into pipes that are always read; what waits for the terminal is
bounded, and the oldest of it goes first.
"""

from __future__ import annotations

import os
import selectors
import sys
import threading
from collections import deque
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress

MOST_WAITING = 1 << 18
"""Bytes that wait for a terminal: some three thousand lines."""
CHUNK = 1 << 16
"""Bytes that are read or written at once: a pipe holds no more."""
FLUSH_SECONDS = 0.5
"""How long a command that ends waits for its terminal."""
LOST = "\nomote: {} bytes were not shown: nobody read this terminal.\n"
OUTPUT = 1
ERRORS = 2


class WaitingOutput:
    """What waits for one terminal or file, in the order in which it came."""

    def __init__(self) -> None:
        self._chunks = deque[bytes]()
        self._size = 0
        self._lost = 0
        self._writing = False
        self._closed = False
        self._changed = threading.Condition()

    def add(self, data: bytes) -> None:
        """Adds what was written; never waits, and drops the oldest where too much waits."""
        with self._changed:
            self._chunks.append(data)
            self._size += len(data)
            while self._size > MOST_WAITING:
                oldest = self._chunks.popleft()
                self._size -= len(oldest)
                self._lost += len(oldest)
            self._changed.notify_all()

    def close(self) -> None:
        """Ends it: nothing more comes."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def take(self) -> bytes | None:
        """Waits for what is to be written next; None at the end."""
        with self._changed:
            self._writing = False
            self._changed.notify_all()
            self._changed.wait_for(lambda: self._chunks or self._closed)
            if not self._chunks:
                return None
            self._writing = True
            lost = LOST.format(self._lost).encode() if self._lost else b""
            data = lost + b"".join(self._chunks)
            self._lost = self._size = 0
            self._chunks.clear()
            return data

    def wait_until_written(self, seconds: float) -> None:
        """Waits until all is written, but no longer than some seconds."""
        with self._changed:
            self._changed.wait_for(lambda: not self._chunks and not self._writing, seconds)


@contextmanager
def relay_terminal() -> Iterator[None]:
    """Lets everything that this process, and those that it starts, write to standard output and errors go through
    pipes; at the end, both are as before.

    Output and errors that go to one place keep their order.
    """
    flush_standard()
    targets = {number: os.dup(number) for number in (OUTPUT, ERRORS)}
    one_place = os.path.sameopenfile(OUTPUT, ERRORS)
    pipes = {OUTPUT: os.pipe()}
    pipes[ERRORS] = pipes[OUTPUT] if one_place else os.pipe()
    waiting = {pipes[number][0]: (targets[number], WaitingOutput()) for number in (OUTPUT, ERRORS)}
    reader = threading.Thread(target=_read, args=(waiting,), daemon=True)
    writers = [threading.Thread(target=_write, args=pair, daemon=True) for pair in waiting.values()]
    for number, (_, entrance) in pipes.items():
        os.dup2(entrance, number)
    for entrance in {entrance for _, entrance in pipes.values()}:
        os.close(entrance)
    for thread in (reader, *writers):
        thread.start()
    try:
        yield
    finally:
        flush_standard()
        for number, target in targets.items():
            os.dup2(target, number)
        # Others that still write keep the reader: it is not waited for longer than a terminal that is read needs.
        reader.join(FLUSH_SECONDS)
        for _, output in waiting.values():
            output.wait_until_written(FLUSH_SECONDS)


def flush_standard() -> None:
    """Empties the buffers of standard output and errors; ignores that nobody reads them any more."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()


def _read(waiting: Mapping[int, tuple[int, WaitingOutput]]) -> None:
    """Carries what comes through pipes to what waits, until nobody can write any more."""
    with selectors.DefaultSelector() as selector:
        for exit_, (_, output) in waiting.items():
            selector.register(exit_, selectors.EVENT_READ, output)
        while selector.get_map():
            for key, _ in selector.select():
                data = os.read(key.fd, CHUNK)
                if data:
                    key.data.add(data)
                else:
                    selector.unregister(key.fd)
                    os.close(key.fd)
                    key.data.close()


def _write(target: int, output: WaitingOutput) -> None:
    """Writes what waits, as fast as its reader takes it; what a terminal that is gone does not take is lost."""
    while (data := output.take()) is not None:
        with suppress(OSError):
            while data:
                data = data[os.write(target, data) :]
    os.close(target)
