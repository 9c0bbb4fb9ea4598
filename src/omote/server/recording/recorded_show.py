"""A recording that is read: replayed from any moment, and told as who did what."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from heapq import merge

import msgspec

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip
from omote.server.recording.recording_thread import read_entries
from omote.show.declaration import tag_of
from omote.show.objects.clips import StoredClip, clip_of
from omote.show.objects.recordings import MarkMoment
from omote.show.recording.curves import CueCall
from omote.show.recording.entries import AnyEntry
from omote.show.recording.replay import ReplayedTick, ReplayError, replay
from omote.show.recording.show_log import LogLine, tell_log
from omote.showfile.recording_file import Marker, Piece, RecordingFile, sound_key
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast


@dataclass(frozen=True)
class Span:
    """What is played: of one start of the show, from `first` to `last`, seconds of the machine's clock then."""

    start: int
    first: float
    last: float

    @property
    def seconds(self) -> float:
        """How long it is."""
        return self.last - self.first


class RecordedShow:
    """Reads a recording. file: the open recording; base: the built-in cast, which recordings do not hold."""

    def __init__(self, file: RecordingFile, base: Cast) -> None:
        self._file = file
        self.base = base
        self._casts: dict[str, Cast | PlayingCast] = {base.digest: base}
        self._clips: dict[str, Clip] = {}
        self._reader = ThreadPoolExecutor(max_workers=1, thread_name_prefix="recording")

    def find_span(self, name: str = "", start: int | None = None) -> Span:
        """What is kept under a name, else all that is recorded of a start of the show, of the last where none is given;
        ValueError where there is none, or both are named."""
        if name and start is not None:
            raise ValueError(f"{name!r} is of one start already; give a name or --start, not both")
        if name:
            kept = self._file.kept_named(name)
            return Span(kept.start, kept.first, kept.last)
        pieces = self._file.pieces()
        if not pieces:
            raise ValueError("nothing is recorded yet")
        return self.find_played(pieces[-1].start if start is None else start)

    def find_played(self, start: int) -> Span:
        """All that is recorded of a start of the show; ValueError, with those that there are, where nothing is."""
        pieces = self._file.pieces()
        played = [piece for piece in pieces if piece.start == start]
        if not played:
            begins = {piece.start: piece.written for piece in reversed(pieces)}
            there = ", ".join(
                f"{number} ({time.strftime('%Y-%m-%d %H:%M', time.localtime(begins[number]))})"
                for number in sorted(begins)
            )
            raise ValueError(f"nothing is recorded (any more) of the start {start} of the show; there are {there}")
        return Span(start, played[0].first, played[-1].last)

    def find_cast(self, digest: str) -> Cast | PlayingCast:
        """The cast of a digest with its own items; LookupError, with the reason, where it cannot be played any more."""
        if digest not in self._casts:
            stored = self._file.casts().get(digest)
            if stored is None:
                raise LookupError("it was not recorded")
            if stored.base != self.base.digest:
                raise LookupError("its built-in cast is of another version of Omote")
            contents = self._file.contents(stored.contents)
            if missing := [key for key in stored.contents if key not in contents]:
                raise LookupError(f"{len(missing)} of its own faces or expressions were forgotten")
            own = msgspec.msgpack.decode(stored.own, type=tuple[Own, ...])
            self._casts[digest] = build_playing_cast(self.base, own, contents, check=False)
        return self._casts[digest]

    def find_clip(self, key: str) -> Clip:
        """The clip of a key; LookupError, with the reason, where it cannot be played any more."""
        if key not in self._clips:
            data = self._file.contents([key]).get(key)
            if data is None:
                raise LookupError("a clip that was played is not there any more")
            self._clips[key] = clip_of(msgspec.json.decode(data, type=StoredClip))
        return self._clips[key]

    def find_sound(self, sound: str) -> bytes | None:
        """The bytes of a sound that was recorded, None for another. sound: its key in the show."""
        key = sound_key(sound)
        return self._file.contents([key]).get(key)

    def contents_of(self, digest: str) -> dict[str, bytes]:
        """The contents of a cast's own items, by key. digest: of the cast."""
        stored = self._file.casts().get(digest)
        return {} if stored is None else self._file.contents(stored.contents)

    def replay(self, span: Span, *, after: float | None = None) -> Iterator[ReplayedTick]:
        """Replays a span; ReplayError where it cannot be. after: seconds of the machine's clock then: only the ticks
        behind it, of which the first is there at once; None for all of the span."""
        since = span.first if after is None else max(after, span.first)
        begin = since if after is not None else since - 1e-6
        pieces = _PiecesAhead(self._reader, self._read, self._pieces(span, since))
        for tick in replay(pieces, self.find_cast, self.find_clip, after=begin):
            if tick.now > span.last:
                return
            yield tick
            pieces.read_on()  # not before: somebody waits for the first tick

    def log(self, span: Span) -> Iterator[LogLine]:
        """Who did what in a span, in its order; what a hand sends again and again is one line. What was noted is as it
        is written now."""
        marks = (LogLine(mark.at, mark.who, tag_of(MarkMoment), mark.name) for mark in self.markers(span))
        pieces = _PiecesAhead(self._reader, self._read, self._pieces(span, span.first))
        entries = (entry for piece in pieces for entry in piece)
        calls = [CueCall(*call) for call in self._file.cue_calls(span.start)]
        return merge(tell_log(entries, calls, span.first, span.last), marks, key=lambda line: line.at)

    def markers(self, span: Span) -> list[Marker]:
        """What was marked in a span, in its order."""
        marks = self._file.markers()
        return [mark for mark in marks if mark.start == span.start and span.first <= mark.at <= span.last]

    def close(self) -> None:
        """Stops reading; the file stays open."""
        self._reader.shutdown(wait=True, cancel_futures=True)

    def _pieces(self, span: Span, since: float) -> list[Piece]:
        """The pieces that are read for a span from a moment on: the last that begins before it is the first."""
        pieces = self._file.pieces_between(span.start, span.first, span.last)
        before = [place for place, piece in enumerate(pieces) if piece.first <= since]
        return pieces[before[-1] :] if before else pieces

    def _read(self, piece: Piece) -> list[AnyEntry]:
        try:
            return read_entries(self._file, piece.id)
        except msgspec.DecodeError as error:
            program = piece.program
            raise ReplayError(f"a minute that Omote {program} recorded cannot be read by this one: {error}") from error
        except (KeyError, ValueError) as error:
            raise ReplayError(f"a minute of the recording cannot be read: {error}") from error


class _PiecesAhead:
    """The entries of pieces, one after the other; the next are unpacked while those before are played, from the moment
    on at which that is asked for. reader: the thread; read: the entries of a piece."""

    def __init__(
        self, reader: ThreadPoolExecutor, read: Callable[[Piece], list[AnyEntry]], pieces: Iterable[Piece]
    ) -> None:
        self._reader = reader
        self._read = read
        self._left = deque(pieces)
        self._coming: Future[list[AnyEntry]] | None = None

    def __iter__(self) -> Iterator[list[AnyEntry]]:
        return self

    def __next__(self) -> list[AnyEntry]:
        self.read_on()
        if self._coming is None:
            raise StopIteration
        entries = self._coming.result()
        self._coming = None
        return entries

    def read_on(self) -> None:
        """Begins to unpack the next piece, if it is not begun and there is one."""
        if self._coming is None and self._left:
            self._coming = self._reader.submit(self._read, self._left.popleft())
