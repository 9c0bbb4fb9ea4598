"""The show session without input or output: messages and times in, messages and states out; a log of them replays."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

import msgspec

from omote.perform.panic import PANIC_SECONDS
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot, names_held
from omote.show import messages as wire
from omote.show import validation
from omote.show.commands import ACTIONS, reload_hint
from omote.show.contention import MOVING, Hands, name_apart
from omote.show.state import EyeOffset, offset_between, state_of
from omote.show.validation import Refusal, validate_number
from omote.show.wire import decode, id_in

if TYPE_CHECKING:
    from omote.perform.snapshot import Playable

REMEMBERED_CALLS = 512
LOST_SECONDS = 600.0
"""How long a stage that does not come back is missed: after that somebody has put it away."""
SILENCE = 3.0
"""Seconds without a heartbeat after which a stage counts as not drawing."""


@dataclass(frozen=True)
class Outgoing:
    """A message for one client."""

    who: str
    message: wire.FromServer


@dataclass(frozen=True)
class Member:
    """A connected client: its role, its last report with the time of it, and the name of a console or a source.

    claims: it asked for that name, else it was given one; page: the page that the link belongs to.
    """

    role: wire.Role | Literal["source"]
    report: wire.StageReport | None = None
    heard: float = -math.inf
    name: str = ""
    claims: bool = False
    page: str = ""


@dataclass(frozen=True)
class KeepRequest:
    """A console's request to change the show file; the server carries it out."""

    who: str
    message: wire.KeepMessage


class SessionSnapshot(msgspec.Struct, frozen=True):
    """All that a restarted server needs: the performer, and the calls already executed."""

    performer: Snapshot
    calls: list[str]


