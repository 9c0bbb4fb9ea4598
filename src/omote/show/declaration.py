"""What a message is, and what a command of a client declares once: all tables of the show are derived from this.

A noun of the show is a module in `objects/`: its commands, what the server tells of it and what is stored of it. A
command says its fields, which role it needs (`access`), the part that it plays (`plays`), whether a hand moves it on
and on (`hand`), its addresses of OSC (`osc`) and what it does (`act`). The union of messages, roles, leases, hands,
OSC, bindings, the methods of `omote.connect`, TypeScript and the pages of the wire follow from that.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from types import ModuleType
from typing import Annotated, Any, ClassVar, Literal, Protocol, TypeVar, get_args, get_origin, get_type_hints

import msgspec

from omote.perform.called_names import find_called
from omote.perform.lights import LIGHTS
from omote.perform.limits import LONGEST_CALL, check_known, check_within
from omote.perform.performer import Performer
from omote.perform.scene.character_names import ALL, check_character
from omote.perform.scene.scene import Scene
from omote.perform.snapshot import Playable
from omote.show.access.access_role import HIGHEST, AccessRole
from omote.show.osc import Osc, Value

MESSAGE_LIMIT = 4096
SPEECH_LIMIT = 32768
"""Bytes; no message of a client is longer, and no `say`: 2000 characters of any script and the times of 1000 words."""
MOST_NAMES = 200
"""Channels of a source."""

Name = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
CharacterName = Annotated[str, msgspec.Meta(min_length=1, max_length=24)]
CallId = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]
OptionalCallId = Annotated[str, msgspec.Meta(max_length=64)]
RequestId = Annotated[str, msgspec.Meta(max_length=64)]
FaceName = Annotated[Name, Value("face")]
ExpressionName = Annotated[Name, Value("expression")]
ChannelName = Annotated[Name, Value("channel")]
PoseName = Annotated[Name, Value("pose")]
BodyName = Annotated[Name, Value("body")]
CallSeconds = Annotated[float | None, Value("seconds", high=LONGEST_CALL, unit="s")]
"""Seconds of a call; `None`: by hand, the T-bar moves it."""
Seconds = Annotated[float, Value("time", high=LONGEST_CALL, unit="s")]
Position = Annotated[float, Value(name="position")]
"""Where a T-bar stands, 0..1."""

Hand = Literal["plays", "moves"]
"""`plays`: a hand sends it on and on, and a panic takes it out of the hand; `moves`: a hand sends it on and on."""


def snake_case(name: str) -> str:
    """The tag of a message class: `CallFace` gives `call_face`."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


class Message(msgspec.Struct, frozen=True, tag_field="type", tag=snake_case):
    """A message with its tag."""


Declared = TypeVar("Declared", bound=Message)


class ServerMessage(Message, frozen=True):
    """A message of the server."""


@dataclass(frozen=True)
class Outgoing:
    """A message for one client."""

    who: str
    message: ServerMessage


class Session(Protocol):
    """What a command may change of the session of a show (`show/session.py`)."""

    scene: Scene
    preview: Any
    cast: Playable
    members: Any
    sources: Any
    sounds: Any
    named_sounds: Any
    texts: Any
    leasing: Any
    notes: Any
    cues: Any
    clips: Any
    wishes: list[Any]
    lost: list[str]
    renamed_pads: list[tuple[str, str]]
    learning: Any
    setups: set[str]
    recorder: Any
    recording_requests: list[Any]
    cancelled: list[str]
    epoch: int
    number: int

    def join(self, who: str, name: str) -> None:
        """Adds a source. who: the client; name: what it is called."""

    def receive(self, who: str, message: Any, now: float) -> list[Outgoing]:
        """Handles a message. who: the client; message: what it asks for; now: seconds, monotonic."""

    def welcome(self, who: str, hello: Any) -> list[Outgoing]:
        """Admits a client that says hello. who: the client."""

    def clock(self, now: float) -> float:
        """The show's clock."""

    def finish_mapping(self, now: float, *, keeps: bool) -> Sequence[Outgoing]:
        """Ends the learning of a mapping. now: seconds, monotonic; keeps: whether it becomes one."""

    def ask_to_speak(self, who: str, message: Any, characters: Sequence[str]) -> None:
        """Has a voice speak a text for characters. who: the client; message: with the text; characters: their names."""

    def collect(self, who: str, message: Any) -> None:
        """Keeps what a page says of devices until the next tick. who: the client; message: what it says."""

    def take_hands_off(self, who: str, characters: Sequence[str], now: float) -> None:
        """Takes characters out of all hands: somebody pressed panic. who: the client that pressed; characters: their
        names; now: seconds, monotonic."""

    def reject_line(self, said: str) -> None:
        """Tells consoles why (said) a line of a cue was not said."""

    def forget_character(self, character: str) -> None:
        """Forgets what was of another character of the same name."""

    def scene_of(self, who: str) -> Scene:
        """The scene that a client looks at: on air, or in preview. who: the client."""


