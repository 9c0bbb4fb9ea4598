"""A recording that is read from the disk: replayed from any moment to the last bit, and told as who did what."""

from __future__ import annotations

from pathlib import Path

import pytest

from omote.server.recording import recorded_show
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.server.recording.recording_thread import RecordingThread, read_entries
from omote.show.objects.recordings import MarkMoment
from omote.show.recording import recorder
from omote.show.recording.entries import AnyEntry
from omote.show.recording.replay import ReplayError
from omote.show.wire import encode
from omote.showfile.recording_file import RecordingFile, open_recording, recording_path
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
        writer.note(list(show.entries), show.states[-1])
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


def test_a_seek_unpacks_one_piece_before_its_first_tick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = recording_path(tmp_path / "show.omote")
    record(path, 2, 8.0)
    file = open_recording(path)
    read: list[int] = []

    def note(file: RecordingFile, piece: int) -> list[AnyEntry]:
        read.append(piece)
        return read_entries(file, piece)

    monkeypatch.setattr(recorded_show, "read_entries", note)
    reading = RecordedShow(file, CAST)
    span = reading.find_span()
    ticks = reading.replay(span, after=span.first + 0.3)
    first = next(ticks)
    assert read == [file.pieces()[0].id]
    rest = list(ticks)
    assert read == [piece.id for piece in file.pieces()]
    assert len(read) > 2
    assert first.now < rest[0].now
    reading.close()
    file.close()


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
