"""Replays what was recorded: the same session does the same again, to the last bit."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from omote.perform.clips.clip import Clip
from omote.perform.snapshot import Playable
from omote.show.cues.cue_lists import RecordedCues
from omote.show.objects.state import State
from omote.show.recording.entries import AnyEntry, ClipsEdited, CuesEdited, Recast, SnapshotTaken, Ticked, begins_piece
from omote.show.session import ShowSession
from omote.show.wire import encode

FindCast = Callable[[str], Playable]
"""The cast of a digest; LookupError where it is not there any more."""


FindClip = Callable[[str], Clip]
"""The clip of a key; LookupError where it is not there any more."""
NO_CLIPS: FindClip = dict[str, Clip]().__getitem__
"""Of entries that have their clips themselves."""


class ReplayError(ValueError):
    """What was recorded cannot be replayed; the message says why."""


@dataclass(frozen=True)
class ReplayedTick:
    """A tick that was replayed. now: seconds, monotonic, as it was recorded; digest: of the cast that played; same:
    whether the bytes of the state are those that were sent, None where none were."""

    now: float
    state: State
    digest: str
    same: bool | None


@dataclass(frozen=True)
class Beginning:
    """Where a replay begins: a snapshot, with the cues and the clips as they were then."""

    kept: SnapshotTaken
    book: RecordedCues
    clips: Mapping[str, Any]


class Replay:
    """A session that does again what was recorded. begin: where; find_cast, find_clip: find casts and clips.
    ReplayError where it cannot begin."""

    def __init__(self, begin: Beginning, find_cast: FindCast, find_clip: FindClip) -> None:
        kept = begin.kept
        self._find_cast = find_cast
        self._find_clip = find_clip
        cast = self._cast(kept.digest)
        try:
            self.session = ShowSession.restored(cast, kept.session, epoch=kept.epoch, revision=kept.revision)
        except ValueError as error:
            raise ReplayError(f"the snapshot cannot be played: {error}") from error
        self.session.plays_preview = False
        self.session.resume(kept.now, kept.number, kept.eyes)
        self.session.sources.replay(kept.sources)
        self.session.sounds.set(kept.sounds, kept.sounds_called)
        self.session.cues.replay(begin.book, kept.playing)
        for name, runs in kept.runs.items():
            self.session.scene[name].resume_clips({number: self._clip(clip) for number, clip in runs.items()})
        self._set_clips(begin.clips)
        for who, client in kept.members.items():
            self.session.join(who, client.name, client.seat, client.bus)

    def play(self, entries: Iterable[AnyEntry], after: float | None) -> Iterator[ReplayedTick]:
        """Does what was recorded, tick by tick; ReplayError where an entry cannot be done again. entries: those behind
        the snapshot; after: as of `replay`."""
        for entry in entries:
            if not isinstance(entry, Ticked):
                self._do(entry)
            elif after is None or entry.now > after:
                yield self._tick(entry)
            else:
                self._pass(entry)

    def _pass(self, entry: Ticked) -> State:
        self.session.cues.take_lines()  # what cues have said was recorded as what somebody says
        state = self.session.tick(entry.now)
        self.session.cues.take_sends()  # a replay sends nothing
        self.session.texts.take()
        return state

    def _tick(self, entry: Ticked) -> ReplayedTick:
        state = self._pass(entry)
        same = None if entry.check is None else zlib.crc32(encode(state)) == entry.check
        return ReplayedTick(entry.now, state, self.session.cast.digest, same)

    def _do(self, entry: AnyEntry) -> None:
        try:
            if isinstance(entry, Recast):
                self.session.recast(self._cast(entry.digest))
            elif isinstance(entry, ClipsEdited):
                self._set_clips(entry.clips)
            else:
                entry.redo(self.session)
        except ReplayError:
            raise
        except (ValueError, LookupError) as error:
            raise ReplayError(f"{type(entry).__name__} cannot be done again: {error}") from error

    def _set_clips(self, clips: Mapping[str, Any]) -> None:
        self.session.clips.load({name: self._clip(clip) for name, clip in clips.items()})

    def _clip(self, clip: Any) -> Clip:
        try:
            return clip if isinstance(clip, Clip) else self._find_clip(clip)
        except LookupError as error:
            raise ReplayError(f"a clip that played is not there: {error}") from error

    def _cast(self, digest: str) -> Playable:
        try:
            return self._find_cast(digest)
        except LookupError as error:
            raise ReplayError(f"the cast that played ({digest[:12]}) is not there: {error}") from error


def replay(
    pieces: Iterable[Iterable[AnyEntry]],
    find_cast: FindCast,
    find_clip: FindClip = NO_CLIPS,
    *,
    after: float | None = None,
) -> Iterator[ReplayedTick]:
    """Replays pieces of a recording, one after the other, from the last snapshot of the first piece
    that is not behind a time.

    Parameters
    ----------
    pieces : iterable of iterable of entry
        Of one start of the show; each begins with a snapshot that has the cues. Where ticks are missing between two,
        the replay goes on from the snapshot of the next.
    find_cast, find_clip : callable
        Find a cast by its digest, and a clip by its key.
    after : float, optional
        Seconds, monotonic: ticks up to it are replayed, but not given; the replay begins near it.

    Yields
    ------
    ReplayedTick
        Each tick behind `after`.

    Raises
    ------
    ReplayError
        Where an entry cannot be done again.
    """
    playing: Replay | None = None
    for piece in pieces:
        entries = list(piece)
        first = entries[0] if entries else None
        if not begins_piece(first) or first.book is None:
            raise ReplayError("a replay begins with a snapshot that has the cues; there is none")
        rest = entries[1:]
        if playing is None or (playing.session.number, playing.session.epoch) != (first.number, first.epoch):
            beginning, rest = _begin(entries, Beginning(first, first.book, first.clips or {}), after)
            playing = Replay(beginning, find_cast, find_clip)
        yield from playing.play(rest, after)


def _begin(entries: list[AnyEntry], first: Beginning, after: float | None) -> tuple[Beginning, list[AnyEntry]]:
    """Where in a piece a replay begins, and what of it is left then. entries: of the piece; first: its first snapshot;
    after: as of `replay`."""
    begun = shown = first
    place = 0
    for number, entry in enumerate(entries):
        if isinstance(entry, CuesEdited):
            shown = replace(shown, book=entry.shown)
        elif isinstance(entry, ClipsEdited):
            shown = replace(shown, clips=entry.clips)
        elif isinstance(entry, SnapshotTaken) and after is not None and entry.now is not None and entry.now <= after:
            begun = replace(shown, kept=entry)
            place = number
    return begun, entries[place + 1 :]
