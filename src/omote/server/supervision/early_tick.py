"""Says when a device has spoken, so that a tick comes early: what a hand does is on air at once."""

from __future__ import annotations

import asyncio
import socket


class EarlyTicks:
    """Waits for devices between two ticks. Datagrams are seen at their sockets, all else is noted by who hears it."""

    def __init__(self) -> None:
        self._sockets: list[socket.socket] = []
        self._spoke = asyncio.Event()

    def watch(self, datagrams: socket.socket) -> None:
        """Sees from now on when something comes to a socket, which the tick reads."""
        self._sockets.append(datagrams)

    def note(self) -> None:
        """Notes that a device has spoken by another way."""
        self._spoke.set()

    def forget(self) -> None:
        """Forgets what has been noted so far: it is on air."""
        self._spoke.clear()

    async def spoke_within(self, seconds: float) -> bool:
        """Whether a device has spoken since `forget`, or speaks within some seconds; returns as soon as one has."""
        loop = asyncio.get_running_loop()
        for datagrams in self._sockets:  # here alone: a socket that nobody reads would wake the loop again and again
            loop.add_reader(datagrams, self._spoke.set)
        try:
            async with asyncio.timeout(seconds):
                await self._spoke.wait()
        except TimeoutError:
            return False
        finally:
            for datagrams in self._sockets:
                loop.remove_reader(datagrams)
        return True
