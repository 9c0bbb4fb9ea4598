"""The editors' WebSocket link: requests go to the edit session, its orders to the workshop, its changes to the show
file, and only after the commit its answers back.

The consequences of all requests are carried out in order by one task; computations do not wait for it.
"""

from __future__ import annotations

import asyncio
import contextlib
import sys
import time
import traceback
from collections.abc import Awaitable, Callable, Coroutine, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial

from aiohttp import WSMsgType, web

from omote.edit.protocol.messages import EDITING_LIMIT, EditRefused, Greeted, ToEditor
from omote.edit.protocol.orders import EditOrder
from omote.edit.protocol.wire import encode
from omote.edit.session.brought_items import Adding, TakenIn
from omote.edit.session.console_requests import answer_console, reply_to_console
from omote.edit.session.edit_session import EditSession, Outcome
from omote.edit.session.plan import KeepOutcome
from omote.edit.store.on_air_recipes import OnAir
from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.access_guard import visitor_in
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.cast_reload import CastReload
from omote.server.links.links import HEARTBEAT, Link, Links, LinkSocket
from omote.server.persistence.authored_work import AuthoredWork
from omote.server.persistence.commit_thread import CommitOutcome
from omote.server.workers.workshop import FailedOrderError, RefusedOrderError
from omote.show.declaration import KeepRequest, ServerMessage
from omote.show.objects.link import Notice, Notices, Progress, Refused
from omote.show.validation import Refusal
from omote.showfile.changes import Change, DocumentRemoval, StoredDocument

HEARD_RATE = 60.0
HEARD_BURST = 60.0
"""Messages per second read from one editor (a slider being dragged); more waits in the socket."""
MOST_UNSENT = 512
"""Answers that wait for an editor who does not read; after that its link is cut, and it may come back."""

NO_FILE = (
    "there is no show file that can be written, so nothing can be edited or kept: name another file to `omote show`."
)

Tell = Callable[[str, ServerMessage], None]
Consequence = Callable[[], Awaitable[None]]


@dataclass(eq=False)
class EditorPage:
    """One editor's page: its link and its unsent messages."""

    link: Link
    unsent: asyncio.Queue[bytes] = field(default_factory=asyncio.Queue)

    async def send_all(self) -> None:
        """Sends unsent messages for ever, as fast as the page reads them."""
        with contextlib.suppress(ConnectionError):
            while True:
                await self.link.socket.send_bytes(await self.unsent.get())


