"""The aiohttp application of one show: pages, documents, and the WebSocket links."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Protocol

import msgspec
from aiohttp import WSCloseCode, WSMsgType, web

from omote.edit.protocol.messages import EDITING_PATH
from omote.edit.store.on_air_recipes import OnAir, read_on_air
from omote.perform.snapshot import Playable
from omote.server.access.access_control import AccessControl
from omote.server.access.access_guard import guard_access, visitor_in
from omote.server.access.people_routes import PeopleRoutes
from omote.server.access.phone_page import PHONE_PATH, PhonePage
from omote.server.access.security import adding_headers, guard, silence_bad_requests
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.cast_reload import CastReload
from omote.server.http.clip_store import ClipStore
from omote.server.http.cue_routes import CueRoutes
from omote.server.http.document_routes import CACHE_FOREVER, NO_CACHE, DocumentRoutes
from omote.server.http.downloads import Downloads
from omote.server.http.editor_link import NO_FILE, EditorLinks
from omote.server.http.long_requests import LongRequests
from omote.server.http.oscquery import OscQuery
from omote.server.http.recording_routes import RecordingRoutes
from omote.server.http.run_routes import RunRoutes
from omote.server.http.static_pages import PAGES, Page
from omote.server.http.touchosc import TOUCHOSC_PATH, TouchoscLayout
from omote.server.http.uploads import RunFileJob, Uploads
from omote.server.links.links import HEARTBEAT, Link, Links, LinkSocket, close_revoked
from omote.server.persistence.authored_work import AuthoredWork
from omote.server.sounds.sound_routes import Sounds
from omote.server.sounds.sound_store import SoundStore
from omote.server.sounds.voice_routes import Voices
from omote.server.workers.file_jobs import BuildTouchoscLayout, run_file_job
from omote.show.declaration import MESSAGE_LIMIT, SPEECH_LIMIT, KeepRequest, Outgoing, ServerMessage
from omote.show.messages import LINK_PATH
from omote.show.objects.devices import Devices
from omote.show.objects.documents import NAMES_OF, address_of
from omote.show.objects.link import Notice, Notices, Progress, Refused
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.wire import encode

PAGE_CLOSED = (WSCloseCode.OK, WSCloseCode.GOING_AWAY)
"""How a browser ends the link of a page that is closed or loaded anew."""

Respond = Callable[[web.Request], Awaitable[web.StreamResponse]]


class TickSource(Protocol):
    """What plays the show beside the pages; neither call waits, and both take a bounded time."""

    def hear(self, now: float) -> None:
        """Obeys what has come since the last tick."""

    def tell(self, state: State, now: float) -> None:
        """Tells its devices what is on air. state: the newest; now: seconds, monotonic."""


class ShowServer:
    """Serves a show session: its links, the cast's documents and the built pages. outside: its address for others."""

    def __init__(
        self,
        session: ShowSession,
        documents: CastDocuments,
        pages: Mapping[str, Page],
        *,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.session = session
        self.documents = documents
        self.links = Links()
        self.clock = clock
        self.editing: EditorLinks | None = None
        self.downloads: Downloads | None = None
        self.uploads: Uploads | None = None
        self._run_job: RunFileJob | None = None
        self.voices: Voices | None = None
        self.long_requests = LongRequests(self._send_progress)
        self.sources: list[TickSource] = []
        self.device_spoke: Callable[[], None] = lambda: None
        self.oscquery: OscQuery | None = None
        self._heard: dict[str, Respond] = {}
        self._sending: list[Links] = []
        self.more_routes: list[Callable[[web.Application], None]] = []
        self._describe_devices: Callable[[], Devices] = lambda: Devices([])
        self._surface_allowed: Callable[[str], bool] = lambda _: False
        self.access: AccessControl | None = None
        self.authority: bytes | None = None
        self.embedders: tuple[str, ...] = ()
        self.tell_frame: Callable[[str], None] = lambda _: None
        self.tell_crew: Callable[[str], None] = lambda _: None
        self._pages = pages
        self._cues = CueRoutes(session)
        self.runs = RunRoutes(lambda: self.clock())
        self.recording = RecordingRoutes(session, documents, lambda: self.clock(), self._deliver, self.runs)
        self._clips = ClipStore(session)
        self.sound_store = SoundStore(session)
        self.sounds = Sounds(session.set_sounds, self.sound_store.find, self.sound_store)
        self.outside = ""
        self._state: State | None = None

    def enable_editing(
        self,
        authored_work: AuthoredWork | None,
        reopen: Callable[[], AuthoredWork | None],
        report: Callable[[str], None],
    ) -> None:
        """Adds the editors' link; to be called before `application`.

        authored_work: of the show file, None where it cannot be read; reopen: reads it again; report: tells the
        operator.
        """
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
            list_documents=lambda kind, names: self._deliver(self.session.list_documents(kind, names)),
            cancel=self.long_requests.cancel,
            clock=self.clock,
        )
        for kind in NAMES_OF:
            self.session.list_documents(kind, sorted(self.editing.documents(kind)))
        self._cues.load(self.editing.documents, report)
        self._clips.load(self.editing.documents, report)
        self.sound_store.load(self.editing.documents, self.editing.contents, report)

    def enable_files(self, show: Callable[[], Path], run_job: RunFileJob) -> None:
        """Adds imports and exports; show: where the show file lies; run_job: does a `FileJob`."""
        self._run_job = run_job
        self.downloads = Downloads(show, run_job, self.long_requests)
        self.uploads = Uploads(show, run_job, self.long_requests)

    def enable_oscquery(self, port: int, allowed: Callable[[str], bool] = lambda _: False) -> None:
        """Adds the tree of OSC's addresses, for surfaces; port: where OSC is heard; allowed: the hosts that may play by
        it, and so may read the tree without a token."""
        self._surface_allowed = allowed
        self.oscquery = OscQuery(lambda: (self._state, *self._playable()), port)

    def enable_sender(self, path: str, respond: Respond, links: Links) -> None:
        """Adds links by which trackers, cameras or microphones send. path: their address; respond: answers there;
        links: those that are open."""
        self._heard[path] = respond
        self._sending.append(links)

    def enable_phone_page(self, describe: Callable[[], Devices]) -> None:
        """Tells phones what to type into the apps of trackers; describe: what is switched on."""
        self._describe_devices = describe

    def enable_access(self, control: AccessControl | None, authority: bytes | None = None) -> None:
        """Asks for tokens from now on, but for None; authority: the certificate that tablets may install.

        control: who may play, None for everybody.
        """
        self.access = control
        self.session.members.people = lambda: () if control is None else control.names()
        self.authority = authority

    def on_air(self, character: str = "", who: str = "") -> OnAir:
        """What a character shows now, the first on the stage where none is named; `coming` includes what was called
        since the last tick. who: the client that sees it, on air or in preview; "" for an editor."""
        unseen = self.session.preview_state if self.session.members.looks_at(who) == "preview" else None
        state = unseen or self._state
        on_air = read_on_air(state, character) if state else OnAir()
        return replace(on_air, coming=on_air.coming.union(*self.session.names_held()))

    def application(self, names: frozenset[str]) -> web.Application:
        """Builds the aiohttp application; `names` are the host names it answers to, beside numeric addresses."""
        silence_bad_requests()
        guards = [
            guard(names),
            guard_access(lambda: self.access, frozenset((*PAGES, PHONE_PATH)), self._surface_allowed),
        ]
        application = web.Application(middlewares=guards, client_max_size=MESSAGE_LIMIT)
        application.on_response_prepare.append(adding_headers(self.embedders, self.tell_frame))
        application.router.add_get(LINK_PATH, self.link)
        if self.editing is not None:
            application.router.add_get(EDITING_PATH, self.editing.link)
        for kind in NAMES_OF:
            application.router.add_get(address_of(kind), partial(self.document, kind))
        self._cues.add_routes(application)
        self.runs.add_routes(application)
        self._clips.add_routes(application)
        application.router.add_get("/exports/{file}", self.export)
        application.router.add_post("/imports/{file}", self.take_in)
        DocumentRoutes(self.documents).add_routes(application)
        PeopleRoutes(
            lambda: self.access,
            lambda: [link.visitor for link in self._all_links()],
            self.close_revoked,
            lambda: self.authority,
        ).add_routes(application)
        self._add_device_routes(application)
        PhonePage(lambda: self._describe_devices(), lambda: self.access, self._pages).add_routes(application)
        for path in (*PAGES, "/{page:.+}"):
            application.router.add_get(path, self.page)
        return application

    def _add_device_routes(self, application: web.Application) -> None:
        """Adds what surfaces read, where trackers and sounds are sent, and what others add."""
        self.sounds.add_routes(application)
        self.voices = Voices(self.sounds, lambda: self._run_job)
        self.voices.add_routes(application)
        layout = TouchoscLayout(self._playable, self._build_layout)
        application.router.add_get(TOUCHOSC_PATH, layout.respond)
        for path, respond in self._heard.items():
            application.router.add_get(path, respond)
        for add_routes in self.more_routes:
            add_routes(application)
        if self.oscquery is not None:
            self.oscquery.add_routes(application, self.page)

    def _playable(self) -> tuple[Playable, tuple[str, ...], dict[str, int]]:
        """The cast, the names of the characters, and the dimensions of pads by their names."""
        scene = self.session.scene
        return self.session.cast, tuple(scene), {name: pad.dimensions for name, pad in scene.pads.items()}

    async def _build_layout(self, wanted: BuildTouchoscLayout) -> bytes:
        """Builds a layout in a process of its own; in a thread where no show file and so no such process is there."""
        job = msgspec.msgpack.encode(wanted)
        if self._run_job is None:
            return await asyncio.to_thread(run_file_job, job, lambda *_: None)
        return await self._run_job(job, lambda *_: None)

    def tick(self) -> None:
        """Advances the session by one tick and broadcasts the state."""
        now = self.clock()
        for source in self.sources:
            source.hear(now)
        if self.voices is not None:
            self.voices.begin(self.session, self.clock)
        state = self._state = self.session.tick(now)
        data = encode(state)
        self.recording.record(data)
        self._deliver(self.session.hands_now(now))  # before the state, for which programs wait
        self._broadcast(data, now)
        for source in self.sources:
            source.tell(state, now)
        refused = self.session.texts.take_refused(lambda _: True)  # sources have taken theirs
        self._deliver([Outgoing(text.who, Refused(reason, text.message.id)) for text, reason in refused])
        self.documents.set_on_air(state)
        self._keep_cues()

    def _broadcast(self, data: bytes, now: float) -> None:
        """Sends what is on air to all links but those that look at the preview, which get that. data: the state on
        air."""
        unseen = self.session.preview_state
        others = set() if unseen is None else {who for who, each in self.session.crew.items() if each.bus == "preview"}
        self.links.broadcast(data, now, [link for link in self.links if link.who not in others])
        if unseen is not None:
            self.links.broadcast(encode(unseen), now, [link for link in self.links if link.who in others])

    def _keep_cues(self) -> None:
        """Writes what was edited of cues, clips and sounds since the last tick into the show file, each in a commit."""
        changes = self.session.cues.take_changes()
        if changes and self.editing is not None:
            self.editing.keep_documents(changes)
        if self.editing is not None:
            self._clips.keep(self.editing.keep_documents)
            self.sound_store.keep(self.editing.keep_documents)

    def broadcast_crew(self) -> None:
        """Broadcasts who is connected, once a second; those whose token has ended are not any more."""
        if self.access is not None:
            self.access.reload()
            self.close_revoked()
        self.announce(self.session.crew_now(self.clock()))

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

    def announce(self, message: ServerMessage) -> None:
        """Sends one message to every link."""
        data = encode(message)
        for link in self.links:
            self.links.answer(link.who, data)

    def close_revoked(self) -> None:
        """Closes the links of those whose token was revoked or has ended."""
        if self.access is not None:
            close_revoked(self._all_links(), self.access.holds)

    def _all_links(self) -> list[Link]:
        open_links = [self.links, *self._sending, *([self.editing.links] if self.editing else [])]
        return [link for links in open_links for link in links]

    async def close_all(self) -> None:
        """Closes every link; pages then know that the server is going."""
        await asyncio.gather(self.links.close_all(), *([self.editing.close()] if self.editing else []))

    async def link(self, request: web.Request) -> web.WebSocketResponse:
        """Handles one page's WebSocket link until it closes."""
        ws = LinkSocket(heartbeat=HEARTBEAT, limit=SPEECH_LIMIT)
        transport = await ws.accept(request)
        if transport is None:
            return ws
        link = self.links.open(ws, transport, visitor_in(request))
        self.session.members.identify(link.who, link.visitor)
        try:
            await self._listen(link)
        finally:
            self.links.close(link)
            self.session.leave(link.who, lost=None if ws.close_code in PAGE_CLOSED else self.clock())
        return ws

    async def document(self, kind: str, request: web.Request) -> web.Response:
        """Responds with a stored document of a kind; 204 where there is none, for browsers log a 404 as an error.

        kind: of the document; request: names it.
        """
        stored = None if self.editing is None else self.editing.documents(kind).get(request.match_info["name"])
        if stored is None:
            return web.Response(status=204, headers={"Cache-Control": NO_CACHE})
        return web.Response(body=stored, content_type="application/json", headers={"Cache-Control": NO_CACHE})

    async def export(self, request: web.Request) -> web.Response:
        """Responds with an export as a file to keep: an expression (.json), a face with expressions (.glb)."""
        if self.downloads is None:
            raise web.HTTPServiceUnavailable(text=f"nothing can be exported: {NO_FILE}")
        return await self.downloads.respond(request, self.documents.playing)

    async def take_in(self, request: web.Request) -> web.Response:
        """Takes in a file that a page sends, as expressions or a face (`?as=face`); responds with what it was."""
        if self.uploads is None or self.editing is None:
            raise web.HTTPServiceUnavailable(text=f"nothing can be taken in: {NO_FILE}")
        return await self.uploads.respond(request, self.editing.add_items)

    async def page(self, request: web.Request) -> web.Response:
        """Responds with a built page or one of its files."""
        page = self._pages.get(request.path)
        if page is None:
            raise web.HTTPNotFound(text=f"there is no such page; there are {', '.join(sorted(PAGES)[1:])}.")
        keep = CACHE_FOREVER if page.immutable else NO_CACHE
        return web.Response(body=page.body, content_type=page.content_type, headers={"Cache-Control": keep})

    async def _listen(self, link: Link) -> None:
        async for message in link.socket:
            await link.wait_turn(self.clock, len(message.data) if message.type is WSMsgType.BINARY else 0)
            if message.type is WSMsgType.BINARY:
                self._deliver(self.session.receive_bytes(link.who, message.data, self.clock()))
                if self.session.device_messages:
                    self.device_spoke()
                self._keep(self.session.take_keep_requests())
                for key in self.session.take_cancelled():
                    self.long_requests.cancel(key)
            elif message.type is WSMsgType.TEXT:
                self._deliver([Outgoing(link.who, Refused("text came, but messages are binary MessagePack."))])

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
        for delivery in outgoing:
            self.links.answer(delivery.who, encode(delivery.message))
