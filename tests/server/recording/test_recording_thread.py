"""What a show does is on the disk a second later; a disk that fails costs the recording alone."""

from __future__ import annotations

import zlib
from pathlib import Path

import pytest

from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_thread import RecordingThread
from omote.show.recording import recorder
from omote.show.recording.entries import Ticked, encode_entries
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession
from omote.show.wire import encode
from omote.showfile.recording_file import open_recording, recording_path
from tests import synthetic
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
