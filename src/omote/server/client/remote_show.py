"""A running show as a program plays it: the calls of a performer and of a scene, each one message on the wire."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Generic

from omote.model.known_names import GENERIC
from omote.perform.easing import DEFAULT_EASING
from omote.perform.scene.character_names import ALL, find_character, framing_of, names_in
from omote.server.client.remote_character import RemoteCharacter, Said, Sent
from omote.server.client.remote_leases import RemoteLeases
from omote.server.client.remote_sources import RemoteSources
from omote.show import messages as wire


class RemoteShow(RemoteLeases[Sent], RemoteSources[Sent], Generic[Sent, Said]):
    """A running show: `show["one"]` is a character, `show["*"]` all of them; light and framing are the show's."""

    def __init__(
        self,
        send: Callable[[wire.FromClient], Sent],
        newest: Callable[[], wire.State],
        next_id: Callable[[], str],
        drive: Callable[[wire.Source, wire.Drive], Sent],
        speak: Callable[[wire.Say, bytes | None], Said],
    ) -> None:
        super().__init__(send, next_id)
        self.drive, self.speak = drive, speak
        self._newest = newest

    @property
    def state(self) -> wire.State:
        """The newest state: complete, as the stages get it."""
        return self._newest()

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
        labels = {each: state.label for each, state in self.state.characters.items()}
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
        """Adds a character, which waits off stage until it enters."""
        return self.send(wire.AddCharacter(self.next_id(), name, name if label is None else label, face))

    def remove(self, name: str, *, seconds: float = 1.0, key: str = "") -> Sent:
        """Takes a character out of the scene: it leaves the stage in `seconds`, then it is gone; `restore` brings it
        back."""
        return self.send(wire.RemoveCharacter(self.next_id(), name, key, seconds))

    def restore(self, key: str, *, seconds: float = 1.0) -> Sent:
        """Brings back who was removed with this key, or of this name: all that it had on air, its place, its shot."""
        return self.send(wire.RestoreCharacter(self.next_id(), key, seconds))

    def rename(self, name: str, label: str) -> Sent:
        """Gives a character another label."""
        return self.send(wire.RenameCharacter(self.next_id(), name, label))

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
        """Moves a character: metres to the picture's right, metres behind the front line, a factor, radians to its own
        left; what is not given stays where it is now. KeyError where there is no such character."""
        here = self[name].place
        x, depth = here.x if x is None else x, here.depth if depth is None else depth
        size, turn = here.size if size is None else size, here.turn if turn is None else turn
        return self.send(wire.PlaceCharacter(self.find_character(name), x, depth, size, turn, seconds, self.next_id()))

    def set_gaze_point(self, name: str, *, x: float, y: float, z: float) -> Sent:
        """Names a point of the house that characters may look at, or moves it: metres to the picture's right, above the
        eyes, before the front line."""
        return self.send(wire.SetGazePoint(self.next_id(), name, x, y, z))

    def delete_gaze_point(self, name: str) -> Sent:
        """Forgets a gaze point; who looked at it looks ahead."""
        return self.send(wire.DeleteGazePoint(self.next_id(), name))

    def enter(self, name: str, *, seconds: float = 1.0) -> Sent:
        """Brings a character onto the stage."""
        return self.send(wire.EnterCharacter(self.next_id(), name, seconds))

    def leave(self, name: str, *, seconds: float = 1.0) -> Sent:
        """Takes a character off the stage; it stays in the scene."""
        return self.send(wire.LeaveCharacter(self.next_id(), name, seconds))

    def call_framing(
        self, characters: Iterable[str] = (), *, seconds: float = 1.0, easing: str = DEFAULT_EASING
    ) -> Sent:
        """Brings a shot of these characters on air; nobody: of all that are on the stage. TypeError for a text instead
        of a list, ValueError for a character that there is not."""
        framing = framing_of(characters, self.characters)
        return self.send(wire.CallFraming(self.next_id(), sorted(names_in(framing)), seconds, easing))

    def call_light(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> Sent:
        """Brings a light on air from whatever light shows."""
        return self.send(wire.CallLight(self.next_id(), name, seconds, easing))

    def panic(self) -> Sent:
        """All characters go neutral and hold still."""
        return self.send(wire.Panic(ALL))
