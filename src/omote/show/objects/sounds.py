"""The sounds of a show: what is kept of each, what pages are told of them, and who renames and deletes them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Annotated, Any, ClassVar

import msgspec

from omote.show.declaration import CallId, ClientMessage, Outgoing, ServerMessage, Session
from omote.show.objects.documents import Document

LONGEST_SOUND_NAME = 60
MOST_NAMED_SOUNDS = 256
MOST_NAMED_BYTES = 2**26
"""Of all sounds that a show file keeps: an hour as MP3, and a good copy of the file takes as many again."""
SoundName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_SOUND_NAME)]


class StoredSound(Document, frozen=True):
    """A sound, under its name. `sound`: its key, as of `/sounds`; `content`: that of its bytes in the file; `size`: how
    many they are. `former`: the names that it had before, by which clips and cues find it still."""

    kind: ClassVar[str] = "sound"
    most: ClassVar[int] = MOST_NAMED_SOUNDS

    sound: str
    seconds: float
    content: str
    size: int
    former: tuple[str, ...] = ()

    def contents(self) -> Iterable[str]:
        """The key of its bytes."""
        return (self.content,)


class NamedSound(msgspec.Struct, frozen=True):
    """A sound that the show file keeps: its name, its key and its seconds. `former`: names that it had before, by which
    clips and cues find it still."""

    name: str
    sound: str
    seconds: float
    former: list[str] = []


class Sounds(ServerMessage, frozen=True):
    """The sounds that the show file keeps, sorted by name: complete, to consoles after the welcome and with each
    change. One is sent to `/sounds?name=NAME`, and `GET /sounds/KEY` gives its bytes."""

    sounds: list[NamedSound]


class SoundDropped(ServerMessage, frozen=True):
    """Answers drop_sound: who needs the sound, clips and cues in words, and is silent now."""

    name: str
    needed_by: list[str]


class SoundCommand(ClientMessage, frozen=True):
    """A change of the sounds that the show file keeps. An `id` executes once, as of all that follow; answered with
    `sounds`."""

    access = "edit"
    recorded = False
    method: ClassVar[str | None] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Makes the change. session: the show; who: the client; now: seconds, monotonic."""
        self.change(session.named_sounds)
        return ()

    def change(self, sounds: Any) -> None:
        """Makes the change; ValueError where it cannot be made. sounds: those of the show."""
        raise NotImplementedError


class RenameSound(SoundCommand, frozen=True):
    """Gives a sound another name, which none has yet. Clips and cues that name it find it still."""

    id: CallId
    name: SoundName
    to: SoundName

    def change(self, sounds: Any) -> None:
        """Gives it. sounds: those of the show."""
        sounds.rename(self.name, self.to)


class DropSound(SoundCommand, frozen=True):
    """Takes a sound out of the show; `restore_sound` brings it back until the server restarts. Answered with
    `sound_dropped` too: clips and cues that need it are silent."""

    id: CallId
    name: SoundName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Takes it out. session: the show; who: the client; now: seconds, monotonic."""
        needed_by = session.named_sounds.drop(self.name, session.clips.clips, session.cues.book)
        return [Outgoing(who, SoundDropped(self.name, needed_by))]


class RestoreSound(SoundCommand, frozen=True):
    """Brings back the sound that was dropped last under a name."""

    id: CallId
    name: SoundName

    def change(self, sounds: Any) -> None:
        """Brings it back. sounds: those of the show."""
        sounds.restore(self.name)