class EditorLinks:
    """Connects all editors with the edit session, the workshop, the show file and the playing cast.

    authored_work: None when nothing can be stored; reopen: reads it again from the file; on_air: what is seen now of a
    character, by a client; tell: sends a message to one console, announce: to every page of the show; notices: what the
    crew must know; list_documents: tells consoles the names of the documents of a kind; cancel: ends a long request.
    """

    def __init__(
        self,
        authored_work: AuthoredWork | None,
        documents: CastDocuments,
        cast_reload: CastReload,
        *,
        reopen: Callable[[], AuthoredWork | None],
        on_air: Callable[[str, str], OnAir],
        tell: Tell,
        announce: Callable[[ServerMessage], None],
        report: Callable[[str], None],
        notices: Callable[[], list[Notice]] = list,
        list_documents: Callable[[str, list[str]], None] = lambda *_: None,
        cancel: Callable[[str], None] = lambda _: None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.authored_work = authored_work
        self.links = Links(rate=HEARD_RATE, burst=HEARD_BURST)
        self._reopen = reopen
        self._documents = documents
        self._cast_reload = cast_reload
        self._on_air = on_air
        self._tell = tell
        self._announce = announce
        self._report = report
        self._clock = clock
        self._notices = notices
        self._list_documents = list_documents
        self._cancel = cancel
        self._pages: dict[str, EditorPage] = {}
        self._consequences: asyncio.Queue[Consequence] = asyncio.Queue()
        self._tasks: set[asyncio.Task[None]] = set()
        self._following: asyncio.Task[None] | None = None

    async def link(self, request: web.Request) -> web.WebSocketResponse:
        """Handles one editor's WebSocket link until it closes."""
        ws = LinkSocket(
            heartbeat=HEARTBEAT, limit=EDITING_LIMIT, refusal=lambda reason: encode(EditRefused(-1, reason))
        )
        transport = await ws.accept(request)
        if transport is None:
            return ws
        page = EditorPage(self.links.open(ws, transport, visitor_in(request)))
        self._pages[page.link.who] = page
        sending = self._begin(page.send_all())
        try:
            await self._listen(page.link)
        finally:
            sending.cancel()
            self.links.close(page.link)
            del self._pages[page.link.who]
            if self.authored_work is not None:
                self._take(self.authored_work, lambda session: session.leave(page.link.who))
        return ws

    def request_keep(self, request: KeepRequest) -> None:
        """Carries out what a console asks of the show file."""
        if self.authored_work is None:
            self._tell(request.who, Refused(NO_FILE, getattr(request.message, "id", "")))
        else:
            on_air = self._on_air(getattr(request.message, "character", ""), request.who)
            self._take(self.authored_work, partial(answer_console, request=request, on_air=on_air, wall=_wall()))

    async def add_items(self, adding: Adding) -> list[TakenIn] | str:
        """Adds items; returns what became of each, once they are on the disk and play, or why not."""
        authored_work = self.authored_work
        done = asyncio.get_running_loop().create_future()
        if authored_work is None:
            return NO_FILE
        try:
            result, taken = adding(authored_work.session.authored)
        except Refusal as refusal:
            return str(refusal)
        outcome = authored_work.session.carry_out(lambda: result, "")

        async def carry_out() -> None:
            try:
                await self._carry_out(authored_work, outcome)
            finally:
                done.set_result(None)

        self._follow(carry_out)
        await done
        return taken if authored_work is self.authored_work else "it could not be kept in the show file; try again."

    def documents(self, kind: str) -> Mapping[str, bytes]:
        """The stored documents (JSON) of a kind by name."""
        return {} if self.authored_work is None else self.authored_work.documents(kind)

    @property
    def contents(self) -> Mapping[str, bytes]:
        """The bytes of all contents, by key."""
        return {} if self.authored_work is None else self.authored_work.session.contents

    def keep_documents(self, changes: Sequence[Change]) -> None:
        """Commits documents, with the contents that they need, beside the show; without a show file they are known
        until its end."""
        if self.authored_work is not None:
            self.authored_work.keep_documents(changes, self._report)

    def send_news(self, news: Notices | Progress) -> None:
        """Sends what is complete by itself to every editor that reads."""
        for who, page in self._pages.items():
            if page.unsent.empty():  # it comes again; more than one that waits helps nobody
                self._send(who, news)

    async def close(self) -> None:
        """Closes all links and stops; what was not acknowledged may be lost."""
        await self.links.close_all()
        for task in list(self._tasks):
            task.cancel()

    async def _listen(self, link: Link) -> None:
        async for message in link.socket:
            await link.wait_turn(self._clock)
            if message.type is WSMsgType.TEXT:
                self._send(link.who, EditRefused(-1, "text came, but messages are binary MessagePack."))
            elif message.type is WSMsgType.BINARY and self.authored_work is None:
                self._send(link.who, EditRefused(-1, NO_FILE))
            elif message.type is WSMsgType.BINARY and self.authored_work is not None:
                now = partial(EditSession.receive_bytes, wall=_wall(), on_air=lambda: self._on_air("", ""))
                self._take(self.authored_work, partial(now, who=link.who, data=message.data, visitor=link.visitor))

    def _take(self, authored_work: AuthoredWork, happens: Callable[[EditSession], Outcome]) -> None:
        """Starts the orders of an outcome and queues its other consequences."""
        try:
            outcome = happens(authored_work.session)
        except Exception:
            self._restart("an edit could not be understood, by a fault of Omote", traceback.format_exc())
            return
        for request in outcome.cancelled:
            self._cancel(request)
        for number, order in outcome.orders:
            self._begin(self._work(authored_work, number, order))
        if outcome.changes or outcome.replies or outcome.kept or outcome.cast:
            self._follow(partial(self._carry_out, authored_work, outcome))

    async def _work(self, authored_work: AuthoredWork, number: int, order: EditOrder) -> None:
        result: bytes | str
        try:
            result = await self._documents.run_order(order)
        except (RefusedOrderError, FailedOrderError) as error:
            result = f"{error}."
        if authored_work is self.authored_work:
            self._take(authored_work, lambda session: session.finish_order(number, result))

    async def _carry_out(self, authored_work: AuthoredWork, outcome: Outcome) -> None:
        if authored_work is not self.authored_work:
            return
        why = await self._commit(authored_work, outcome.changes)
        if why is not None:
            self._restart(f"an edit could not be kept ({why})")
            return
        if outcome.cast:
            self._announce(await self._cast_reload.recast(authored_work.session.own(), authored_work.session.contents))
        for reply in outcome.replies:
            self._send(reply.who, reply.message)
            if isinstance(reply.message, Greeted) and self._notices():
                self._send(reply.who, Notices(self._notices()))
        for kept in outcome.kept:
            self._tell_kept(kept)
        for kind in {change.kind for change in outcome.changes if isinstance(change, StoredDocument | DocumentRemoval)}:
            self._list_documents(kind, sorted(self.documents(kind)))

    async def _commit(self, authored_work: AuthoredWork, changes: tuple[Change, ...]) -> str | None:
        """Waits until changes are committed; returns why they never will be, or None."""
        if not changes:
            return None
        loop = asyncio.get_running_loop()
        outcomes = asyncio.Queue[CommitOutcome]()

        def report_outcome(outcome: CommitOutcome) -> None:
            loop.call_soon_threadsafe(outcomes.put_nowait, outcome)

        authored_work.committer.commit(changes, report_outcome)
        while (outcome := await outcomes.get()).state == "waiting":
            for who in self._pages:
                self._send(who, EditRefused(-1, outcome.sentence))
        return None if outcome.state == "committed" else outcome.sentence

    def _restart(self, why: str, technical: str = "") -> None:
        """Reads the authored work from the file again, for the session is ahead of it; every page reconnects.

        technical: for the terminal alone, where whoever mends Omote finds it.
        """
        sys.stderr.write(technical)
        self._report(f"{why}; the editors' pages begin again from what the show file has.")
        self.authored_work = self._reopen()
        if self.authored_work is not None:
            self._documents.contents = self.authored_work.session.contents
            self._follow(self._play_what_is_kept)
        for page in list(self._pages.values()):
            page.link.transport.abort()

    async def _play_what_is_kept(self) -> None:
        if self.authored_work is None:
            return
        try:
            self._announce(
                await self._cast_reload.recast(self.authored_work.session.own(), self.authored_work.session.contents)
            )
        except (ValueError, KeyError) as error:
            self._report(f"the cast stays as it is ({explain_error(error)}).")

    def _tell_kept(self, kept: KeepOutcome) -> None:
        who, _, call = kept.ticket.partition(" ")
        self._tell(who, reply_to_console(call, kept))

    def _send(self, who: str, message: ToEditor) -> None:
        page = self._pages.get(who)
        if page is None:
            return
        page.unsent.put_nowait(encode(message))
        if page.unsent.qsize() > MOST_UNSENT:
            page.link.transport.abort()

    def _follow(self, consequence: Consequence) -> None:
        self._consequences.put_nowait(consequence)
        if self._following is None:
            self._following = self._begin(self._follow_all())

    async def _follow_all(self) -> None:
        while True:
            consequence = await self._consequences.get()
            try:
                await consequence()
            except Exception:
                self._restart("an edit could not be carried out, by a fault of Omote", traceback.format_exc())

    def _begin(self, work: Coroutine[object, object, None]) -> asyncio.Task[None]:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task


def _wall() -> float:
    """Seconds since 1970, for people to read."""
    return time.time()  # noqa: TID251  (dates revisions; drives nothing)
