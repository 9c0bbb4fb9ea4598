"""Hears microphones of pages by WebSocket; their voices are played once a tick."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from itertools import count

import msgspec
from aiohttp import WSMsgType, web

from omote.inputs.microphone.microphone_input import MicrophoneInput
from omote.inputs.microphone.microphone_messages import LONGEST_MESSAGE, ToMicrophone
from omote.server.access.access_guard import visitor_in
from omote.server.devices.device_source import DeviceSource
from omote.server.links.links import HEARTBEAT, SENDER_BURST, SENDER_RATE, Link, Links, LinkSocket
from omote.show.session import ShowSession

TELL_SECONDS = 0.05
"""Between two words to a page about what is heard."""
WHO = "microphone"


class MicrophoneLink(DeviceSource):
    """The microphones of pages at one show. session: the one that plays; spoke: is told when sound has come."""

    def __init__(
        self,
        session: Callable[[], ShowSession],
        clock: Callable[[], float] = time.monotonic,
        spoke: Callable[[], None] = lambda: None,
    ) -> None:
        self.microphones = MicrophoneInput(session)
        self.links = Links(rate=SENDER_RATE, burst=SENDER_BURST)
        self._clock = clock
        self._spoke = spoke
        self._numbers = count(1)
        self._who: dict[str, str] = {}
        self._told = 0.0

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """Takes the sound of one page until it closes."""
        socket = LinkSocket(heartbeat=HEARTBEAT, limit=LONGEST_MESSAGE, refusal=_refuse)
        transport = await socket.accept(request)
        if transport is None:
            return socket
        link = self.links.open(socket, transport, visitor_in(request))
        who = self._who[link.who] = f"{WHO} {next(self._numbers)}"
        try:
            await self._listen(link, who)
        finally:
            self.links.close(link)
            del self._who[link.who]
            self.microphones.leave(who)
        return socket

    def hear(self, now: float) -> None:
        """Plays what has come since the last tick; pages are told now and then."""
        links = {who: link for link, who in self._who.items()}
        for who, rejected in self.microphones.play(now):
            if who in links:  # a page that has gone is told nothing while its mouth comes to rest
                self._answer(links[who], [rejected])
        if now - self._told >= TELL_SECONDS:
            self._told = now
            for who, link in links.items():
                if (voice := self.microphones.voice(who)) is not None:
                    self._answer(link, [voice])

    async def close(self) -> None:
        """Closes all links."""
        await self.links.close_all()

    async def _listen(self, link: Link, who: str) -> None:
        async for message in link.socket:
            await link.wait_turn(self._clock)
            if message.type is WSMsgType.BINARY:
                self._answer(link.who, self.microphones.hear(who, message.data, self._clock()))
                self._spoke()

    def _answer(self, link: str, messages: Iterable[ToMicrophone]) -> None:
        for message in messages:
            self.links.answer(link, msgspec.msgpack.encode(message))


def _refuse(reason: str) -> bytes:
    return msgspec.msgpack.encode({"type": "rejected", "reason": reason})