class ClientMessage(Message, frozen=True):
    """A message of a client, with what the session must know of it before it acts.

    access: the role that it needs, the highest where nobody has thought of it. open_to: who may send it. plays: the
    part of a character or of the scene that it plays, or several, `*` for all of its character; None where it passes
    whoever holds what. follows_bus: whether it acts on the scene that its sender looks at, air or preview, and not on
    air whoever sends it. holds: whether who plays its part holds it from then on. hand: how a hand sends it. once:
    whether one that has an id executes once for it. recorded: whether a recording of the show keeps it: one that only
    concerns its sender's link, who may play, devices or the show file is not kept. reads_preview: whether what it does
    on air follows from the preview. longest: bytes. osc: its addresses of OSC. method: what `omote.connect` calls it,
    "" for its tag, None where a program has no method for it.
    """

    access: ClassVar[AccessRole] = HIGHEST
    open_to: ClassVar[Literal["consoles", "everybody"]] = "consoles"
    plays: ClassVar[str | tuple[str, ...] | None] = None
    follows_bus: ClassVar[bool] = False
    holds: ClassVar[bool] = True
    hand: ClassVar[Hand | None] = None
    once: ClassVar[bool] = True
    recorded: ClassVar[bool] = True
    reads_preview: ClassVar[bool] = False
    longest: ClassVar[int] = MESSAGE_LIMIT
    osc: ClassVar[tuple[Osc, ...]] = ()
    method: ClassVar[str | None] = None

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Does what it asks for and returns what is answered; ValueError or TypeError where it cannot be done, and then
        nothing has changed. session: the show; who: the client; now: seconds, monotonic."""
        raise NotImplementedError(f"{type(self).__name__} declares no act")

    def check_names(self, session: Session) -> None:
        """Raises ValueError where it calls something that there is not: whoever holds what, that is told first."""
        for name, value in values_of(type(self)).items():
            typed = getattr(self, name)
            names = called_names(session.cast).get(value.kind)
            if names is not None and isinstance(typed, str):
                check_known(typed, names, value.kind)

    def parts_played(self, scene: Scene) -> tuple[str, ...]:
        """The parts of a character or of the scene that it plays; none where it passes whoever holds what. scene: that
        it is for."""
        plays = () if self.plays is None else self.plays
        return (plays,) if isinstance(plays, str) else plays

    def control(self, character: str) -> str:
        """The control of a character that a hand moves by it: the message's tag, and more where one tag has several."""
        return f"{character}/{tag_of(type(self))}"


class CharacterCommand(ClientMessage, frozen=True):
    """A command for one character, or `*` for all of them."""

    access = "operate"
    follows_bus: ClassVar[bool] = True
    method: ClassVar[str | None] = ""

    character: CharacterName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it on all characters that it is for, or on none: where one rejects it (each has macros of its own), the
        others are as they were. session: the show; who: the client; now: seconds, monotonic."""
        scene = session.scene
        if self.character in scene:  # nearly always
            self.play(scene[self.character])
            return ()
        performers = [scene[name] for name in characters_of(scene, self.character)]
        before = [dict(vars(performer)) for performer in performers]
        try:
            for performer in performers:
                self.play(performer)
        except (ValueError, TypeError):
            for performer, values in zip(performers, before, strict=True):
                vars(performer).update(values)
            raise
        return ()

    def play(self, performer: Performer) -> None:
        """Does what it asks for of one character."""
        raise NotImplementedError(f"{type(self).__name__} declares no play")


class SceneCommand(ClientMessage, frozen=True):
    """A command for the scene."""

    access = "operate"
    follows_bus: ClassVar[bool] = True
    method: ClassVar[str | None] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Changes the scene. session: the show; who: the client; now: seconds, monotonic."""
        self.change(session.scene)
        return ()

    def change(self, scene: Scene) -> None:
        """Does what it asks for of the scene."""
        raise NotImplementedError(f"{type(self).__name__} declares no change")


