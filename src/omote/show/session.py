"""The show session without input or output: messages and times in, messages and states out; a log of them replays."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_snapshot import names_held_by
from omote.perform.snapshot import Playable
from omote.show import messages as wire
from omote.show import validation
from omote.show.access.message_roles import PLAY_MESSAGES, check_message
from omote.show.commands import carry_out, find_addressed, refuse_errors, refuse_unknown
from omote.show.crew.contention import Hands, Panics
from omote.show.crew.members import Member, Members, report_in
from omote.show.leases.leasing import HeldByOthersRefusal, Leasing
from omote.show.outgoing import KeepRequest, Outgoing
from omote.show.session_snapshot import SessionSnapshot
from omote.show.sources.open_sources import SOURCE_CHANGES, OpenSources
from omote.show.speech.known_sounds import KnownSounds
from omote.show.speech.sound_stage import SoundStage
from omote.show.state import EyeOffset, offset_between, state_of
from omote.show.validation import Refusal, validate_number
from omote.show.wire import decode, id_in

REMEMBERED_CALLS = 512
MOST_DEVICE_MESSAGES = 4096
"""Of devices, between two ticks."""


class ShowSession:
    """A running show: who is connected, what has been called, what is on air."""

    def __init__(self, cast: Playable, scene: Scene | None = None, *, epoch: int = 1, revision: int = 1) -> None:
        self.cast, self.epoch, self.revision = cast, epoch, revision
        self.scene = Scene.begun(cast) if scene is None else scene
        self.number = 0
        self.refused = 0
        self.commands = 0
        self.members = Members()
        self.wishes: list[KeepRequest] = []
        self.cancelled: list[str] = []
        self.device_messages: list[tuple[str, wire.DeviceMessage]] = []
        self.notices: list[wire.Notice] = []
        self.layouts: list[str] = []
        self.show = ""
        self._calls: dict[str, None] = {}
        self._now: float | None = None
        self._time = self.scene.snapshot().time
        self._eye_offsets: dict[str, EyeOffset] = {}
        self._hands, self._panics, self.sources = Hands(), Panics(), OpenSources()
        self.sounds, self._sound_stage = KnownSounds(), SoundStage()
        self.leasing = Leasing(self.members, labels=lambda: self.scene.labels)

    @classmethod
    def restored(cls, cast: Playable, snapshot: SessionSnapshot, *, epoch: int, revision: int = 1) -> ShowSession:
        """The show of a snapshot, under a new epoch; ValueError when the snapshot does not fit the cast."""
        if not snapshot.scene.characters:
            raise ValueError("the scene of the snapshot is empty; a show has a character")
        session = cls(cast, Scene.restored(cast, snapshot.scene), epoch=epoch, revision=revision)
        session._calls = dict.fromkeys(snapshot.calls)
        session.sources = OpenSources(snapshot.sources)
        session.leasing = Leasing(session.members, snapshot.leases, lambda: session.scene.labels)
        return session

    def snapshot(self) -> SessionSnapshot:
        """The show as it is now."""
        return SessionSnapshot(
            self.scene.snapshot(), list(self._calls), self.leasing.snapshot(), self.sources.snapshot()
        )

    def receive_bytes(self, who: str, data: bytes, now: float) -> list[Outgoing]:
        """Handles the bytes of a client and returns the answers; invalid bytes are rejected and counted."""
        try:
            message = decode(data)
        except Refusal as refusal:
            return self._refuse(who, refusal, id_in(data), now)
        return self.receive(who, message, now)

    def receive(self, who: str, message: wire.FromClient, now: float) -> list[Outgoing]:
        """Handles a message and returns the answers; an invalid one is rejected with a message and changes nothing."""
        try:
            check_message(PLAY_MESSAGES, self.members.visitor(who).role, message)
            return self._answer(who, message, now)
        except Refusal as refusal:
            return self._refuse(who, refusal, getattr(message, "id", ""), now)

    def set_channels(self, who: str, character: str, values: Mapping[str, float], now: float) -> bool:
        """Sets channels of a character as a `SetChannel` each would, with one look at who may; False where one of them
        would be rejected: then nothing has changed."""
        message = wire.SetChannel(character, *next(iter(values.items())))
        try:
            check_message(PLAY_MESSAGES, self.members.visitor(who).role, message)
            self.members.refuse_a_stage(who, message)
            self._panics.refuse_late(who, message, (character,), now)
            self.leasing.check(who, message, (character,))
            self.scene[character].set_channels(values)
        except (KeyError, ValueError, TypeError):  # a Refusal is a ValueError
            return False
        self.commands += len(values)
        self._hands.note_channels(who, character, values, now)
        self.leasing.note(who, message, (character,))
        return True

    def tick(self, now: float) -> wire.State:
        """Advances the show to `now` (seconds, monotonic) in one step and returns what is on air."""
        elapsed = 0.0 if self._now is None else max(0.0, now - self._now)
        self._now = now
        self.number += 1
        self.leasing.expire(tuple(self.scene), now)
        return self._state(elapsed)

    def _state(self, elapsed: float) -> wire.State:
        frame = self.scene.advance(elapsed)
        self._time = frame.time
        numbers = {"epoch": self.epoch, "number": self.number, "revision": self.revision}
        return state_of(self.cast, frame, self._eye_offsets, **numbers)

    def recast(self, cast: Playable) -> wire.CastChanged:
        """Plays another cast from now on; returns the message for all pages. ValueError where it lacks what is on
        air.

        Stages ease what the skin does; the eyes, whose angles the state holds, ease here.
        """
        shown = self._state(0.0)
        self.scene.recast(cast)
        self.cast, self._eye_offsets = cast, {}
        for name, wanted in self._state(0.0).characters.items():
            self._eye_offsets[name] = offset_between(shown.characters[name].eyes, wanted.eyes, shown.time)
        self.revision += 1
        return wire.CastChanged(self.revision, cast.digest)

    def names_held(self) -> tuple[frozenset[str], frozenset[str]]:
        """The faces and the expressions that the cast must not lose: they are on air, called or going."""
        return names_held_by(self.scene.snapshot())

    def take_keep_requests(self) -> list[KeepRequest]:
        """Returns and clears the consoles' requests to keep something."""
        requests, self.wishes = self.wishes, []
        return requests

    def take_cancelled(self) -> list[str]:
        """Returns and clears the long requests that consoles end."""
        requests, self.cancelled = self.cancelled, []
        return requests

    def take_device_messages(self) -> list[tuple[str, wire.DeviceMessage]]:
        """Returns and clears what pages say of devices, each with the client."""
        said, self.device_messages = self.device_messages, []
        return said

    def clock(self, now: float) -> float:
        """The show's clock at `now`, as in `State.time`: it runs on through a restart of the server."""
        return self._time if self._now is None else self._time + max(0.0, now - self._now)

    @property
    def crew(self) -> dict[str, Member]:
        """Who is connected."""
        return self.members.present

    def join(self, who: str, name: str, seat: str = "") -> None:
        """Adds a source, such as a sender of OSC: it plays as a console does, but hears nothing and needs no hello.
        seat: that of the member (`crew`) for whom it plays, where it plays not for itself."""
        self.members.join(who, name, seat)

    def leave(self, who: str, *, lost: float | None = None) -> None:
        """Removes a client; T-bars and channels that it held stay as they are. lost: when its link broke, where its
        page was not closed."""
        self.members.leave(who, lost=lost)
        self._hands.leave(who)
        self.sources.leave(who, self.scene)

    def crew_now(self, now: float) -> wire.Crew:
        """Who is connected, and what each stage draws."""
        return self.members.now(now)

    def notices_for(self, who: str) -> list[Outgoing]:
        """All notices for a console; nothing where there are none, or for a stage."""
        wanted = self.notices and self.members[who].role == "console"
        return [Outgoing(who, wire.Notices(list(self.notices)))] if wanted else []

    def layouts_now(self) -> list[Outgoing]:
        """The names of all layouts, for every console."""
        return self.for_consoles(wire.Layouts(list(self.layouts)))

    def for_consoles(self, message: wire.FromServer) -> list[Outgoing]:
        """A message for every console."""
        return [Outgoing(who, message) for who in self.members.consoles()]

    def hands_now(self, now: float) -> list[Outgoing]:
        """What consoles must be told of each other's hands, of who holds what, and of the sources."""
        consoles, sources = self.members.consoles(), self.members.sources()
        hands, leases = self._hands.tell(consoles, now, sources), self.leasing.tell(now)
        news, found = self.sources.news(consoles, now), self._sound_stage.tell(self.crew, now)
        found += [Outgoing(*told) for each in (hands, leases) for told in each.items()]
        found += [Outgoing(who, values) for who, values in self.sources.tell_watchers(now)]
        return found if news is None else [*found, *self.for_consoles(news)]

    def _answer(self, who: str, message: wire.FromClient, now: float) -> list[Outgoing]:
        match message:
            case wire.Hello():
                welcomes = self._welcome(who, message)
                layouts = [each for each in self.layouts_now() if each.who == who and self.layouts]
                return [*welcomes, *self.notices_for(who), *layouts]
            case wire.Ping():
                pong = wire.Pong(validate_number(message.sent, validation.SENT), self.clock(now))
                return [Outgoing(who, pong)]
            case wire.Drawing():
                self.members.report(who, report_in(message), now)
                with refuse_errors(message):
                    self.scene.note_camera(message.name, message.camera)
            case wire.Cancel():
                self.members.refuse_a_stage(who, message)
                self.cancelled.append(message.request)
            case _ if getattr(message, "id", None) in self._calls:
                pass  # a retry or a bouncing key: each call executes once
            case _ if isinstance(message, wire.DeviceMessage):
                self._collect(who, message)
            case _ if isinstance(message, wire.KeepMessage):
                self._add_keep_request(KeepRequest(who, message))
            case _:
                return self._obey(who, message, now)
        return []

    def _hear_source(self, who: str, message: wire.SourceMessage) -> list[Outgoing]:
        self.members.refuse_a_stage(who, message)
        with refuse_errors(message):
            answer = self.sources.hear(who, message, self.scene, self.cast)
        return [] if answer is None else [Outgoing(who, answer)]

    def _collect(self, who: str, message: wire.DeviceMessage) -> None:
        self.members.refuse_a_stage(who, message)
        if len(self.device_messages) >= MOST_DEVICE_MESSAGES:
            raise Refusal("too much comes from devices at once, and this was not played: send less.")
        self.device_messages.append((who, message))
        if isinstance(message, wire.BindingMessage):
            self._remember(message.id)

    def _add_keep_request(self, request: KeepRequest) -> None:
        self.members.refuse_a_stage(request.who, request.message)
        if isinstance(request.message, wire.KeepFace | wire.KeepExpression):
            refuse_unknown(self.scene, request.message.character)
        self.wishes.append(request)
        if request.message.id:
            self._remember(request.message.id)

    def _lease(self, who: str, message: wire.LeaseMessage) -> list[Outgoing]:
        told = self.leasing.obey(who, message, tuple(self.scene))
        self._remember(message.id)
        return [Outgoing(other, claim) for other, claim in told]

    def _remember(self, call: str) -> None:
        self._calls[call] = None
        if len(self._calls) > REMEMBERED_CALLS:
            del self._calls[next(iter(self._calls))]

    def _obey(self, who: str, message: wire.FromClient, now: float) -> list[Outgoing]:
        self.members.refuse_a_stage(who, message)
        if isinstance(message, wire.LeaseMessage):
            return self._lease(who, message)
        if isinstance(message, wire.SourceMessage):
            return self._hear_source(who, message)
        self._panics.refuse_late(who, message, meant := find_addressed(self.scene, message), now)
        self.leasing.check(who, message, meant)
        with refuse_errors(message):
            if isinstance(message, SOURCE_CHANGES):
                self.sources.change(message, self.scene)
            else:
                carry_out(self.scene, self.sounds.complete(message))
        self.commands += 1
        self._hands.note(who, message, characters := find_addressed(self.scene, message), now)
        self.leasing.note(who, message, characters)
        if isinstance(message, wire.Panic):
            self._panics.press(who, characters, now)
            self._hands.take_off(characters)
        if isinstance(message, wire.AddCharacter):
            self._panics.forget(message.character)  # what was of another of the same name, which is gone
            self._eye_offsets.pop(message.character, None)
        if getattr(message, "id", ""):
            self._remember(message.id)  # type: ignore[union-attr]
        return []

    def _welcome(self, who: str, hello: wire.Hello) -> list[Outgoing]:
        """The welcome of a client; another's too, where that was given the name that a console claims."""
        if hello.version != wire.PROTOCOL_VERSION:
            versions = f"version {hello.version}, the server {wire.PROTOCOL_VERSION}"
            raise Refusal(f"the page speaks {versions}: reload the page.")
        for other in self.members.links_of_page(hello.page) if hello.role == "console" else ():
            self.leave(other)
        return [self._welcomed(each) for each in self.members.admit(who, hello)]

    def _welcomed(self, who: str) -> Outgoing:
        version, name = wire.PROTOCOL_VERSION, self.crew[who].name
        return Outgoing(who, wire.Welcome(version, self.epoch, self.revision, self.cast.digest, name, self.show))

    def _refuse(self, who: str, refusal: Refusal, message: str, now: float) -> list[Outgoing]:
        self.refused += 1
        held = refusal.held if isinstance(refusal, HeldByOthersRefusal) else {}
        told = [Outgoing(other, claim) for other, claim in self.leasing.claims(who, held, now)] if held else []
        return [Outgoing(who, wire.Refused(str(refusal), message, list(held))), *told]
