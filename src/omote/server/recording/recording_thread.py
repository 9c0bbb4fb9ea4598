"""Writes what a show does beside the show file, in a thread: a slow or broken disk never delays a tick."""

from __future__ import annotations

import hashlib
import sqlite3
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from queue import Empty, SimpleQueue
from weakref import WeakKeyDictionary

import msgspec

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip
from omote.show.messages import STATE_RATE
from omote.show.objects.clips import stored_clip
from omote.show.objects.cues import GoBack
from omote.show.objects.recordings import MarkMoment
from omote.show.recording.curves import (
    CURVE_RATE,
    CurveSampler,
    join_curves,
    pack_curves,
    unpack_curves,
)
from omote.show.recording.entries import (
    AnyEntry,
    Joined,
    Recast,
    Sent,
    SnapshotTaken,
    SoundsKnown,
    Ticked,
    begins_piece,
    decode_entries,
    encode_entries,
    name_clips,
    sounds_of,
)
from omote.show.recording.packing import pack_entries, unpack_entries
from omote.showfile.database_errors import explain_database_error
from omote.showfile.recording_file import (
    RING_SECONDS,
    KeptRecording,
    RecordingFile,
    StoredCast,
    open_recording,
    sound_key,
)
from omote.showfile.schema import ShowFileError
from omote.stage_data.playing_cast import PlayingCast

ADD_SECONDS = 1.0
"""Between two commits: what a process that dies has not written of its recording."""
MOST_WAITING = 3600
"""Ticks that wait for a disk: a minute. After that the recording has a gap."""
CLOSE_SECONDS = 5.0
CURVE_TICKS = STATE_RATE // CURVE_RATE

Answer = Callable[[str], None]
"""Told of a request: why it was refused, "" where it was done."""


