"""What a recording is made of: what a session did, in order, and snapshots from which a replay can begin.

A message is noted after the session has let it through, so a replay needs neither roles nor leases, hands nor ids: what
was refused changed nothing. What is sent is noted, not what came by the network: what reads a camera or a MIDI cable
is not the same on two machines.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeGuard, Union

import msgspec

from omote.perform.clips.clip import Clip
from omote.perform.scene.scene_snapshot import SceneSnapshot
from omote.perform.speech.speaking import speeches_of
from omote.show.cues.cue_lists import RecordedCues, RecordedCueStates
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects.link import Bus
from omote.show.objects.recordings import MarkMoment
from omote.show.objects.speech import PlaySound, Say
from omote.show.preview_bus import PreviewSnapshot
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot
from omote.show.sources.open_sources import RecordedSources
from omote.show.sources.sources_snapshot import Route
from omote.show.state import EyeOffset

if TYPE_CHECKING:
    from omote.show.declaration import ClientMessage as AnyMessage
else:
    AnyMessage = Union[CLIENT_MESSAGES]  # noqa: UP007  (of a tuple)


class Entry(msgspec.Struct, frozen=True, array_like=True, tag=True):
    """Something that a session did."""

    def redo(self, session: ShowSession) -> None:
        """Does it again; ValueError or LookupError where it cannot be done. session: the show."""


class Client(msgspec.Struct, frozen=True, array_like=True):
    """A client as a session knows it. name: for people; seat: for whom it plays; bus: which it looks at."""

    name: str
    seat: str
    bus: Bus = "air"


class Joined(Entry, frozen=True):
    """A client (who) is known from now on, or called otherwise."""

    who: str
    client: Client

    def redo(self, session: ShowSession) -> None:
        """Adds the client. session: the show."""
        session.join(self.who, self.client.name, self.client.seat, self.client.bus)


class Left(Entry, frozen=True):
    """A client (who) has left, and the sources of its link with it."""

    who: str

    def redo(self, session: ShowSession) -> None:
        """Removes the client. session: the show."""
        session.leave(self.who)


class Sent(Entry, frozen=True):
    """A message of a client that was obeyed. who: the client; now: seconds, monotonic."""

    who: str
    now: float
    message: AnyMessage

    def redo(self, session: ShowSession) -> None:
        """Does what the message asks for. session: the show."""
        if not isinstance(self.message, MarkMoment):  # which needs a recorder, and changes nothing
            session.act(self.who, self.message, self.now)


class ChannelsSet(Entry, frozen=True):
    """Channels of a character that were set at once. who: the client; now: seconds, monotonic."""

    who: str
    now: float
    character: str
    values: dict[str, float]

    def redo(self, session: ShowSession) -> None:
        """Sets the channels. session: the show."""
        session.scene[self.character].set_channels(self.values)


class Routed(Entry, frozen=True):
    """A source that waited has taken over. source: its name; route: whom it plays from now on."""

    source: str
    route: Route

    def redo(self, session: ShowSession) -> None:
        """Routes the source. session: the show."""
        session.sources.set_route(session.scene, self.source, self.route)


class SoundsKnown(Entry, frozen=True):
    """The sounds that there are from now on, with their seconds; called: keys by name, by which clips name them."""

    seconds: dict[str, float]
    called: dict[str, str] = {}

    def redo(self, session: ShowSession) -> None:
        """Notes the sounds. session: the show."""
        session.sounds.set(self.seconds, self.called)


class Recast(Entry, frozen=True):
    """Another cast plays from now on; `Replay` finds it. digest: of that cast."""

    digest: str


class CuesEdited(Entry, frozen=True):
    """The cues as an edit has left them."""

    shown: RecordedCues

    def redo(self, session: ShowSession) -> None:
        """Plays the cues from now on. session: the show."""
        session.cues.replay(self.shown)


class ClipsEdited(Entry, frozen=True):
    """The clips as an edit has left them, by name: themselves, or the keys by which `Replay` finds them."""

    clips: dict[str, Any]


class PreviewSet(Entry, frozen=True):
    """The preview as it is, None where nobody has needed it: what comes next reads it. What is done in preview is not
    recorded else."""

    scene: SceneSnapshot | None

    def redo(self, session: ShowSession) -> None:
        """Sets the preview. session: the show."""
        if self.scene is None:
            session.preview.forget()
        else:
            session.preview.restore(PreviewSnapshot(self.scene))


class LineRejected(Entry, frozen=True):
    """A line of a cue was not said. said: why."""

    said: str

    def redo(self, session: ShowSession) -> None:
        """Tells that again. session: the show."""
        session.cues.reject(self.said)


class Ticked(Entry, frozen=True):
    """A tick. now: seconds, monotonic; check: CRC-32 of the bytes of the state that was sent, None where none was."""

    now: float
    check: int | None = None


class SnapshotTaken(Entry, frozen=True):
    """The session as it is after a tick: a replay can begin here.

    session: what a restarted server needs too, without ids and leases; now: seconds, monotonic, None before the
    first tick; number, epoch, revision: of the last state; digest: of the cast; members: by client; sources: those
    that are open; sounds: seconds by key; sounds_called: keys by name; eyes: offsets by character; playing: of the
    cues. book, clips: the cues and the clips (as of `ClipsEdited`), where a piece of the recording begins here;
    else they are as the last entry has them. runs: clips that play but are not there so any more, by character and
    number of the run.
    """

    session: SessionSnapshot
    now: float | None
    number: int
    epoch: int
    revision: int
    digest: str
    members: dict[str, Client]
    sources: RecordedSources
    sounds: dict[str, float]
    eyes: dict[str, EyeOffset]
    playing: RecordedCueStates
    book: RecordedCues | None = None
    clips: dict[str, Any] | None = None
    runs: dict[str, dict[int, Any]] = {}
    sounds_called: dict[str, str] = {}


AnyEntry = (
    Joined
    | Left
    | Sent
    | ChannelsSet
    | Routed
    | SoundsKnown
    | Recast
    | CuesEdited
    | ClipsEdited
    | PreviewSet
    | LineRejected
    | Ticked
    | SnapshotTaken
)


def begins_piece(entry: AnyEntry | None) -> TypeGuard[SnapshotTaken]:
    """Whether a piece of a recording begins with an entry: a snapshot with the cues needs none before it."""
    return isinstance(entry, SnapshotTaken) and entry.book is not None


def name_clips(entries: list[AnyEntry], key_of: Callable[[Clip], str]) -> list[AnyEntry]:
    """The entries with clips by their keys, as a file keeps them. key_of: keeps a clip and gives its key."""

    def keys(clips: dict[Any, Any]) -> dict[Any, str]:
        return {name: key_of(clip) for name, clip in clips.items()}

    named: list[AnyEntry] = []
    for entry in entries:
        if isinstance(entry, ClipsEdited | SnapshotTaken) and entry.clips is not None:
            entry = msgspec.structs.replace(entry, clips=keys(entry.clips))
        if isinstance(entry, SnapshotTaken) and entry.runs:
            runs = {character: keys(clips) for character, clips in entry.runs.items()}
            entry = msgspec.structs.replace(entry, runs=runs)
        named.append(entry)
    return named


def sounds_of(entry: AnyEntry) -> Iterable[str]:
    """The keys of the sounds that an entry begins, or that are heard at a snapshot or wait then; those of clips are
    theirs."""
    if isinstance(entry, Sent) and isinstance(entry.message, Say | PlaySound) and entry.message.sound:
        yield entry.message.sound
    elif isinstance(entry, SnapshotTaken):
        for character in entry.session.scene.characters.values():
            said = character.performer.speaking
            yield from () if said is None else (speech.sound for speech in speeches_of(said) if speech.sound)


_encoder = msgspec.msgpack.Encoder()
_decoder = msgspec.msgpack.Decoder(list[AnyEntry])


def encode_entries(entries: list[AnyEntry]) -> bytes:
    """The bytes of some entries."""
    return _encoder.encode(entries)


def decode_entries(data: bytes) -> list[AnyEntry]:
    """The entries of some bytes; msgspec.DecodeError where they are none."""
    return _decoder.decode(data)
