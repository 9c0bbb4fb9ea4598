"""What a show does is on the disk a second later; a disk that fails costs the recording alone."""

from __future__ import annotations

import sqlite3
import threading
import time
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

from omote.server.recording import recording_thread
from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_thread import RecordingThread, read_entries
from omote.show.objects.clips import DropClip, KeepPass, PlayClip, RecordClip, RestoreClip
from omote.show.objects.speech import PlaySound
from omote.show.recording import recorder
from omote.show.recording.entries import Ticked, begins_piece, encode_entries
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession
from omote.show.wire import encode
from omote.showfile.recording_file import RecordingFile, open_recording, recording_path
from tests import synthetic
from tests.server.recording.test_recorded_show import record
from tests.show.recording.random_show import RandomShow

CAST = synthetic.cast()


@pytest.fixture(autouse=True)
def short_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recorder, "SNAPSHOT_SECONDS", 0.5)
    monkeypatch.setattr(recorder, "PIECE_SNAPSHOTS", 4)


def test_what_a_process_that_died_had_written_is_replayed_and_packed_by_the_next(tmp_path: Path) -> None:
    path = recording_path(tmp_path / "show.omote")
    file = open_recording(path, new=True)
    show = RandomShow(2, {CAST.digest: CAST})
    show.play(3.0)
    first = next(entry.now for entry in show.entries if isinstance(entry, Ticked))
    piece = file.begin_piece(file.begin_start(1e9, first, "test"), first)
    file.add(piece, encode_entries(show.entries), last=show.now, ticks=len(show.states), casts=[CAST.digest])
    file.close()
    RecordingThread(path, lambda _: None, "test").close()
    again = open_recording(path)
    reading = RecordedShow(again, CAST)
    assert [encode(tick.state) for tick in reading.replay(reading.find_span())] == show.states
    reading.close()
    again.close()


def test_a_disk_that_fails_costs_the_recording_and_is_said_once(tmp_path: Path) -> None:
    path = tmp_path / "show.omote-recording"
    path.mkdir()
    said: list[str] = []
    writer = RecordingThread(path, said.append, "test")
    session = ShowSession(CAST)
    notes = Recorder(session)
    for number in range(90):
        data = encode(session.tick(number / 60))
        writer.note(notes.take(zlib.crc32(data)))
    writer.close()
    assert len(said) == 1
    assert "goes on without it" in said[0]


def test_a_minute_that_cannot_be_read_stays_as_it_is_and_costs_no_other(tmp_path: Path) -> None:
    path = recording_path(tmp_path / "show.omote")
    file = open_recording(path, new=True)
    left = file.begin_piece(file.begin_start(1e9, 0.0, "another"), 0.0)
    file.add(left, b"what another version wrote", last=1.0, ticks=1)
    file.close()
    show = record(path, 14, 2.0)
    again = open_recording(path)
    assert again.unpacked() == [left]
    reading = RecordedShow(again, CAST)
    assert [encode(tick.state) for tick in reading.replay(reading.find_span())] == show.states
    reading.close()
    again.close()


def test_after_a_disk_that_failed_a_piece_begins_with_a_snapshot(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = recording_path(tmp_path / "show.omote")
    begin = RecordingFile.begin_piece
    failures = iter([True])

    def fail_once(file: RecordingFile, start: int, first: float) -> int:
        if next(failures, False):
            raise sqlite3.OperationalError("disk I/O error")
        return begin(file, start, first)

    monkeypatch.setattr(RecordingFile, "begin_piece", fail_once)
    monkeypatch.setattr(recording_thread, "ADD_SECONDS", 0.001)
    said: list[str] = []
    writer = RecordingThread(path, said.append, "test")
    session = ShowSession(CAST)
    notes = Recorder(session)
    for number in range(400):
        data = encode(session.tick(number / 60))
        writer.note(notes.take(zlib.crc32(data)))
        if number == 5:
            wait_until(lambda: bool(said))
    writer.close()
    assert ["written again" in sentence for sentence in said] == [False, True]
    file = open_recording(path)
    pieces = [read_entries(file, piece.id) for piece in file.pieces()]
    assert pieces
    assert all(begins_piece(entries[0]) for entries in pieces)
    file.close()


def test_what_the_ring_has_lost_is_kept_anew_where_it_is_played_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recording_thread, "RING_SECONDS", 1.0)
    path = recording_path(tmp_path / "show.omote")
    writer = RecordingThread(path, pytest.fail, "test")
    writer.note_cast(CAST, {})
    show = RandomShow(15, {CAST.digest: CAST}, calm=1e9)

    def play(seconds: float) -> None:
        for _ in range(round(60 * seconds)):
            show.entries.clear()
            show.tick()
            writer.note(list(show.entries))

    show.send("ana", RecordClip("a", "one", "line"))
    play(1.0)
    show.send("ana", KeepPass("b", "one"))
    play(1.0)
    show.send("ana", DropClip("c", "line"))
    for _ in range(3):
        play(3.0)
        writer_is_idle(writer)
    show.send("ana", RestoreClip("d", "line"))
    show.send("ana", PlayClip("one", "e", "line"))
    play(1.0)
    writer.close()
    file = open_recording(path)
    reading = RecordedShow(file, CAST)
    ticks = list(reading.replay(reading.find_span()))
    assert [encode(tick.state) for tick in ticks] == show.states[-len(ticks) :]
    assert len(ticks) < len(show.states)
    reading.close()
    file.close()


def test_a_sound_is_kept_once_while_the_ring_needs_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recording_thread, "RING_SECONDS", 1.0)
    path = recording_path(tmp_path / "show.omote")
    asked: list[str] = []

    def find(key: str) -> bytes | None:
        asked.append(key)
        return {"bell": b"ding"}.get(key)

    writer = RecordingThread(path, pytest.fail, "test", find)
    show = RandomShow(15, {CAST.digest: CAST}, calm=1e9)
    show.session.set_sounds({"bell": 3.0, "gong": 2.0})

    def play(seconds: float) -> None:
        for _ in range(round(60 * seconds)):
            show.entries.clear()
            show.tick()
            writer.note(list(show.entries))
        writer_is_idle(writer)

    def kept() -> bool:
        file = open_recording(path)
        reading = RecordedShow(file, CAST)
        found = reading.find_sound("bell")
        assert reading.find_sound("gong") is None
        reading.close()
        file.close()
        assert found in (None, b"ding")
        return found is not None

    show.send("ana", PlaySound("one", "a", "bell"))
    show.send("ana", PlaySound("two", "b", "gong"))
    play(2.5)
    assert kept(), "the second minute begins while it is heard"
    assert asked.count("bell") == 1
    play(9.0)
    assert not kept()
    show.send("ana", RecordClip("c", "one", "line", sound="bell"))
    play(0.5)
    show.send("ana", KeepPass("d", "one"))
    play(9.0)
    assert kept(), "a clip has it"
    assert asked.count("bell") == 2
    writer.close()


def writer_is_idle(writer: RecordingThread) -> None:
    """Returns when all that was noted is written."""
    written = threading.Event()
    writer.flush(lambda _: written.set())
    assert written.wait(60.0)


def wait_until(holds: Callable[[], bool]) -> None:
    """Waits for what another thread brings about."""
    until = time.monotonic() + 60.0
    while not holds():
        assert time.monotonic() < until
        time.sleep(0.005)