class RecordingThread:
    """The recording of a show from now on.

    path: of the recording; report: tells the operator; program: the version that records; find_sound: the bytes of a
    sound by its key, None where it is not there, from any thread. Nothing raises; where the disk fails, that is told
    once, and the recording goes on when the disk does.
    """

    def __init__(
        self,
        path: Path,
        report: Callable[[str], None],
        program: str,
        find_sound: Callable[[str], bytes | None] = lambda _: None,
    ) -> None:
        self.path = path
        self._program = program
        self._report = report
        self._find_sound = find_sound
        self._sounds = set[str]()
        self._sounds_called: Mapping[str, str] = {}
        self._work: SimpleQueue[Callable[[], None] | None] = SimpleQueue()
        self._ticks: SimpleQueue[tuple[Sequence[AnyEntry], bytes]] = SimpleQueue()
        self._file: RecordingFile | None = None
        self._failing = False
        self._start = 0
        self._piece: int | None = None
        self._begins = False
        self._casts: list[str] = []
        self._cast: tuple[StoredCast, list[tuple[str, bytes]]] | None = None
        self._clips: WeakKeyDictionary[Clip, str] = WeakKeyDictionary()
        self._members: dict[str, str] = {}
        self._pending: list[AnyEntry] = []
        self._count = 0
        self._curves = CurveSampler()
        self._backs: list[float] = []
        self._full = False
        self._thread = threading.Thread(target=self._run, name="recording", daemon=True)
        self._thread.start()

    def note(self, entries: Sequence[AnyEntry], state: bytes = b"") -> None:
        """Queues what happened up to a tick (entries); returns at once. state: as it was sent, "" for no curves."""
        if self._ticks.qsize() > MOST_WAITING:
            self._full = True
            return
        if not self._full or any(begins_piece(entry) for entry in entries):
            self._full = False  # after a gap it begins with a piece of its own
            self._count += 1
            self._ticks.put((entries, state if self._count % CURVE_TICKS == 0 else b""))

    def note_cast(self, cast: Cast | PlayingCast, contents: Mapping[str, bytes]) -> None:
        """Queues a cast that is played, before what is played with it. contents: of own items, by key."""
        own = cast.own if isinstance(cast, PlayingCast) else ()
        base = cast.base.digest if isinstance(cast, PlayingCast) else cast.digest
        keys = tuple(sorted({item.content for item in own}))
        stored = StoredCast(cast.digest, base, msgspec.msgpack.encode(own), keys)
        found = [(key, contents[key]) for key in keys if key in contents]
        self._work.put(lambda: self._keep_cast(stored, found, cast))

    def keep(self, name: str, seconds: float, now: float, answer: Answer) -> None:
        """Keeps the last seconds under a name. now: seconds, monotonic; answer: told of it, on this thread."""
        self._work.put(lambda: self._carry_out(lambda file: self._keep(file, name, seconds, now), answer))

    def flush(self, answer: Answer) -> None:
        """Writes what was queued so far. answer: told of it, on this thread."""
        self._work.put(lambda: self._carry_out(lambda _: None, answer))

    def delete(self, name: str, answer: Answer) -> None:
        """Keeps a recording no longer. name: of it; answer: told of it, on this thread."""
        self._work.put(lambda: self._carry_out(lambda file: file.delete(name), answer))

    def alter(self, work: Callable[[RecordingFile], None], answer: Answer) -> None:
        """Does some work on the file, which raises ValueError for what cannot be done. answer: told of it, on this
        thread."""
        self._work.put(lambda: self._carry_out(work, answer))

    @property
    def paths(self) -> tuple[Path]:
        """Where the recording lies."""
        return (self.path,)

    def close(self) -> None:
        """Writes what is left and closes the file; waits five seconds at most."""
        self._work.put(None)
        self._thread.join(timeout=CLOSE_SECONDS)

    # --- on the thread ---

    def _run(self) -> None:
        ended = False
        while not ended:
            ended = self._wait()
            self._try(self._add)
        self._try(self._pack)
        if self._file is not None:
            self._file.close()

    def _wait(self) -> bool:
        """Does what is asked for until it is time to write; whether the end has come."""
        until = time.monotonic() + ADD_SECONDS
        while (left := until - time.monotonic()) > 0.0:
            try:
                work = self._work.get(timeout=left)
            except Empty:
                return False
            if work is None:
                return True
            self._try(self._add)  # what was played before is written before
            self._try(work)
        return False

    def _try(self, work: Callable[[], None]) -> None:
        try:
            work()
        except (sqlite3.Error, OSError, ShowFileError, ValueError) as error:
            self._piece = None
            self._begins = False  # what comes next has no snapshot before it
            if not self._failing:
                reason = str(error) if isinstance(error, ShowFileError) else explain_database_error(error)
                self._report(f"the recording {self.path} cannot be written ({reason}): the show goes on without it.")
            self._failing = True
        else:
            if self._failing and self._piece is not None:
                self._report(f"the recording {self.path} is written again.")
                self._failing = False

    def _opened(self) -> RecordingFile:
        """The file, which is opened now where it is not yet: pieces that a process left behind are packed."""
        if self._file is None:
            file = open_recording(self.path, new=True)
            wall = time.time_ns() / 1e9
            for piece in file.unpacked():
                with suppress(ValueError):  # another version wrote it: it stays as it is
                    pack_piece(file, piece)
            self._start = file.begin_start(wall, time.monotonic(), self._program)
            self._file = file
        return self._file

    def _add(self) -> None:
        """Writes what has been queued; a piece ends where another begins."""
        entries = self._pending
        self._pending = []
        while not self._ticks.empty():
            noted, state = self._ticks.get()
            self._sample(noted, state)
            for entry in noted:
                if begins_piece(entry):
                    self._write(entries)
                    entries = []
                    self._pack()
                    self._begins = True
                    self._casts = [entry.digest]
                entries.append(entry)
        self._write(entries)

    def _sample(self, entries: Sequence[AnyEntry], state: bytes) -> None:
        """Notes what curves need of a state, "" for none. entries: of its tick."""
        self._backs += [entry.now for entry in entries if isinstance(entry, Sent) and isinstance(entry.message, GoBack)]
        now = next((entry.now for entry in reversed(entries) if isinstance(entry, Ticked)), None)
        if state and now is not None:
            self._curves.note(now, state, self._backs)
            self._backs = []

    def _write(self, entries: list[AnyEntry]) -> None:
        ticks = [entry.now for entry in entries if isinstance(entry, Ticked)]
        if not ticks:
            self._pending = entries
            return
        curves, calls = self._curves.take()
        if self._begins:
            self._piece = self._opened().begin_piece(self._start, ticks[0])
            self._begins = False
            if self._cast is not None:  # the ring may have lost it: no piece named it yet
                self._opened().keep_cast(*self._cast)
        if self._piece is None:
            return  # the disk has failed: it goes on with the next piece
        self._members |= {entry.who: entry.client.name for entry in entries if isinstance(entry, Joined)}
        self._casts += [entry.digest for entry in entries if isinstance(entry, Recast)]
        marks = [
            (entry.now, entry.message.text, self._members.get(entry.who, ""))
            for entry in entries
            if isinstance(entry, Sent) and isinstance(entry.message, MarkMoment)
        ]
        there = self._hear_of_sounds(entries)
        for key in {key for entry in entries for key in sounds_of(entry)}:
            self._keep_sound(key)
        for key in there & {clip.sound for clip in self._clips}:  # which came after its clip
            self._keep_sound(key)
        data = encode_entries(name_clips(entries, self._keep_clip))
        casts = dict.fromkeys(self._casts)
        self._opened().add(
            self._piece, data, last=ticks[-1], ticks=len(ticks), casts=casts, markers=marks, curves=curves, calls=calls
        )

    def _hear_of_sounds(self, entries: list[AnyEntry]) -> set[str]:
        """Notes by what names sounds are known from now on; the keys and the names of those that have come."""
        there = set[str]()
        for entry in entries:
            if isinstance(entry, SoundsKnown):
                self._sounds_called = entry.called
                there.update(entry.seconds, entry.called)
            elif isinstance(entry, SnapshotTaken):
                self._sounds_called = entry.sounds_called
        return there

    def _keep_cast(self, cast: StoredCast, contents: list[tuple[str, bytes]], titled: Cast | PlayingCast) -> None:
        self._cast = (cast, contents)
        self._curves.cast = titled
        self._opened().keep_cast(cast, contents)

    def _keep_clip(self, clip: Clip) -> str:
        """Keeps a clip, and gives its key."""
        key = self._clips.get(clip)
        if key is None:
            data = stored_clip(clip).encode()
            key = "clip-" + hashlib.blake2b(data, digest_size=16).hexdigest()
            self._opened().keep_content(key, data)
            self._clips[clip] = key
        self._casts.append(key)
        if clip.sound:
            self._keep_sound(clip.sound)
        return key

    def _keep_sound(self, sound: str) -> None:
        """Keeps a sound that the piece needs, once; one that is not there any more is not heard in a replay."""
        sound = self._sounds_called.get(sound, sound)
        key = sound_key(sound)
        if key not in self._sounds:
            data = self._find_sound(sound)
            if data is None:
                return
            self._opened().keep_content(key, data)
            self._sounds.add(key)
        self._casts.append(key)

    def _pack(self) -> None:
        """Packs the piece that has ended, and makes room."""
        if self._piece is not None:
            file = self._opened()
            pack_piece(file, self._piece)
            lost = file.trim(RING_SECONDS)
            for clip in [clip for clip, key in self._clips.items() if key in lost]:
                del self._clips[clip]
            self._sounds -= lost
            self._piece = None

    def _carry_out(self, work: Callable[[RecordingFile], None], answer: Answer) -> None:
        try:
            work(self._opened())
        except ValueError as error:
            answer(str(error))
        except (sqlite3.Error, OSError) as error:
            answer(f"the recording cannot be written ({explain_database_error(error)})")
            raise
        else:
            answer("")

    def _keep(self, file: RecordingFile, name: str, seconds: float, now: float) -> None:
        first = next((piece.first for piece in file.pieces() if piece.start == self._start), now)
        file.keep(KeptRecording(name, self._start, max(first, now - seconds), now))


def pack_piece(file: RecordingFile, piece: int) -> None:
    """Packs a piece that nothing is added to any more; ValueError where it cannot be read. file: the open recording;
    piece: its id."""
    entries = pack_entries(read_entries(file, piece))
    parts = [unpack_curves(data) for data in file.curves([piece])]
    file.pack(piece, entries, pack_curves(join_curves(parts)) if parts else b"")


def read_entries(file: RecordingFile, piece: int) -> list[AnyEntry]:
    """The entries of a piece; ValueError where they are damaged, KeyError where it is not there any more. file: the
    open recording; piece: its id."""
    data = file.read(piece)
    if isinstance(data, bytes):
        return unpack_entries(data)
    return [entry for second in data for entry in decode_entries(second)]
