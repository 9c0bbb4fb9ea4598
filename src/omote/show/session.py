"""The show session without input or output: messages and times in, messages and states out; a log of them replays."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import msgspec

from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_snapshot import names_held_by
from omote.perform.snapshot import NamesHeld, Playable
from omote.show.access.access_role import explain_missing_role, role_allows
from omote.show.clips.show_clips import NO_WORK, ShowClips
from omote.show.crew.members import Member, Members
from omote.show.cues.cue_lines import speak_lines
from omote.show.cues.cue_lists import CueLists
from omote.show.declaration import (
    ClientMessage,
    DeviceMessage,
    KeepRequest,
    Outgoing,
    ServerMessage,
    call_by_name,
    characters_of,
    check_ranges,
)
from omote.show.executed_calls import ExecutedCalls
from omote.show.mapping_learning import MappingLearning
from omote.show.memory_list import MemoryListing, list_memories
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.documents import NAMES_OF
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Bus, Hello, Notice, Notices, Refused, Welcome
from omote.show.objects.show_notes import ShowNotes
from omote.show.objects.speech import SayByVoice
from omote.show.objects.stages import CastChanged, Crew
from omote.show.objects.state import State
from omote.show.ownership.hands import HandReports, Panics
from omote.show.ownership.leasing import HeldByOthersRefusal, LeaseSnapshot, Leasing
from omote.show.pad_list import PadListing, list_pads
from omote.show.preview_bus import PreviewBus
from omote.show.session_snapshot import SessionSnapshot
from omote.show.sources.open_sources import OpenSources
from omote.show.sources.sources_snapshot import Route, SurfaceSubscription
from omote.show.speech.known_sounds import KnownSounds
from omote.show.speech.named_sounds import NamedSounds
from omote.show.speech.sound_stage import SoundStage
from omote.show.speech.texts_to_speak import TextsToSpeak, TextToSpeak
from omote.show.state import EyeOffset, offset_between, preview_state, state_of
from omote.show.told_mappings import ToldMappings
from omote.show.validation import Refusal
from omote.show.wire import decode, id_in

MOST_DEVICE_MESSAGES = 4096
"""Of devices, between two ticks."""


class Unrecorded:
    """Notes nothing of what a session does: what a recorder (`recording/recorder.py`) is asked for."""

    records = False
    """Whether there is a recording, whose moments can be marked."""

    def note_message(self, who: str, message: ClientMessage, now: float) -> None:
        """Notes a message of a client (who) that was obeyed. now: seconds, monotonic."""

    def note_channels(self, who: str, character: str, values: Mapping[str, float], now: float) -> None:
        """Notes channels of a character that a client (who) has set. values: weights by channel; now: seconds,
        monotonic."""

    def note_left(self, who: str) -> None:
        """Notes that a client (who) has left."""

    def note_routed(self, source: str, route: Route) -> None:
        """Notes that a source has taken over. route: what it plays."""

    def note_sounds(self, seconds: Mapping[str, float], called: Mapping[str, str]) -> None:
        """Notes the sounds that there are, by their seconds. called: keys by name."""

    def note_recast(self, digest: str) -> None:
        """Notes that another cast plays. digest: of the cast."""

    def note_rejected(self, said: str) -> None:
        """Notes why (said) a line of a cue was not said."""

    def note_clips(self) -> None:
        """Notes the clips as an edit has left them."""

    def note_edit(self) -> None:
        """Notes the cues as an edit has left them."""

    def note_tick(self, now: float) -> None:
        """Notes a tick. now: seconds, monotonic."""


class ShowSession:
    """A running show: who is connected, what has been called, what is on air."""

    def __init__(self, cast: Playable, scene: Scene | None = None, *, epoch: int = 1, revision: int = 1) -> None:
        self.cast = cast
        self.epoch = epoch
        self.revision = revision
        self.scene = Scene.begun(cast) if scene is None else scene
        self.number = 0
        self.refused = 0
        self.commands = 0
        self.members = Members()
        self.wishes: list[KeepRequest] = []
        self.cancelled: list[str] = []
        self.device_messages: list[tuple[str, DeviceMessage]] = []
        self.notices: list[Notice] = []
        self.documents: dict[str, list[str]] = {}
        self.show = ""
        self.notes = ShowNotes()
        self._executed = ExecutedCalls()
        self._now: float | None = None
        self._time = self.scene.snapshot().time
        self._told: list[Outgoing] = []
        self._eye_offsets: dict[str, EyeOffset] = {}
        self._panics = Panics()
        self.sources = OpenSources()
        self.surfaces: tuple[SurfaceSubscription, ...] = ()
        self.sounds = KnownSounds()
        self._sent_sounds: dict[str, float] = {}
        self.named_sounds = NamedSounds(self._tell_sounds)
        self.recorder = Unrecorded()
        self.cues = CueLists(lambda: self.scene, lambda who: self.members[who].name, lambda: self.recorder.note_edit())
        self.preview = PreviewBus(lambda: self.scene, lambda: self.cast)
        self.preview_state: State | None = None
        self.plays_preview = True
        """Not in a replay: what a take and a record read of the preview stands before them in the recording."""
        self.lost: list[str] = []
        self.renamed_pads: list[tuple[str, str]] = []
        self.clips = ShowClips(
            lambda: self.scene,
            lambda: self.cast,
            lambda sound: self.sounds.check(sound),
            self.list_documents,
            lambda message: self.act("", message, self._now or 0.0),
            lambda: self.recorder.note_clips(),
            lambda said: self.lost.append(said),
        )
        self._pads = PadListing(self.scene.pads, cast)
        self._memories = MemoryListing(self.scene.memories)
        self.texts = TextsToSpeak()
        self.mappings = ToldMappings(lambda: self.scene, lambda: self.cast)
        self.setups = set[str]()
        self.learning = MappingLearning(lambda: self.scene, lambda who: self.members[who].name)
        self._sound_stage = SoundStage()
        self.recording_requests: list[KeepRequest] = []
        self._own(None)

    @classmethod
    def restored(cls, cast: Playable, snapshot: SessionSnapshot, *, epoch: int, revision: int = 1) -> ShowSession:
        """The show of a snapshot, under a new epoch; ValueError when the snapshot does not fit the cast. revision: of
        the cast."""
        if not snapshot.scene.characters:
            raise ValueError("the scene of the snapshot is empty; a show has a character")
        session = cls(cast, Scene.restored(cast, snapshot.scene), epoch=epoch, revision=revision)
        session._executed = ExecutedCalls(snapshot.executed)
        session.sources = OpenSources(snapshot.sources)
        session.notes = snapshot.notes
        session.cues.restore(snapshot.cues)
        session.surfaces = snapshot.surfaces
        session._own(snapshot.leases)
        if snapshot.preview is not None:
            try:
                session.preview.restore(snapshot.preview)
            except (ValueError, TypeError) as error:
                session._lose_preview(error)
        return session

    def _own(self, snapshot: LeaseSnapshot | None) -> None:
        """Begins with one table of who holds, wants and moves what; snapshot: the leases of before."""
        self.leasing = Leasing(self.members, snapshot, lambda: self.scene)
        self._hands = HandReports(self.leasing.table)

    def snapshot(self) -> SessionSnapshot:
        """The show as it is now."""
        return SessionSnapshot(
            self.scene.snapshot(),
            self._executed.snapshot(),
            self.leasing.snapshot(),
            self.sources.snapshot(),
            self.notes,
            self.cues.snapshot(),
            self.surfaces,
            self.preview.snapshot(),
        )

    def receive_bytes(self, who: str, data: bytes, now: float) -> list[Outgoing]:
        """Handles the bytes of a client and returns the answers; invalid bytes are rejected and counted. who: the
        client; data: one message; now: seconds, monotonic."""
        try:
            message = decode(data)
        except Refusal as refusal:
            return self._refuse(who, refusal, id_in(data), now)
        return self.receive(who, message, now)

    def receive(self, who: str, message: ClientMessage, now: float) -> list[Outgoing]:
        """Handles a message and returns the answers; an invalid one is rejected with a message and changes nothing.

        who: the client; now: seconds, monotonic.
        """
        try:
            return self._obey(who, message, now)
        except Refusal as refusal:
            return self._refuse(who, refusal, getattr(message, "id", ""), now)

    def _obey(self, who: str, message: ClientMessage, now: float) -> list[Outgoing]:
        """Does what a message asks for, between the gates and the echoes, which ask its declaration alone."""
        self._pass_role(who, message)
        if self._is_executed(who, message):
            return []  # a retry or a bouncing key
        message = self.sounds.by_key(call_by_name(message, self.cast))
        unseen = message.follows_bus and self.members.looks_at(who) == "preview"
        characters = () if unseen else find_addressed(self.scene, message)
        if not unseen:
            self._pass_hands(who, message, characters, now)
        touched = {} if unseen or not self.learning.is_learner(who) else self.learning.positions(message)
        answers = self.act(who, message, now, unseen=unseen)
        if touched:
            self.learning.touch(message, touched, now)
        self.commands += message.open_to == "consoles"
        self._echo(who, message, characters, now, unseen=unseen)
        return list(answers)

    def act(self, who: str, message: ClientMessage, now: float, *, unseen: bool = False) -> Sequence[Outgoing]:
        """Does what a message asks for that the gates have let through, and notes it; Refusal where it cannot be done.
        who: the client; message: with the names of what it calls; now: seconds, monotonic; unseen: in preview, of
        which no recording is made."""
        try:
            check_ranges(message)
            answers = message.act(self.preview.session(self) if unseen else self, who, now)
        except (ValueError, TypeError) as error:
            raise refusal_of(error, message) from error
        if message.recorded and not unseen:
            self.recorder.note_message(who, message, now)
        return answers

    def _pass_role(self, who: str, message: ClientMessage) -> None:
        """The first gates: who may send it at all. Refusal where one is shut."""
        held = self.members.visitor(who).role
        if not role_allows(held, message.access):
            raise Refusal(explain_missing_role(held, message.access))
        if message.open_to == "consoles":
            self.members.refuse_a_stage(who, message)

    def _pass_hands(self, who: str, message: ClientMessage, characters: Sequence[str], now: float) -> None:
        """The last gates: what a panic or a lease keeps from the hands of others. Refusal where one is shut."""
        self._panics.refuse_late(who, message, characters, now)
        try:
            self.leasing.check(who, message, characters)
        except HeldByOthersRefusal:
            try:
                message.check_names(self)  # nobody is asked for parts for the sake of what there is not
            except (ValueError, TypeError) as error:
                raise refusal_of(error, message) from error
            raise

    def _echo(self, who: str, message: ClientMessage, characters: Sequence[str], now: float, *, unseen: bool) -> None:
        """What follows from a message that was obeyed: others see the hand, its part is held, unless it was unseen; its
        id is executed. characters: whom it was for."""
        if not unseen:
            if message.hand is None:
                characters = find_addressed(self.scene, message)  # there may be others since
            self._hands.note(who, message, characters, now)
            self.leasing.note(who, message, characters)
        call = id_of(message)
        if call:
            self._executed.note(self.members[who].seat, call)

    def _is_executed(self, who: str, message: ClientMessage) -> bool:
        call = id_of(message)
        return call != "" and self._executed.has(self.members[who].seat, call)

    def set_channels(self, who: str, character: str, values: Mapping[str, float], now: float) -> bool:
        """Sets channels of a character as a `SetChannel` each would, with one look at who may; False where one of them
        would be rejected: then nothing has changed. who: the client; values: weights by channel; now: seconds,
        monotonic."""
        message = SetChannel(character, *next(iter(values.items())))
        try:
            self._pass_role(who, message)
            self._pass_hands(who, message, (character,), now)
            self.scene[character].set_channels(values)
        except (KeyError, ValueError, TypeError):  # a Refusal is a ValueError
            return False
        self.commands += len(values)
        self.recorder.note_channels(who, character, values, now)
        self._hands.note_channels(who, character, values, now)
        self.leasing.note(who, message, (character,))
        return True

    def tick(self, now: float) -> State:
        """Advances the show to `now` (seconds, monotonic) in one step and returns what is on air."""
        elapsed = 0.0 if self._now is None else max(0.0, now - self._now)
        self._now = now
        self.number += 1
        self.leasing.expire(tuple(self.scene), now)
        self._told += self.clips.end_passes()
        if self.learning.is_over(now):
            self._told += self.finish_mapping(now, keeps=True)
        speak_lines(self, now)
        state = self._state(elapsed)
        self.recorder.note_tick(now)
        return state

    def resume(self, now: float | None, number: int, eye_offsets: Mapping[str, EyeOffset]) -> None:
        """Goes on after a tick of a recording. now: of that tick, seconds, monotonic, None before the first; number: of
        its state; eye_offsets: by character."""
        self._now = now
        self.number = number
        self._eye_offsets = dict(eye_offsets)

    @property
    def now(self) -> float | None:
        """When the last tick was, seconds, monotonic; None before the first."""
        return self._now

    @property
    def eye_offsets(self) -> dict[str, EyeOffset]:
        """What is added to the eyes since the cast changed, by character."""
        return dict(self._eye_offsets)

    def _state(self, elapsed: float) -> State:
        frame = self.cues.advance(elapsed)
        self._time = frame.time
        self.clips.note(frame)
        numbers = {"epoch": self.epoch, "number": self.number, "revision": self.revision}
        cues = self.cues.status(self._now or 0.0)
        sounds = self.sounds.find
        state = state_of(self.cast, frame, self._eye_offsets, notes=self.notes, cues=cues, sounds=sounds, **numbers)
        self.preview_state = self._unseen(state) if self.plays_preview and self.members.any_in_preview else None
        return state

    def _unseen(self, air: State) -> State | None:
        """The state of the preview at the time of the one on air; None where it cannot be played."""
        looked_at = self.cues.name_of(self.preview.looked_at)
        try:
            return preview_state(self.cast, self.preview.advance(air.time), air, looked_at)
        except Exception as error:  # whatever it is, the show goes on
            self._lose_preview(error)
            return None

    def _lose_preview(self, error: Exception) -> None:
        self.preview.forget()
        self.lost.append(f"what was built up in preview cannot be played ({error}) and is forgotten.")

    def take_lost(self) -> list[str]:
        """Returns and clears what of the preview, of passes and of pads was lost, in sentences for the crew."""
        lost = self.lost
        self.lost = []
        return lost

    def take_renamed_pads(self) -> list[tuple[str, str]]:
        """Returns and clears what pads were called and are called now, for what names them outside of the session."""
        renamed = self.renamed_pads
        self.renamed_pads = []
        return renamed

    def recast(self, cast: Playable) -> CastChanged:
        """Plays another cast from now on; returns the message for all pages. ValueError where it lacks what is on
        air.

        Stages ease what the skin does; the eyes, whose angles the state holds, ease here.
        """
        shown = self._state(0.0)
        preview = self.preview.recast(cast)
        self.scene.recast(cast)
        self.cast = cast
        self.preview.play(preview)
        self._eye_offsets = {}
        for name, wanted in self._state(0.0).characters.items():
            self._eye_offsets[name] = offset_between(shown.characters[name].eyes, wanted.eyes, shown.time)
        self.revision += 1
        self.recorder.note_recast(cast.digest)
        return CastChanged(self.revision, cast.digest)

    def names_held(self) -> NamesHeld:
        """The names that the cast must not lose: they are on air or in preview, called or going."""
        held = names_held_by(self.scene.snapshot())
        preview = self.preview.snapshot()
        return held if preview is None else held.with_others(names_held_by(preview.scene))

    def take_keep_requests(self) -> list[KeepRequest]:
        """Returns and clears the consoles' requests to keep something."""
        requests = self.wishes
        self.wishes = []
        return requests

    def take_recording_requests(self) -> list[KeepRequest]:
        """Returns and clears what consoles ask of the recording."""
        requests = self.recording_requests
        self.recording_requests = []
        return requests

    def take_cancelled(self) -> list[str]:
        """Returns and clears the long requests that consoles end."""
        requests = self.cancelled
        self.cancelled = []
        return requests

    def take_device_messages(self) -> list[tuple[str, DeviceMessage]]:
        """Returns and clears what pages say of devices, each with the client."""
        said = self.device_messages
        self.device_messages = []
        return said

    def clock(self, now: float) -> float:
        """The show's clock at `now`, as in `State.time`: it runs on through a restart of the server."""
        return self._time if self._now is None else self._time + max(0.0, now - self._now)

    @property
    def crew(self) -> dict[str, Member]:
        """Who is connected."""
        return self.members.present

    def join(self, who: str, name: str, seat: str = "", bus: Bus = "air") -> None:
        """Adds a source, such as a sender of OSC: it plays as a console does, but hears nothing and needs no hello.
        seat: that of the member (`crew`) for whom it plays, where it plays not for itself. who: the client; name: what
        it is called; bus: which it plays on."""
        self.members.join(who, name, seat, bus)

    def leave(self, who: str, *, lost: float | None = None) -> None:
        """Removes a client; T-bars and channels that it held stay as they are. lost: when its link broke, where its
        page was not closed. who: the client."""
        if self.learning.is_learner(who):
            self.learning.end(keeps=False)
        self.members.leave(who, lost=lost)
        if not self.preview.touched and not self.members.any_in_preview:
            self.preview.forget()
        self._hands.leave(who)
        self.sources.leave(who, self.scene)
        self.recorder.note_left(who)

    def set_sounds(self, seconds: dict[str, float]) -> None:
        """Notes the sounds that programs have sent and that there are now, and no others, with their seconds."""
        self._sent_sounds = dict(seconds)
        self._note_sounds()

    def _note_sounds(self) -> None:
        seconds = {**self._sent_sounds, **self.named_sounds.seconds()}
        called = self.named_sounds.called()
        self.sounds.set(seconds, called)
        self.recorder.note_sounds(seconds, called)

    def _tell_sounds(self) -> None:
        self._note_sounds()
        self._told += self.for_consoles(self.named_sounds.message())

    def crew_now(self, now: float) -> Crew:
        """Who is connected, and what each stage draws."""
        return self.members.now(now)

    def notices_for(self, who: str) -> list[Outgoing]:
        """All notices for a console; nothing where there are none, or for a stage."""
        wanted = self.notices and self.members[who].role == "console"
        return [Outgoing(who, Notices(list(self.notices)))] if wanted else []

    def list_documents(self, kind: str, names: list[str]) -> list[Outgoing]:
        """Notes the documents of a kind that pages keep, and returns them for every console; names: sorted."""
        self.documents[kind] = names
        return self.for_consoles(NAMES_OF[kind](names))

    def for_consoles(self, message: ServerMessage) -> list[Outgoing]:
        """A message for every console."""
        return [Outgoing(who, message) for who in self.members.consoles()]

    def hands_now(self, now: float) -> list[Outgoing]:
        """What consoles must be told of each other's hands, of who holds what, and of the sources."""
        consoles = self.members.consoles()
        sources = self.members.sources()
        hands = self._hands.tell(consoles, now, sources)
        leases = self.leasing.tell(now)
        news = self.sources.news(consoles, now)
        taken = {} if news is None else self.sources.take_over(self.scene, now)
        for source, route in taken.items():
            self.recorder.note_routed(source, route)
        pads = self._pads.news(self.scene.pads, self.cast, now)
        memories = self._memories.news(self.scene.memories)
        news_of_all = (self.clips.news(), self.mappings.news(), self.learning.news(), pads, memories)
        told = [each for message in news_of_all if message is not None for each in self.for_consoles(message)]
        outgoing = [*self._told, *told, *self._sound_stage.tell(self.crew, now)]
        self._told = []
        on_air = [pair for told in (hands, leases) for pair in told.items() if self.members.looks_at(pair[0]) == "air"]
        outgoing += [Outgoing(*pair) for pair in on_air]
        outgoing += [Outgoing(who, values) for who, values in self.sources.tell_watchers(now)]
        return outgoing if news is None else [*outgoing, *self.for_consoles(news)]

    def collect(self, who: str, message: DeviceMessage) -> None:
        """Keeps what a page says of devices until the next tick; Refusal where too much comes at once. who: the client;
        message: what it says."""
        if len(self.device_messages) >= MOST_DEVICE_MESSAGES:
            raise Refusal("too much comes from devices at once, and this was not played: send less.")
        self.device_messages.append((who, message))

    def finish_mapping(self, now: float, *, keeps: bool) -> list[Outgoing]:
        """Ends the learning of a mapping, by messages of who taught it; returns what is answered. now: seconds,
        monotonic; keeps: whether it becomes one."""
        who, messages = self.learning.end(keeps=keeps)
        return [answer for message in messages for answer in self.receive(who, message, now)]

    def take_hands_off(self, who: str, characters: Sequence[str], now: float) -> None:
        """Takes characters out of all hands: a client (who) has pressed panic, at `now` (seconds, monotonic)."""
        self._panics.press(who, characters, now)
        self.texts.drop(characters)
        self._hands.take_off(characters)

    def scene_of(self, who: str) -> Scene:
        """The scene that a client looks at: on air, or in preview. who: the client."""
        return self.preview.scene() if self.members.looks_at(who) == "preview" else self.scene

    def ask_to_speak(self, who: str, message: SayByVoice, characters: Sequence[str]) -> None:
        """Has a voice speak a text for characters. who: the client; message: with the text; characters: their
        names."""
        self.texts.ask(TextToSpeak(who, message, tuple(characters)))

    def reject_line(self, said: str) -> None:
        """Tells consoles why (said) a line of a cue was not said."""
        self.cues.reject(said)
        self.recorder.note_rejected(said)

    def forget_character(self, character: str) -> None:
        """Forgets what was of another character of the same name, which is gone."""
        self.texts.drop([character])
        self.preview.forget_character(character)
        self._panics.forget(character)
        self._eye_offsets.pop(character, None)

    def welcome(self, who: str, hello: Hello) -> list[Outgoing]:
        """Admits a client; returns its welcome and all that it must know at first. Another is welcomed too, where that
        was given the name that a console claims. Refusal for another version. who: the client; hello: what it says of
        itself."""
        if hello.version != PROTOCOL_VERSION:
            versions = f"version {hello.version}, the server {PROTOCOL_VERSION}"
            raise Refusal(f"the page speaks {versions}: reload the page.")
        for other in self.members.links_of_page(hello.page) if hello.role == "console" else ():
            self.leave(other)
        welcomes = [self._welcomed(client) for client in self.members.admit(who, hello)]
        documents = self.documents.items() if hello.role == "console" else ()
        lists = [Outgoing(who, NAMES_OF[kind](names)) for kind, names in documents if names]
        if hello.role == "console" and self.clips.work != NO_WORK:
            lists.append(Outgoing(who, self.clips.work))
        if hello.role == "console" and (mappings := self.mappings.list_now()).mappings:
            lists.append(Outgoing(who, mappings))
        if hello.role == "console" and self.named_sounds.sounds:
            lists.append(Outgoing(who, self.named_sounds.message()))
        if hello.role == "console" and self.scene.pads:
            lists.append(Outgoing(who, list_pads(self.scene.pads, self.cast)))
        if hello.role == "console" and self.scene.memories:
            lists.append(Outgoing(who, list_memories(self.scene.memories)))
        return [*welcomes, *self.notices_for(who), *lists]

    def _welcomed(self, who: str) -> Outgoing:
        version = PROTOCOL_VERSION
        name = self.crew[who].name
        return Outgoing(who, Welcome(version, self.epoch, self.revision, self.cast.digest, name, self.show))

    def _refuse(self, who: str, refusal: Refusal, message: str, now: float) -> list[Outgoing]:
        self.refused += 1
        held = refusal.held if isinstance(refusal, HeldByOthersRefusal) else {}
        claims = self.leasing.claims(who, held, now) if held else []
        return [Outgoing(who, Refused(str(refusal), message, list(held))), *claims]


def find_addressed(scene: Scene, message: ClientMessage) -> tuple[str, ...]:
    """The characters that a message is for; none for one of the whole scene, or that names nobody there is."""
    character = getattr(message, "character", "")
    if character in scene:
        return (character,)
    return characters_of(scene, character) if character == ALL else ()


def id_of(message: ClientMessage) -> str:
    """The id for which a message executes once; "" for one that executes however often it comes."""
    call: str = getattr(message, "id", "")
    return call if message.once else ""


def refusal_of(error: ValueError | TypeError, message: ClientMessage) -> Refusal:
    """The Refusal that says why a message could not be done. error: why."""
    return error if isinstance(error, Refusal) else Refusal(f"{error}. Nothing has changed.{reload_hint(message)}")


def reload_hint(message: ClientMessage) -> str:
    """What to do about a number that no hand can have set: the page that sent it has gone wrong."""
    values = msgspec.structs.astuple(message)
    wrong = any(isinstance(value, float) and not math.isfinite(value) for value in values)
    return " Send a finite number; a page that sends another is to be reloaded." if wrong else ""
