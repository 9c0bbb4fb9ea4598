"""A link to the show: how it opens, what it is told, and how it keeps time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec

from omote.show.declaration import CallId, ClientMessage, Outgoing, ServerMessage, Session
from omote.show.validation import SENT, name_escapes, validate_number

Role = Literal["stage", "console"]
Bus = Literal["air", "preview"]
ConsoleName = Annotated[str, msgspec.Meta(max_length=24)]


class Hello(ClientMessage, frozen=True):
    """Opens a link; other messages are rejected before it. `name`: what a console's operator calls it, or what it was
    called the last time; a second hello changes it. `page`: the same for each link of one page, another for each page.
    `seat`: of the operator, whom a reload and a lost link do not change; without one it is the page's. `bus`: what it
    looks at: what is on air, or the preview, on which what it plays is not seen; a second hello changes that.
    """

    access = "view"
    recorded = False
    open_to = "everybody"

    role: Role
    version: int
    name: ConsoleName = ""
    page: Annotated[str, msgspec.Meta(max_length=64)] = ""
    seat: Annotated[str, msgspec.Meta(max_length=64)] = ""
    bus: Bus = "air"

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Admits the client. session: the show; who: the client; now: seconds, monotonic."""
        return session.welcome(who, self)


class Cancel(ClientMessage, frozen=True):
    """Ends a long request, which then changes nothing: an import or export sent over HTTP with `?request=` and an id of
    the page's own. One that has ended is left as it is."""

    access = "operate"
    recorded = False

    request: CallId

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Notes the request for the server. session: the show; who: the client; now: seconds, monotonic."""
        session.cancelled.append(self.request)
        return ()


class Ping(ClientMessage, frozen=True):
    """Asks for a pong; `sent` is the client's own clock and comes back unchanged."""

    access = "view"
    recorded = False
    open_to = "everybody"

    sent: float

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Answers with the show's clock. session: the show; who: the client; now: seconds, monotonic."""
        return [Outgoing(who, Pong(validate_number(self.sent, SENT), session.clock(now)))]


class Pong(ServerMessage, frozen=True):
    """Answers ping: `time` is the show's clock at that moment, as in `State.time`."""

    sent: float
    time: float


class Welcome(ServerMessage, frozen=True):
    """Answers hello: `epoch` rises with each server start, `revision` with each change of the documents. `name`: what
    the others call this console. `show`: which show file is played, "" for none; another one has another."""

    version: int
    epoch: int
    revision: int
    digest: str
    name: str = ""
    show: str = ""


class Refused(ServerMessage, frozen=True):
    """A message was rejected, and why, in one sentence for the operator. `id`: of the message, where it had one, also
    where nothing else of it could be read. `held`: the parts that others hold, where that was the reason."""

    reason: str
    id: str = ""
    held: list[str] = []

    def __post_init__(self) -> None:
        msgspec.structs.force_setattr(self, "reason", name_escapes(self.reason))


class Notice(msgspec.Struct, frozen=True):
    """What the crew must know until each has dismissed it; `id` is its own for ever, `time` seconds since 1970.
    `solved`: it says that something is well again, and goes by itself."""

    id: str
    time: float
    text: str
    solved: bool = False

    def __post_init__(self) -> None:
        msgspec.structs.force_setattr(self, "text", name_escapes(self.text))


class Notices(ServerMessage, frozen=True):
    """All notices of this show, oldest first: complete, so any may be lost. Consoles and editors get them after the
    welcome, with each new one, and once a second while there are any."""

    notices: list[Notice]


class Progress(ServerMessage, frozen=True):
    """How far a long request (an import, an export) is: steps done of `total` (0: not known yet), and what is done now,
    for people. To consoles and editors; any may be lost, and the request's own answer says that it has ended."""

    request: str
    done: int
    total: int
    what: str
