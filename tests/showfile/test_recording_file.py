"""The file of a recording: a ring of minutes, and what is kept of it."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from omote.show.recording import recorder
from omote.showfile.recording_file import KeptRecording, open_recording, recording_path, sound_key
from omote.showfile.schema import ShowFileError
from tests import synthetic
from tests.server.recording.test_recorded_show import record

CAST = synthetic.cast()


@pytest.fixture(autouse=True)
def short_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recorder, "SNAPSHOT_SECONDS", 0.5)
    monkeypatch.setattr(recorder, "PIECE_SNAPSHOTS", 4)


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


def test_a_sound_is_forgotten_with_all_that_needed_it(tmp_path: Path) -> None:
    file = open_recording(recording_path(tmp_path / "show.omote"), new=True)
    start = file.begin_start(1e9, 0.0, "test")
    for place, casts in enumerate((["a"], ["a", sound_key("bell")], ["a", sound_key("gong")])):
        piece = file.begin_piece(start, 60.0 * place)
        for key in casts[1:]:
            file.keep_content(key, b"ding")
        file.add(piece, b"", last=60.0 * place + 59.0, ticks=1, casts=casts)
    assert file.forget([sound_key("bell")]) == 59.0
    assert [piece.first for piece in file.pieces()] == [0.0, 120.0]
    assert file.contents([sound_key("bell"), sound_key("gong")]) == {sound_key("gong"): b"ding"}
    file.close()


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


def test_another_process_that_looks_takes_nothing_from_one_that_writes_and_looks(tmp_path: Path) -> None:
    """To close any descriptor of a file drops all locks that a process has of it: whoever came next from outside then
    took itself for the last one, and deleted the log under the writer."""
    path = recording_path(tmp_path / "show.omote")
    writer = open_recording(path, new=True)
    start = writer.begin_start(1e9, 0.0, "test")
    open_recording(path).close()  # as pages do that compare runs
    look = "import sys, pathlib; from omote.showfile.recording_file import open_recording as o; "
    subprocess.run([sys.executable, "-c", f"{look}o(pathlib.Path(sys.argv[1])).close()", str(path)], check=True)
    writer.begin_piece(start, 0.0)
    reader = open_recording(path)
    assert [piece.first for piece in reader.pieces()] == [0.0]
    reader.close()
    writer.close()
