"""What a show does is on the disk a second later, and is replayed from there to the last bit."""

from __future__ import annotations

import sqlite3
import zlib
from pathlib import Path

import pytest

from omote.server.recording.recorded_show import RecordedShow, Span
from omote.server.recording.recording_thread import RecordingThread
from omote.show.objects.recordings import MarkMoment
from omote.show.recording import recorder
from omote.show.recording.entries import Ticked, encode_entries
from omote.show.recording.recorder import Recorder
from omote.show.recording.replay import ReplayError
from omote.show.session import ShowSession
from omote.show.wire import encode
from omote.showfile.recording_file import KeptRecording, open_recording, recording_path
from omote.showfile.schema import ShowFileError
from tests import synthetic
from tests.show.recording.random_show import RandomShow

CAST = synthetic.cast()


@pytest.fixture(autouse=True)
def short_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recorder, "SNAPSHOT_SECONDS", 0.5)
    monkeypatch.setattr(recorder, "PIECE_SNAPSHOTS", 4)


def record(path: Path, seed: int, seconds: float) -> RandomShow:
    """Records a random show."""
    said: list[str] = []
    writer = RecordingThread(path, said.append, "test")
    show = RandomShow(seed, {CAST.digest: CAST})
    writer.note_cast(CAST, {})
    for number in range(round(60 * seconds)):
        if number == 10:
            show.send("ana", MarkMoment("mark-1", "here"))
        show.entries.clear()
        show.tick()
        writer.note(list(show.entries))
    writer.close()
    assert said == []
    return show


def test_a_recording_is_replayed_from_the_disk_from_any_moment(tmp_path: Path) -> None:
    path = recording_path(tmp_path / "show.omote")
    show = record(path, 1, 12.0)
    file = open_recording(path)
    assert file.unpacked() == []
    reading = RecordedShow(file, CAST)
    span = reading.find_span()
    ticks = list(reading.replay(span))
    assert [encode(tick.state) for tick in ticks] == show.states
    assert all(tick.same for tick in ticks)
    for number in (0, 100, 333, 700):
        later = reading.replay(span, after=ticks[number].now)
        assert encode(next(later).state) == show.states[number + 1]
    assert [marker.name for marker in file.markers()] == ["here"]
    assert [line.of for line in reading.log(span) if line.what == "mark_moment"] == ["here"]
    reading.close()
    file.close()


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


def test_the_ring_keeps_what_has_a_name(tmp_path: Path) -> None:
    path = recording_path(tmp_path / "show.omote")
    record(path, 3, 20.0)
    file = open_recording(path)
    pieces = file.pieces()
    first = pieces[0]
    file.keep(KeptRecording("opening", first.start, first.first, first.last))
    with pytest.raises(ValueError, match="already"):
        file.keep(KeptRecording("opening", first.start, first.first, first.last))
    file.trim(4.0)
    left = [piece.id for piece in file.pieces()]
    assert left[0] == first.id
    assert 2 < len(left) < len(pieces)
    file.delete("opening")
    file.trim(4.0)
    assert [piece.id for piece in file.pieces()] == left[1:]
    file.trim(0.0)
    assert file.casts() == {}
    with pytest.raises(ValueError, match="no recording 'opening'"):
        file.delete("opening")
    file.close()


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


def test_what_is_no_recording_is_refused_and_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "other"
    with pytest.raises(ShowFileError, match="no recording"):
        open_recording(path)
    connection = sqlite3.connect(path)
    connection.execute("CREATE TABLE anything (x)")
    connection.close()
    before = path.read_bytes()
    with pytest.raises(ShowFileError, match="no recording of a show"):
        open_recording(path, new=True)
    assert path.read_bytes()[100:] == before[100:]


def test_a_damaged_minute_is_said(tmp_path: Path) -> None:
    path = recording_path(tmp_path / "show.omote")
    record(path, 4, 2.0)
    file = open_recording(path)
    file._connection.execute("UPDATE piece SET packed = X'00'")
    reading = RecordedShow(file, CAST)
    with pytest.raises(ReplayError, match="damaged"):
        list(reading.replay(reading.find_span()))
    with pytest.raises(ValueError, match="no recording"):
        reading.find_span("nothing")
    assert list(reading.replay(Span(99, 0.0, 1.0))) == []
    reading.close()
    file.close()
