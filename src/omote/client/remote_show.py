"""A running show as a program plays it: the calls of a performer and of a scene, each one message on the wire."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Generic, get_args

from omote.client.derived_methods import add_methods, named
from omote.client.remote_character import RemoteCharacter, Said, Sent
from omote.inputs.voices.spoken_text import WantedSpeech
from omote.model.known_names import GENERIC
from omote.perform.easing import DEFAULT_EASING
from omote.perform.layers.layer_names import ROUTE_PARTS, check_driven
from omote.perform.limits import check_known
from omote.perform.pads.blend_space import Pad
from omote.perform.scene.character_names import ALL, find_character
from omote.perform.scene.framings import ShotSize, framing_of, names_in
from omote.show.declaration import CharacterCommand, ClientMessage
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects.calls import Panic
from omote.show.objects.characters import AddCharacter, PlaceCharacter
from omote.show.objects.cues import CueStatus
from omote.show.objects.hand.pads import SetPad
from omote.show.objects.leases import Lease, LeasePart, ReleaseLease
from omote.show.objects.pictures import CallFraming
from omote.show.objects.sources import CalibrateSource, CalibrationStep, Drive, RouteSource, Source
from omote.show.objects.speech import Say
from omote.show.objects.state import State


class CharacterNames:
    """Who is meant by a name or a label."""

    @abstractmethod
    def find_character(self, name: str) -> str:
        """The name of the character that a name or a label means."""


class RemoteLeases(CharacterNames, Generic[Sent]):
    """Who may command what. Parts: `face`, `expression`, `brows`, `eyes`, `mouth`, `channels`, `head`, `gaze`, `place`
    of a character, `light`, `framing` and `black` of the character `*`, which is the scene; `*` is all parts."""

    def __init__(self, send: Callable[[ClientMessage], Sent], next_id: Callable[[], str]) -> None:
        self.send = send
        self.next_id = next_id

    def lease(self, character: str, part: LeasePart = "*", *, take_over: bool = False) -> Sent:
        """Holds a part of a character, so that nobody else plays it. ValueError where another holds it, with its name,
        but for `take_over`; where leases are off; and for a part that there is not."""
        return self.send(Lease(self.next_id(), self.find_character(character), _checked(part), take_over))

    def release_lease(self, character: str, part: LeasePart = "*") -> Sent:
        """Releases a part of a character; `*`: all that this program holds. ValueError where another holds it."""
        return self.send(ReleaseLease(self.next_id(), self.find_character(character), _checked(part)))


def _checked(part: LeasePart) -> LeasePart:
    check_known(part, get_args(LeasePart), "part")
    return part


class RemoteSources(CharacterNames, Generic[Sent]):
    """Whom sources play and by what measure; by the names that the mixer shows."""

    send: Callable[[ClientMessage], Sent]
    next_id: Callable[[], str]

    def route_source(
        self, source: str, characters: Iterable[str], *, layer: str = "tracker", regions: Iterable[str] = ()
    ) -> Sent:
        """Lets a source play these characters, by name or label (`*`: all; none: nobody), on a layer, in these regions
        of the face (none: all). The show keeps it under the source's name, also of one that has not come yet. TypeError
        for a text instead of a list, ValueError for a character, a layer or a region that there is not."""
        if isinstance(characters, str) or isinstance(regions, str):
            raise TypeError("characters and regions are lists of names; give ['one'] for one")
        targets = [self.find_character(character) for character in characters]
        parts = [check_known(region, ROUTE_PARTS, "region of a source") for region in regions]
        return self.send(RouteSource(self.next_id(), source, targets, check_driven(layer), parts))

    def calibrate_source(self, source: str, step: CalibrationStep, channels: Iterable[str] = ()) -> Sent:
        """Measures the performer before a source: `neutral` takes the face at rest, `range` listens to the largest
        moves of these channels (none: all) until `done`, `reset` forgets both. ValueError for a source that there is
        not, for a step without a frame, and for a channel that it does not send."""
        return self.send(CalibrateSource(self.next_id(), source, step, list(channels)))


class RemoteShow(RemoteLeases[Sent], RemoteSources[Sent], Generic[Sent, Said]):
    """A running show: `show["one"]` is a character, `show["*"]` all of them; light, framing, black are the show's."""

    def __init__(
        self,
        send: Callable[[ClientMessage], Sent],
        newest: Callable[[], State],
        next_id: Callable[[], str],
        drive: Callable[[Source, Drive], Sent],
        speak: Callable[[Say, bytes | WantedSpeech | None], Said],
    ) -> None:
        super().__init__(send, next_id)
        self.drive = drive
        self.speak = speak
        self._newest = newest

    @property
    def state(self) -> State:
        """The newest state: complete, as the stages get it."""
        return self._newest()

    @property
    def cues(self) -> CueStatus | None:
        """How far the lists of cues are, None in a show without cues; `go`, `back`, `go_to_cue` and others play
        them."""
        return self.state.cues

    @property
    def characters(self) -> tuple[str, ...]:
        """The names of the characters, in the order in which they were added."""
        return tuple(self.state.characters)

    def __getitem__(self, name: str) -> RemoteCharacter[Sent, Said]:
        """A character by its name or its label, in any case, or `*` for all; KeyError where there is none."""
        try:
            return RemoteCharacter(self.find_character(name), self)
        except ValueError as error:
            raise KeyError(str(error)) from error

    def find_character(self, name: str) -> str:
        """The name of the character that a name or a label means, in any case, `*` for all; ValueError with those that
        there are where none is meant, and where several are."""
        if not isinstance(name, str):
            raise ValueError(f"the character is {name!r:.80}; give its name, one of {', '.join(self.characters)}")
        if name == ALL:
            return name
        labels = {key: state.label for key, state in self.state.characters.items()}
        return find_character(name, labels)

    def __iter__(self) -> Iterator[str]:
        """The names of the characters."""
        return iter(self.characters)

    def __repr__(self) -> str:
        """Who is in it."""
        return f"<running show with the characters {', '.join(self.characters)}>"

    def __len__(self) -> int:
        """How many characters there are."""
        return len(self.characters)

    def add(self, name: str, *, face: str = GENERIC, label: str | None = None) -> Sent:
        """Adds a character, which waits off stage until it enters. name: its own; face: the name of its face; label:
        what pages show, its name where none is given."""
        return self.send(AddCharacter(self.next_id(), name, name if label is None else label, face))

    def place(
        self,
        name: str,
        *,
        x: float | None = None,
        depth: float | None = None,
        size: float | None = None,
        turn: float | None = None,
        seconds: float = 1.0,
    ) -> Sent:
        """Moves a character: x, metres to the picture's right; depth, metres behind the front line; size, a factor;
        turn, radians to its own left; what is not given stays where it is now. KeyError where there is no such
        character. name: of the character; seconds: of the move."""
        here = self[name].place
        x = here.x if x is None else x
        depth = here.depth if depth is None else depth
        size = here.size if size is None else size
        turn = here.turn if turn is None else turn
        return self.send(PlaceCharacter(self.find_character(name), x, depth, size, turn, seconds, self.next_id()))

    def set_pad(self, pad: Pad, *, key: str = "") -> Sent:
        """Keeps a pad; one of its name makes way, and what that plays follows the new one. key: what `restore_pad`
        finds the one before by, its name where none is given."""
        if not isinstance(pad, Pad):
            raise TypeError(f"the pad is a {type(pad).__name__}; give an omote.Pad")
        return self.send(SetPad(self.next_id(), pad.name, pad.part, pad.dimensions, list(pad.looks), key))

    def call_framing(
        self,
        characters: Iterable[str] | None = (),
        *,
        size: ShotSize | None = None,
        seconds: float = 1.0,
        easing: str = DEFAULT_EASING,
    ) -> Sent:
        """Brings a shot of these characters on air; nobody: of all that are on the stage, None: of whom it holds now.
        TypeError for a text instead of a list, ValueError for a character that there is not. size: how much of their
        figures it shows, as much as now where none is given; seconds: of the move; easing: the name of the curve."""
        if characters is None:
            return self.send(CallFraming(self.next_id(), None, seconds, easing, size))
        names = characters if isinstance(characters, str) else [self.find_character(name) for name in characters]
        framing = framing_of(names, self.characters)
        return self.send(CallFraming(self.next_id(), sorted(names_in(framing)), seconds, easing, size))

    def panic(self) -> Sent:
        """All characters go neutral and hold still."""
        return self.send(Panic(ALL))

    def build(self, command: type[ClientMessage], fields: Mapping[str, Any]) -> Sent:
        """Sends a command to the character that a name or a label means; a new one has its own name. command: its
        kind; fields: their values by name, without the id."""
        meant = {key: self.find_character(value) for key, value in fields.items() if key == "character"}
        return self.send(command(**named(command, self.next_id), **{**fields, **meant}))

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Callable[..., Sent]:
            """The methods that commands declare."""


add_methods(RemoteShow, (kind for kind in CLIENT_MESSAGES if not issubclass(kind, CharacterCommand)))
