"""The editors' link: what they say goes to the session, its orders to the workshop, its changes to the show file, and
only then its answers back.

What follows from one thing follows in order, in one task, and the mathematics waits for none of it.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Awaitable, Callable, Coroutine
from dataclasses import dataclass, field
from functools import partial

import msgspec
from aiohttp import WSMsgType, web

from omote.edit.protocol.messages import EDITING_LIMIT, EditRefused, ToEditor
from omote.edit.protocol.orders import EditOrder
from omote.edit.protocol.wire import encode
from omote.edit.session.edit_session import EditSession, Outcome
from omote.edit.session.plan import KeepOutcome
from omote.edit.store.on_air_recipes import OnAir
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.cast_reload import CastReload
from omote.server.http.links import HEARTBEAT, Link, Links, LinkSocket
from omote.server.persistence.authored_work import AuthoredWork
from omote.server.persistence.commit_thread import CommitOutcome
from omote.server.workers.workshop import FailedOrderError, RefusedOrderError
from omote.show import messages as wire
from omote.show.rate_limit import TokenBucket
from omote.show.session import KeepRequest
from omote.showfile.changes import Change, Kind, PutLayout

HEARD_RATE, HEARD_BURST = 60.0, 60.0
"""Messages per second heard from one editor: a hand on a slider; more waits in its own socket."""
MOST_UNSENT = 512
"""Answers that wait for an editor who does not read; after that its link is cut, and it may come back."""
MOST_LAYOUTS = 64
CONSOLE = "the console"
"""The name under which the history shows what was saved on air."""

NO_FILE = (
    "there is no show file that can be written, so nothing can be edited or kept: name another file to `omote show`."
)

Tell = Callable[[str, wire.FromServer], None]
Consequence = Callable[[], Awaitable[None]]


@dataclass(eq=False)
class EditorPage:
    """An editor's page."""

    link: Link
    unsent: asyncio.Queue[bytes] = field(default_factory=asyncio.Queue)

    async def send_all(self) -> None:
        """Sends for ever, at the pace at which the page reads."""
        with contextlib.suppress(ConnectionError):
            while True:
                await self.link.socket.send_bytes(await self.unsent.get())


class EditorLinks:
    """Everybody who edits, and the way of what they do into file and show.

    desk: None when nothing can be kept; reopen: gives it anew, from the file; on_air: what is seen now; tell: sends a
    message to one console, announce: to every page of the show.
    """

    def __init__(
        self,
        authored_work: AuthoredWork | None,
        documents: CastDocuments,
        cast_reload: CastReload,
        *,
        reopen: Callable[[], AuthoredWork | None],
        on_air: Callable[[], OnAir],
        tell: Tell,
        announce: Callable[[wire.FromServer], None],
        report: Callable[[str], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.authored_work, self.links = authored_work, Links()
        self._reopen, self._documents, self._cast_reload, self._on_air = reopen, documents, cast_reload, on_air
        self._tell, self._announce, self._report, self._clock = tell, announce, report, clock
        self._pages: dict[str, EditorPage] = {}
        self._consequences: asyncio.Queue[Consequence] = asyncio.Queue()
        self._tasks: set[asyncio.Task[None]] = set()
        self._following: asyncio.Task[None] | None = None

    async def link(self, request: web.Request) -> web.WebSocketResponse:
        """An editor's link, from its first byte to its last."""
        ws = LinkSocket(
            heartbeat=HEARTBEAT, limit=EDITING_LIMIT, refusal=lambda reason: encode(EditRefused(-1, reason))
        )
        transport = await ws.accept(request)
        if transport is None:
            return ws
        page = EditorPage(self.links.open(ws, transport))
        page.link.bucket = TokenBucket(HEARD_RATE, HEARD_BURST)
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
        """What a console asked to keep."""
        if self.authored_work is None:
            self._tell(request.who, wire.Refused(NO_FILE))
        elif isinstance(request.message, wire.SetLayout):
            self._set_layout(self.authored_work, request.who, request.message)
        else:
            kind: Kind = "face" if isinstance(request.message, wire.KeepFace) else "expression"
            ticket, wall = f"{request.who} {request.message.id}", _wall()
            keep = partial(EditSession.keep, label=None, wall=wall, editor=CONSOLE, ticket=ticket)
            self._take(self.authored_work, lambda session: keep(session, kind, self._on_air()))

    def layout(self, name: str) -> bytes | None:
        """A page's document, JSON; None where there is none."""
        return None if self.authored_work is None else self.authored_work.layouts.get(name)

    async def close(self) -> None:
        """Hangs up and stops; what was not acknowledged may be lost."""
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
                receive_bytes = partial(EditSession.receive_bytes, wall=_wall(), on_air=self._on_air())
                self._take(self.authored_work, partial(receive_bytes, who=link.who, data=message.data))

    def _take(self, authored_work: AuthoredWork, happens: Callable[[EditSession], Outcome]) -> None:
        """Begins the orders that come of something, and lets the rest of it follow in its turn."""
        try:
            outcome = happens(authored_work.session)
        except Exception as error:
            self._restart(f"an edit could not be understood ({error!r})")
            return
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

    def _set_layout(self, authored_work: AuthoredWork, who: str, asked: wire.SetLayout) -> None:
        document = asked.document.encode()
        try:
            msgspec.json.decode(document)
        except (msgspec.DecodeError, RecursionError) as error:
            self._tell(who, wire.Refused(f"the layout {asked.name!r} is no JSON ({error}): send it again."))
            return
        if asked.name not in authored_work.layouts and len(authored_work.layouts) >= MOST_LAYOUTS:
            self._tell(who, wire.Refused(f"there are {MOST_LAYOUTS} layouts already: use the name of one of them."))
            return
        authored_work.layouts[asked.name] = document
        self._take(authored_work, lambda _: Outcome(changes=(PutLayout(asked.name, document),)))

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
        for kept in outcome.kept:
            self._tell_kept(kept)

    async def _commit(self, authored_work: AuthoredWork, changes: tuple[Change, ...]) -> str | None:
        """Waits until changes are kept; why they never will be."""
        if not changes:
            return None
        loop, fates = asyncio.get_running_loop(), asyncio.Queue[CommitOutcome]()

        def told(fate: CommitOutcome) -> None:
            loop.call_soon_threadsafe(fates.put_nowait, fate)

        authored_work.committer.commit(changes, told)
        while (fate := await fates.get()).state == "waiting":
            for who in self._pages:
                self._send(who, EditRefused(-1, fate.sentence))
        return None if fate.state == "committed" else fate.sentence

    def _restart(self, why: str) -> None:
        """The session knows what the file does not: the file counts, and every page opens its work again."""
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
            self._report(f"the cast stays as it is ({error}).")

    def _tell_kept(self, kept: KeepOutcome) -> None:
        who, _, call = kept.ticket.partition(" ")
        message = wire.Refused(kept.trouble) if kept.trouble else wire.Kept(call, kept.name, kept.label)
        self._tell(who, message)

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
            except Exception as error:
                self._restart(f"an edit could not be carried out ({error!r})")

    def _begin(self, work: Coroutine[object, object, None]) -> asyncio.Task[None]:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task


def _wall() -> float:
    """Seconds since 1970, for people to read."""
    return time.time()  # noqa: TID251  (dates revisions; drives nothing)
