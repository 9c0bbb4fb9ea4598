"""The aiohttp application of one show: pages, documents, and the WebSocket links."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Protocol

from aiohttp import WSCloseCode, WSMsgType, web

from omote.edit.protocol.messages import EDITING_PATH
from omote.edit.store.on_air_recipes import OnAir, read_on_air
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.cast_reload import CastReload
from omote.server.http.downloads import Downloads
from omote.server.http.editor_link import NO_FILE, EditorLinks
from omote.server.http.links import HEARTBEAT, Link, Links, LinkSocket
from omote.server.http.long_requests import LongRequests
from omote.server.http.security import add_headers, guard, silence_bad_requests
from omote.server.http.static_pages import PAGES, Page
from omote.server.http.uploads import RunFileJob, Uploads
from omote.server.persistence.authored_work import AuthoredWork
from omote.server.workers.workshop import FailedOrderError, RefusedOrderError
from omote.show.messages import LINK_PATH, MESSAGE_LIMIT, FromServer, Notice, Notices, Progress, Refused, State
from omote.show.session import KeepRequest, Outgoing, ShowSession
from omote.show.wire import encode

CACHE_FOREVER = "public, max-age=31536000, immutable"
NO_CACHE = "no-cache"
PAGE_CLOSED = (WSCloseCode.OK, WSCloseCode.GOING_AWAY)
"""How a browser ends the link of a page that is closed or loaded anew."""
MESSAGEPACK = "application/msgpack"

Clock = Callable[[], float]


class Source(Protocol):
    """What plays the show beside the pages; neither call waits, and both take a bounded time."""

    def hear(self, now: float) -> None:
        """Obeys what has come since the last tick."""

    def tell(self, state: State, now: float) -> None:
        """Tells its devices what is on air."""


class ShowServer:
    """Serves a show session: its WebSocket links, the cast's documents and the built pages."""

    def __init__(
        self,
        session: ShowSession,
        documents: CastDocuments,
        pages: Mapping[str, Page],
        *,
        clock: Clock = time.monotonic,
    ) -> None:
        self.session, self.documents, self.links, self.clock = session, documents, Links(), clock
        self.editing: EditorLinks | None = None
        self.downloads: Downloads | None = None
        self.uploads: Uploads | None = None
        self.long_requests = LongRequests(self._send_progress)
        self.sources: list[Source] = []
        self._pages = pages
        self._state: State | None = None

    def enable_editing(
        self,
        authored_work: AuthoredWork | None,
        reopen: Callable[[], AuthoredWork | None],
        report: Callable[[str], None],
    ) -> None:
        """Adds the editors' link; to be called before `application`."""
        self.editing = EditorLinks(
            authored_work,
            self.documents,
            CastReload(self.session, self.documents, report),
            reopen=reopen,
            on_air=self.on_air,
            tell=lambda who, message: self.links.answer(who, encode(message)),
            announce=self.announce,
            report=report,
            notices=lambda: self.session.notices,
            post_layouts=self.post_layouts,
            cancel=self.long_requests.cancel,
            clock=self.clock,
        )
        self.session.layouts = self.editing.layout_names()

    def enable_files(self, show: Callable[[], Path], run_job: RunFileJob) -> None:
        """Adds imports and exports; show: where the show file lies; run_job: does a `FileJob`."""
        self.downloads = Downloads(show, run_job, self.long_requests)
        self.uploads = Uploads(show, run_job, self.long_requests)

    def on_air(self) -> OnAir:
        """What is on air now; `coming` includes what was called since the last tick."""
        found, (faces, expressions) = read_on_air(self._state) if self._state else OnAir(), self.session.names_held()
        return replace(found, coming=found.coming | faces | expressions)

    def application(self, names: frozenset[str]) -> web.Application:
        """Builds the aiohttp application; `names` are the host names it answers to, beside numeric addresses."""
        silence_bad_requests()
        application = web.Application(middlewares=[guard(names)], client_max_size=MESSAGE_LIMIT)
        application.on_response_prepare.append(add_headers)
        application.router.add_get(LINK_PATH, self.link)
        if self.editing is not None:
            application.router.add_get(EDITING_PATH, self.editing.link)
        application.router.add_get("/layouts/{name}", self.layout)
        application.router.add_get("/exports/{file}", self.export)
        application.router.add_post("/imports/{file}", self.take_in)
        application.router.add_get("/manifest", self.manifest)
        application.router.add_get("/assets/{name}", self.asset)
        application.router.add_get("/compounds/{base}/{face}/{expression}", self.compound)
        application.router.add_get("/tangents/{base}/{face}", self.tangents)
        application.router.add_get("/handles", self.handles)
        application.router.add_get("/contents/{key}", self.content)
        for path in (*PAGES, "/{page:.+}"):
            application.router.add_get(path, self.page)
        return application

    def tick(self) -> None:
        """Advances the session by one tick and broadcasts the state."""
        now = self.clock()
        for source in self.sources:
            source.hear(now)
        state = self._state = self.session.tick(now)
        self.links.broadcast(encode(state), now)
        for source in self.sources:
            source.tell(state, now)
        self.documents.set_on_air(state)
        self._deliver(self.session.hands_now(now))

    def broadcast_crew(self) -> None:
        """Broadcasts who is connected."""
        now = self.clock()
        self.announce(self.session.crew_now(now))

    def post(self, notices: list[Notice]) -> None:
        """Sends all notices to consoles and editors; later ones get them with their welcome."""
        self.session.notices = notices
        self.broadcast_notices()

    def broadcast_notices(self) -> None:
        """Broadcasts the notices to consoles and editors, where there are any."""
        for who in self.session.crew:
            self._deliver(self.session.notices_for(who))
        if self.editing is not None and self.session.notices:
            self.editing.send_news(Notices(self.session.notices))

    def post_layouts(self, names: list[str]) -> None:
        """Tells all consoles the names of the layouts; later ones get them with their welcome."""
        self.session.layouts = names
        self._deliver(self.session.layouts_now())

    def announce(self, message: FromServer) -> None:
        """Sends one message to every link."""
        data = encode(message)
        for link in self.links:
            self.links.answer(link.who, data)

    async def close_all(self) -> None:
        """Closes every link; pages then know that the server is going."""
        await asyncio.gather(self.links.close_all(), *([self.editing.close()] if self.editing else []))

    async def link(self, request: web.Request) -> web.WebSocketResponse:
        """Handles one page's WebSocket link until it closes."""
        ws = LinkSocket(heartbeat=HEARTBEAT)
        transport = await ws.accept(request)
        if transport is None:
            return ws
        link = self.links.open(ws, transport)
        try:
            await self._listen(link)
        finally:
            self.links.close(link)
            self.session.leave(link.who, lost=None if ws.close_code in PAGE_CLOSED else self.clock())
        return ws

    async def manifest(self, request: web.Request) -> web.Response:
        """Responds with the manifest of the cast."""
        tag = f'"{self.documents.playing.digest}"'
        headers = {"Cache-Control": NO_CACHE, "ETag": tag}
        if request.headers.get("If-None-Match") == tag:
            return web.Response(status=304, headers=headers)
        return web.Response(body=await self.documents.manifest(), content_type=MESSAGEPACK, headers=headers)

    async def asset(self, request: web.Request) -> web.Response:
        """Responds with a face, a hair style or the mask picture, by the digest of its content."""
        kept = {"Cache-Control": CACHE_FOREVER}
        if request.path == self.documents.mask_url:
            return web.Response(body=self.documents.mask, content_type="image/png", headers=kept)
        data = self.documents.assets.get(request.path)
        if data is None:
            raise web.HTTPNotFound(text="there is no such asset in this cast: load /manifest again.")
        return web.Response(body=data, content_type=MESSAGEPACK, headers=kept)

    async def compound(self, request: web.Request) -> web.Response:
        """Responds with the compound of a face and an expression, by their sources."""
        names = request.match_info
        return await self._respond_computed(
            request, lambda: self.documents.compound(names["face"], names["expression"])
        )

    async def tangents(self, request: web.Request) -> web.Response:
        """Responds with the tangents of a face (its derivative with respect to a field), by its source."""
        return await self._respond_computed(request, lambda: self.documents.tangents(request.match_info["face"]))

    async def handles(self, request: web.Request) -> web.Response:
        """Responds with the handles of the face editor."""
        return await self._respond_computed(request, self.documents.handles, keep=NO_CACHE)

    async def content(self, request: web.Request) -> web.Response:
        """Responds with an authored face, by the key of its content."""
        return await self._respond_computed(request, lambda: self.documents.face(request.match_info["key"]))

    async def _respond_computed(
        self, request: web.Request, make: Callable[[], Awaitable[bytes]], keep: str = CACHE_FOREVER
    ) -> web.Response:
        """Responds with what `make` computes; by default cacheable for ever, for the address names the content."""
        if request.match_info.get("base", self.documents.cast.digest) != self.documents.cast.digest:
            raise web.HTTPNotFound(text="the cast has changed: load /manifest again.")
        try:
            data = await make()
        except KeyError as error:
            raise web.HTTPNotFound(text=f"there is no {str(error)[:80]} in this cast: load /manifest again.") from error
        except RefusedOrderError as error:
            raise web.HTTPNotFound(text=f"{error}.") from error
        except FailedOrderError as error:
            raise web.HTTPServiceUnavailable(text=f"{error}.") from error
        return web.Response(body=data, content_type=MESSAGEPACK, headers={"Cache-Control": keep})

    async def layout(self, request: web.Request) -> web.Response:
        """Responds with a page's stored layout; 204 where there is none, for browsers log a 404 as an error."""
        found = None if self.editing is None else self.editing.layout(request.match_info["name"])
        if found is None:
            return web.Response(status=204, headers={"Cache-Control": NO_CACHE})
        return web.Response(body=found, content_type="application/json", headers={"Cache-Control": NO_CACHE})

    async def export(self, request: web.Request) -> web.Response:
        """Responds with an export as a file to keep: an expression (.json), a face with expressions (.glb)."""
        if self.downloads is None:
            raise web.HTTPServiceUnavailable(text=f"nothing can be exported: {NO_FILE}")
        return await self.downloads.respond(request, self.documents.playing)

    async def take_in(self, request: web.Request) -> web.Response:
        """Takes in a file that a page sends, as expressions or a face (`?as=face`); responds with what it was."""
        if self.uploads is None or self.editing is None:
            raise web.HTTPServiceUnavailable(text=f"nothing can be taken in: {NO_FILE}")
        return await self.uploads.respond(request, self.editing.take_in)

    async def page(self, request: web.Request) -> web.Response:
        """Responds with a built page or one of its files."""
        page = self._pages.get(request.path)
        if page is None:
            raise web.HTTPNotFound(
                text="there is no such page; the stage is at /stage, the console at /console, the editor at /editor."
            )
        keep = CACHE_FOREVER if page.immutable else NO_CACHE
        return web.Response(body=page.body, content_type=page.content_type, headers={"Cache-Control": keep})

    async def _listen(self, link: Link) -> None:
        async for message in link.socket:
            await link.wait_turn(self.clock)
            if message.type is WSMsgType.BINARY:
                self._deliver(self.session.receive_bytes(link.who, message.data, self.clock()))
                self._keep(self.session.take_keep_requests())
                for each in self.session.take_cancelled():
                    self.long_requests.cancel(each)
            elif message.type is WSMsgType.TEXT:
                reason = "text came, but messages are binary MessagePack."
                self._deliver([Outgoing(link.who, Refused(reason))])

    def _keep(self, requests: list[KeepRequest]) -> None:
        for request in requests:
            if self.editing is None:
                self._deliver([Outgoing(request.who, Refused(NO_FILE))])
            else:
                self.editing.request_keep(request)

    def _send_progress(self, progress: Progress) -> None:
        self._deliver(self.session.for_consoles(progress))
        if self.editing is not None:
            self.editing.send_news(progress)

    def _deliver(self, outgoing: list[Outgoing]) -> None:
        for each in outgoing:
            self.links.answer(each.who, encode(each.message))
