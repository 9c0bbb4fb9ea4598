"""The web server of one show: pages, documents, and the link."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

from aiohttp import WSMsgType, web

from omote.server.bundle import PAGES, Page
from omote.server.library import Library
from omote.server.links import Link, Links, LinkSocket
from omote.server.security import add_headers, guard, mute_strangers
from omote.server.workshop import FailedOrderError
from omote.show.messages import LINK_PATH, MESSAGE_LIMIT, Refused
from omote.show.session import Outgoing, ShowSession
from omote.show.wire import encode

HEARTBEAT = 8.0
"""Seconds of silence after which a link is asked whether it lives; it has half as long to answer."""
FOR_EVER = "public, max-age=31536000, immutable"
ALWAYS_ASK = "no-cache"
MESSAGEPACK = "application/msgpack"

Clock = Callable[[], float]


class ShowServer:
    """A session with its links, its documents and its pages."""

    def __init__(
        self, session: ShowSession, library: Library, pages: Mapping[str, Page], *, clock: Clock = time.monotonic
    ) -> None:
        self.session, self.library, self.links, self.clock = session, library, Links(), clock
        self._pages = pages

    def application(self, names: frozenset[str]) -> web.Application:
        """The aiohttp application; `names` are the hosts it answers to, beside addresses in figures."""
        mute_strangers()
        application = web.Application(middlewares=[guard(names)], client_max_size=MESSAGE_LIMIT)
        application.on_response_prepare.append(add_headers)
        application.router.add_get(LINK_PATH, self.link)
        application.router.add_get("/manifest", self.manifest)
        application.router.add_get("/assets/{name}", self.asset)
        application.router.add_get("/compounds/{digest}/{face}/{expression}", self.compound)
        for path in (*PAGES, "/{page:.+}"):
            application.router.add_get(path, self.page)
        return application

    def tick(self) -> None:
        """One state for everybody."""
        now = self.clock()
        state = self.session.tick(now)
        self.links.broadcast(encode(state), now)
        self.library.serve(state)

    def call_the_roll(self) -> None:
        """Tells everybody who is connected."""
        now = self.clock()
        crew = encode(self.session.crew_now(now))
        for link in self.links:
            self.links.answer(link.who, crew)

    async def link(self, request: web.Request) -> web.WebSocketResponse:
        """A browser's link, from its first byte to its last."""
        ws = LinkSocket(heartbeat=HEARTBEAT)
        try:
            await ws.prepare(request)
        except ConnectionResetError:  # gone before it was let in
            return ws
        if request.transport is None:
            return ws
        link = self.links.open(ws, request.transport)
        try:
            await self._listen(link)
        finally:
            self.links.close(link)
            self.session.leave(link.who)
        return ws

    async def manifest(self, request: web.Request) -> web.Response:
        """What the cast is made of."""
        tag = f'"{self.library.cast.digest}"'
        headers = {"Cache-Control": ALWAYS_ASK, "ETag": tag}
        if request.headers.get("If-None-Match") == tag:
            return web.Response(status=304, headers=headers)
        return web.Response(body=self.library.manifest, content_type=MESSAGEPACK, headers=headers)

    async def asset(self, request: web.Request) -> web.Response:
        """A face, or the mask, by the name of its content."""
        kept = {"Cache-Control": FOR_EVER}
        if request.path == self.library.mask_url:
            return web.Response(body=self.library.mask, content_type="image/png", headers=kept)
        data = self.library.assets.get(request.path)
        if data is None:
            raise web.HTTPNotFound(text="there is no such asset in this cast: load /manifest again.")
        return web.Response(body=data, content_type=MESSAGEPACK, headers=kept)

    async def compound(self, request: web.Request) -> web.Response:
        """A face wearing an expression."""
        if request.match_info["digest"] != self.library.cast.digest:
            raise web.HTTPNotFound(text="the cast has changed: load /manifest again.")
        try:
            data = await self.library.compound(request.match_info["face"], request.match_info["expression"])
        except KeyError as error:
            raise web.HTTPNotFound(text=f"there is no {str(error)[:80]} in this cast: load /manifest again.") from error
        except FailedOrderError as error:
            raise web.HTTPServiceUnavailable(text=f"{error}.") from error
        return web.Response(body=data, content_type=MESSAGEPACK, headers={"Cache-Control": FOR_EVER})

    async def page(self, request: web.Request) -> web.Response:
        """A page, or one of its files."""
        page = self._pages.get(request.path)
        if page is None:
            raise web.HTTPNotFound(text="there is no such page; the stage is at /stage, the console at /console, the editor at /editor.")
        keep = FOR_EVER if page.immutable else ALWAYS_ASK
        return web.Response(body=page.body, content_type=page.content_type, headers={"Cache-Control": keep})

    async def _listen(self, link: Link) -> None:
        async for message in link.socket:
            await link.turn(self.clock)
            if message.type is WSMsgType.BINARY:
                self._deliver(self.session.hear(link.who, message.data, self.clock()))
            elif message.type is WSMsgType.TEXT:
                reason = "text came, but messages are binary MessagePack."
                self._deliver([Outgoing(link.who, Refused(reason))])

    def _deliver(self, outgoing: list[Outgoing]) -> None:
        for each in outgoing:
            self.links.answer(each.who, encode(each.message))
