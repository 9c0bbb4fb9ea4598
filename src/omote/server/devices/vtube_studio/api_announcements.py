"""Hears where VTube Studio runs: it says so every two seconds over UDP, to all of its network."""

from __future__ import annotations

import socket
from dataclasses import dataclass

from omote.inputs.trackers.vtube_studio.api_message import ANNOUNCEMENT_PORT, Announcement, decode_announcement

LOST_SECONDS = 7.0
"""Three announcements that have not come."""
MOST_HEARD = 16
MOST_READ = 32
"""Programs that are remembered, and announcements of one look."""


@dataclass(frozen=True)
class _HeardAnnouncement:
    announcement: Announcement
    at: float


class ApiAnnouncements:
    """The programs in the network. Where another program has the port, none is found."""

    def __init__(self, port: int = ANNOUNCEMENT_PORT) -> None:
        self._heard: dict[tuple[str, int], _HeardAnnouncement] = {}
        self._socket: socket.socket | None = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # other plugins listen here too
        self._socket.setblocking(False)
        try:
            self._socket.bind(("", port))
        except OSError:
            self.close()

    @property
    def port(self) -> int:
        """Where it listens; 0 where that cannot be."""
        return 0 if self._socket is None else int(self._socket.getsockname()[1])

    def look(self, now: float) -> dict[tuple[str, int], Announcement]:
        """Those that have announced themselves of late, with their API on: by host and port."""
        for host, data in self._read():
            if (announcement := decode_announcement(data)) is not None:
                place = (host, announcement.port)
                self._heard.pop(place, None)
                self._heard[place] = _HeardAnnouncement(announcement, now)
        self._heard = dict(list(self._heard.items())[-MOST_HEARD:])
        fresh = {place: heard for place, heard in self._heard.items() if now - heard.at < LOST_SECONDS}
        return {place: heard.announcement for place, heard in fresh.items() if heard.announcement.active}

    def close(self) -> None:
        """Closes the socket."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def _read(self) -> list[tuple[str, bytes]]:
        datagrams: list[tuple[str, bytes]] = []
        while self._socket is not None and len(datagrams) < MOST_READ:
            try:
                data, (host, *_) = self._socket.recvfrom(4096)
            except OSError:
                break
            datagrams.append((str(host), data))
        return datagrams