class ShowSession:
    """A running show: who is connected, what has been called, what is on air."""

    def __init__(self, cast: Playable, performer: Performer, *, epoch: int = 1, revision: int = 1) -> None:
        self.cast, self.performer, self.epoch, self.revision = cast, performer, epoch, revision
        self.number = 0
        self.refused = 0
        self.commands = 0
        self.crew: dict[str, Member] = {}
        self.wishes: list[KeepRequest] = []
        self.cancelled: list[str] = []
        self.notices: list[wire.Notice] = []
        self.layouts: list[str] = []
        self._lost_stages: list[float] = []  # when the links broke
        self._calls: dict[str, None] = {}
        self._now: float | None = None
        self._time = performer.snapshot().time
        self._eye_offset = EyeOffset()
        self._hands = Hands()
        self._panicked: tuple[str, float] | None = None  # who pressed last, and when

    @classmethod
    def restored(cls, cast: Playable, snapshot: SessionSnapshot, *, epoch: int, revision: int = 1) -> ShowSession:
        """The show of a snapshot, under a new epoch; ValueError when the snapshot does not fit the cast."""
        session = cls(cast, Performer.restored(cast, snapshot.performer), epoch=epoch, revision=revision)
        session._calls = dict.fromkeys(snapshot.calls)
        return session

    def snapshot(self) -> SessionSnapshot:
        """The show as it is now."""
        return SessionSnapshot(performer=self.performer.snapshot(), calls=list(self._calls))

    def receive_bytes(self, who: str, data: bytes, now: float) -> list[Outgoing]:
        """Handles the bytes of a client and returns the answers; invalid bytes are rejected and counted."""
        try:
            message = decode(data)
        except Refusal as refusal:
            return self._refuse(who, refusal, id_in(data))
        return self.receive(who, message, now)

    def receive(self, who: str, message: wire.FromClient, now: float) -> list[Outgoing]:
        """Handles a message and returns the answers; an invalid one is rejected with a message and changes nothing."""
        try:
            return self._answer(who, message, now)
        except Refusal as refusal:
            return self._refuse(who, refusal, getattr(message, "id", ""))

    def tick(self, now: float) -> wire.State:
        """Advances the show to `now` (seconds, monotonic) in one step and returns what is on air."""
        elapsed = 0.0 if self._now is None else max(0.0, now - self._now)
        self._now = now
        self.number += 1
        return self._state(elapsed)

    def _state(self, elapsed: float) -> wire.State:
        frame = self.performer.advance(elapsed)
        self._time = frame.time
        state = state_of(self.cast, frame, epoch=self.epoch, number=self.number, revision=self.revision)
        return msgspec.structs.replace(state, eyes=self._eye_offset.add_to(state.eyes, state.time))

    def recast(self, cast: Playable) -> wire.CastChanged:
        """Plays another cast from now on; returns the message for all pages. ValueError where it lacks what is on
        air.

        Stages ease what the skin does; the eyes, whose angles the state holds, ease here.
        """
        shown = self._state(0.0)
        self.performer.recast(cast)
        self.cast, self._eye_offset = cast, EyeOffset()
        self._eye_offset = offset_between(shown.eyes, self._state(0.0).eyes, shown.time)
        self.revision += 1
        return wire.CastChanged(self.revision, cast.digest)

    def names_held(self) -> tuple[frozenset[str], frozenset[str]]:
        """The faces and the expressions that the cast must not lose: they are on air, called or going."""
        return names_held(self.performer.snapshot())

    def take_keep_requests(self) -> list[KeepRequest]:
        """Returns and clears the consoles' requests to keep something."""
        requests, self.wishes = self.wishes, []
        return requests

    def take_cancelled(self) -> list[str]:
        """Returns and clears the long requests that consoles end."""
        requests, self.cancelled = self.cancelled, []
        return requests

    def clock(self, now: float) -> float:
        """The show's clock at `now`, as in `State.time`: it runs on through a restart of the server."""
        return self._time if self._now is None else self._time + max(0.0, now - self._now)

    def join(self, who: str, name: str) -> None:
        """Adds a source, such as a sender of OSC: it plays as a console does, but hears nothing and needs no hello."""
        self.crew[who] = Member("source", name=name)

    def leave(self, who: str, *, lost: float | None = None) -> None:
        """Removes a client; T-bars and channels that it held stay as they are. lost: when its link broke, where its
        page was not closed."""
        member = self.crew.pop(who, None)
        self._hands.leave(who)
        if member is not None and member.role == "stage" and lost is not None:
            self._lost_stages.append(lost)

    def crew_now(self, now: float) -> wire.Crew:
        """Who is connected, and what each stage draws."""
        members = list(self.crew.values())
        stages = [m.report if now - m.heard <= SILENCE else None for m in members if m.role == "stage"]
        lost = sum(now - broke <= LOST_SECONDS for broke in self._lost_stages)
        return wire.Crew(stages, sum(m.role == "console" for m in members), lost)

    def notices_for(self, who: str) -> list[Outgoing]:
        """All notices for a console; nothing where there are none, or for a stage."""
        wanted = self.notices and self._member(who).role == "console"
        return [Outgoing(who, wire.Notices(list(self.notices)))] if wanted else []

    def layouts_now(self) -> list[Outgoing]:
        """The names of all layouts, for every console."""
        return self.for_consoles(wire.Layouts(list(self.layouts)))

    def for_consoles(self, message: wire.FromServer) -> list[Outgoing]:
        """A message for every console."""
        return [Outgoing(who, message) for who in self._consoles()]

    def hands_now(self, now: float) -> list[Outgoing]:
        """What consoles must be told of each other's hands."""
        sources = {who: member.name for who, member in self.crew.items() if member.role == "source"}
        return [Outgoing(who, told) for who, told in self._hands.tell(self._consoles(), now, sources).items()]

    def _consoles(self) -> dict[str, str]:
        return {who: member.name for who, member in self.crew.items() if member.role == "console"}

    def _answer(self, who: str, message: wire.FromClient, now: float) -> list[Outgoing]:
        match message:
            case wire.Hello():
                welcomes = self._welcome(who, message)
                layouts = [each for each in self.layouts_now() if each.who == who and self.layouts]
                return [*welcomes, *self.notices_for(who), *layouts]
            case wire.Ping():
                return [
                    Outgoing(who, wire.Pong(sent=validate_number(message.sent, validation.SENT), time=self.clock(now)))
                ]
            case wire.Drawing():
                report = wire.StageReport(validate_number(message.fps, validation.FPS), message.level)
                self.crew[who] = replace(self._member(who), report=report, heard=now)
            case wire.Cancel():
                self._refuse_a_stage(who, message)
                self.cancelled.append(message.request)
            case _ if getattr(message, "id", None) in self._calls:
                pass  # a retry or a bouncing key: each call executes once
            case _ if isinstance(message, wire.KeepMessage):
                self._add_keep_request(KeepRequest(who, message))
            case _:
                self._obey(who, message, now)
        return []

    def _add_keep_request(self, request: KeepRequest) -> None:
        self._refuse_a_stage(request.who, request.message)
        self.wishes.append(request)
        if request.message.id:
            self._remember(request.message.id)

    def _refuse_a_stage(self, who: str, message: wire.FromClient) -> None:
        if self._member(who).role == "stage":
            raise Refusal(f"{type(message).__struct_config__.tag} came from a stage, but only a console plays.")

    def _refuse_a_late_hand(self, who: str, message: wire.FromClient, now: float) -> None:
        """Rejects what a hand at another console sent before that page could know of a panic: it would undo it."""
        if self._panicked is None or not isinstance(message, MOVING):
            return
        presser, pressed = self._panicked
        if who != presser and now - pressed < PANIC_SECONDS:
            raise Refusal("panic was pressed at another console: all hands are off; take the control again.")

    def _remember(self, call: str) -> None:
        self._calls[call] = None
        if len(self._calls) > REMEMBERED_CALLS:
            del self._calls[next(iter(self._calls))]

    def _obey(self, who: str, message: wire.FromClient, now: float) -> None:
        self._refuse_a_stage(who, message)
        self._refuse_a_late_hand(who, message, now)
        try:
            ACTIONS[type(message)](self.performer, message)
        except Refusal:
            raise
        except (ValueError, TypeError) as error:
            raise Refusal(f"{error}. Nothing has changed.{reload_hint(message)}") from error
        self.commands += 1
        self._hands.note(who, message, now)
        if isinstance(message, wire.Panic):
            self._panicked = who, now
            self._hands.take_off()
        if isinstance(message, wire.CallFace | wire.CallExpression | wire.CallLight):
            self._remember(message.id)

    def _welcome(self, who: str, hello: wire.Hello) -> list[Outgoing]:
        """The welcome of a client; another's too, where that was given the name that a console claims."""
        if hello.version != wire.PROTOCOL_VERSION:
            versions = f"version {hello.version}, the server {wire.PROTOCOL_VERSION}"
            raise Refusal(f"the page speaks {versions}: reload the page.")
        if hello.role == "stage" and who not in self.crew:
            del self._lost_stages[:1]  # one of them is back, or another in its place
        if hello.role != "console":
            self.crew[who] = Member(hello.role)
            return [self._welcomed(who)]
        for other in [other for other, each in self.crew.items() if hello.page and each.page == hello.page]:
            self.leave(other)  # a link of this page that has broken, or its own hello under another name
        self.crew[who] = Member("console", name=hello.name.strip(), claims=bool(hello.name.strip()), page=hello.page)
        consoles = {each: (self.crew[each].name, self.crew[each].claims) for each in self._consoles()}
        names = name_apart(consoles, who)
        for each, name in names.items():
            self.crew[each] = replace(self.crew[each], name=name)
        return [self._welcomed(each) for each in names]

    def _welcomed(self, who: str) -> Outgoing:
        name = self.crew[who].name
        message = wire.Welcome(wire.PROTOCOL_VERSION, self.epoch, self.revision, self.cast.digest, name)
        return Outgoing(who, message)

    def _member(self, who: str) -> Member:
        if who not in self.crew:
            raise Refusal("nothing is heard before hello: send hello with role and version first.")
        return self.crew[who]

    def _refuse(self, who: str, refusal: Refusal, message: str) -> list[Outgoing]:
        self.refused += 1
        return [Outgoing(who, wire.Refused(reason=str(refusal), id=message))]