class FileRequest(ClientMessage, frozen=True):
    """What a console asks of the show file, which the server carries out."""

    recorded = False

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps the request for the server. session: the show; who: the client; now: seconds, monotonic."""
        session.wishes.append(KeepRequest(who, self))
        return ()


@dataclass(frozen=True)
class KeepRequest:
    """A console's request to change the show file; the server carries it out."""

    who: str
    message: ClientMessage


class DeviceMessage(ClientMessage, frozen=True):
    """What a page says of devices; `inputs/` plays it at the next tick."""

    access = "operate"
    recorded = False

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps it for the next tick. session: the show; who: the client; now: seconds, monotonic."""
        session.collect(who, self)
        return ()


@cache
def tag_of(kind: type[Message]) -> str:
    """The tag of a kind of message."""
    return str(kind.__struct_config__.tag)


def kinds_below(base: type[Declared], modules: Iterable[ModuleType]) -> tuple[type[Declared], ...]:
    """The kinds of messages that modules declare below a base, in the order of the modules and their lines.

    base: of all of them, itself none; modules: that declare them.
    """
    return tuple(
        kind
        for module in modules
        for kind in vars(module).values()
        if isinstance(kind, type) and issubclass(kind, base) and kind.__module__ == module.__name__
        if not kind.__subclasses__()
    )


@cache
def values_of(kind: type[ClientMessage]) -> dict[str, Value]:
    """What the fields of a kind of command are as values of an address, by field. kind: the class of the command."""
    values: dict[str, Value] = {}
    for name, hint in get_type_hints(kind, include_extras=True).items():
        for extra in get_args(hint)[1:] if get_origin(hint) is Annotated else ():
            if isinstance(extra, Value):
                values[name] = extra if extra.name else replace(extra, name=name)
    return values


def check_ranges(message: ClientMessage) -> None:
    """Raises ValueError or TypeError for a number of a command that is out of the range that its field declares.

    Angles are declared in degrees and held in radians: they are checked where they are converted, and by the engine.
    The number of a channel is called by the channel.

    message: with its declared fields.
    """
    numbers, channel = _numbers_of(type(message))
    for name, value in numbers:
        number = getattr(message, name)
        if number is None or (type(number) is float and value.low <= number <= value.high):
            continue  # nearly always
        check_within(
            number, value.low, value.high, f"the channel {getattr(message, channel)}" if channel else value.name
        )


@cache
def _numbers_of(kind: type[ClientMessage]) -> tuple[tuple[tuple[str, Value], ...], str]:
    """The fields of a kind of command that have a range, and the one that names a channel, "" where none does."""
    values = values_of(kind)
    numbers = tuple(
        (name, value)
        for name, value in values.items()
        if value.kind in ("number", "seconds", "time") and value.unit != "degrees"
    )
    return numbers, next((name for name, value in values.items() if value.kind == "channel"), "")


def called_names(cast: Playable) -> dict[str, Mapping[str, object]]:
    """The names that commands call, by the kind of their values."""
    return {
        "face": cast.faces, "expression": cast.expressions, "channel": cast.expressions, "light": LIGHTS,
        "pose": cast.poses, "body": cast.bodies,
    }  # fmt: skip


@cache
def _called_by(kind: type[ClientMessage]) -> tuple[tuple[str, str], ...]:
    """The fields of a kind of command that may call something of the cast by its label, with the kinds of that."""
    kinds = ("face", "expression", "channel")
    return tuple((name, value.kind) for name, value in values_of(kind).items() if value.kind in kinds)


def call_by_name(message: Declared, cast: Playable) -> Declared:
    """The command with the names of faces, expressions and channels that it calls by their labels; one that names none
    is as it was, and what plays it says so. message: as it was sent; cast: what can be called."""
    called = _called_by(type(message))
    if not called:
        return message
    names = called_names(cast)
    meant = {}
    for name, kind in called:
        typed = getattr(message, name)
        if not isinstance(typed, str) or typed in names[kind]:
            continue
        with suppress(ValueError):
            meant[name] = find_called(typed, kind, cast)
    return msgspec.structs.replace(message, **meant) if meant else message


def characters_of(scene: Scene, character: str) -> tuple[str, ...]:
    """The characters of the scene that a name means, `*` for all of them; ValueError where there is none of that name.
    character: the name, or `*`."""
    if character in scene:
        return (character,)
    names = tuple(scene)
    return names if character == ALL else (check_character(character, scene.labels),)
