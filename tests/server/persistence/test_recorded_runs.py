"""What a recording holds, as people read it: markers with their cues, and the curves of its runs."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest

from omote.server.persistence.recorded_runs import (
    cue_at,
    curves_of,
    describe_recordings,
    describe_run,
    write_curves,
    write_markers,
)
from omote.server.recording.recording_thread import read_entries
from omote.show.recording import recorder
from omote.show.recording.curves import QUANTITIES, CueCall, unpack_curves
from omote.show.recording.entries import Ticked
from omote.showfile.recording_file import KeptRecording, RecordingFile, open_recording, recording_path
from tests.server.recording.test_recorded_show import record


@pytest.fixture(autouse=True)
def short_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recorder, "SNAPSHOT_SECONDS", 0.5)
    monkeypatch.setattr(recorder, "PIECE_SNAPSHOTS", 4)


@pytest.fixture
def file(tmp_path: Path) -> RecordingFile:
    """Nine seconds of a random show, in pieces of two."""
    path = recording_path(tmp_path / "show.omote")
    record(path, 21, 9.0)
    return open_recording(path)


def test_curves_go_on_over_minutes_and_are_packed_with_them(file: RecordingFile) -> None:
    pieces = file.pieces()
    curves = curves_of(file, 1, pieces[0].first, pieces[-1].last)
    entries = [entry for piece in pieces for entry in read_entries(file, piece.id)]
    ticks = [entry.now for entry in entries if isinstance(entry, Ticked)]
    assert curves.times == pytest.approx(np.array(ticks[5::6]), abs=0.002)
    assert len(file.curves(piece.id for piece in pieces)) == len(pieces)
    run = describe_run(file, 1, pieces[1].first, pieces[1].last)
    (packed,) = run.pieces
    piece = unpack_curves(packed)
    assert list(piece.times) == list(curves_of(file, 1, pieces[1].first, pieces[1].last).times)
    assert set(piece.values) <= set(curves.values)
    file.close()


def test_curves_go_with_the_ring_and_stay_with_what_has_a_name(file: RecordingFile) -> None:
    first = file.pieces()[0]
    file.keep(KeptRecording("opening", first.start, first.first, first.last))
    file.trim(0.0)
    assert [piece.id for piece in file.pieces()] == [first.id]
    assert len(curves_of(file, 1, first.first, first.last).times) > 10
    file.delete("opening")
    file.trim(0.0)
    assert file.curves([first.id]) == []
    assert file.cue_calls(1) == []
    file.close()


def test_what_was_recorded_without_curves_has_none(file: RecordingFile, tmp_path: Path) -> None:
    path = file.path
    first, last = file.pieces()[0].first, file.pieces()[-1].last
    file._connection.executescript("DROP TABLE curves; DROP TABLE cue_call;")
    file.close()
    older = open_recording(path)
    run = describe_run(older, 1, first, last)
    assert (run.pieces, run.cues) == ([], [])
    text = io.StringIO()
    assert write_curves(older, 1, first, last, text) == 0
    assert text.getvalue() == ""
    older.close()


def test_a_table_has_a_row_for_each_character_and_time(file: RecordingFile) -> None:
    first, last = file.pieces()[0].first, file.pieces()[-1].last
    curves = curves_of(file, 1, first, last)
    there = sum(int((~np.isnan(table[:, 0])).sum()) for table in curves.values.values())
    text = io.StringIO()
    assert write_curves(file, 1, first, last, text) == there
    rows = list(csv.DictReader(io.StringIO(text.getvalue())))
    assert len(rows) == there
    assert {row["character"] for row in rows} == set(curves.values)
    column = [float(row["head_yaw"]) for row in rows if row["character"] == "one"]
    place = list(QUANTITIES).index("head_yaw")
    expected = curves.values["one"][:, place]
    assert column == pytest.approx(list(expected[~np.isnan(expected)]))
    file.close()


def test_markers_are_marked_changed_and_deleted_by_those_who_may(file: RecordingFile) -> None:
    first, last = file.pieces()[0].first, file.pieces()[-1].last
    file.mark(None, last - 1.0, "too late", "dora")
    with pytest.raises(ValueError, match="nothing was recorded then"):
        file.mark(1, first - 60.0, "before", "dora")
    with pytest.raises(ValueError, match="nothing was recorded then"):
        file.mark(7, last, "another night", "dora")
    here, late = file.markers()
    with pytest.raises(ValueError, match="of ana: only operators"):
        file.rename_marker(here.id, "mine", "dora")
    with pytest.raises(ValueError, match="only operators"):
        file.delete_marker(late.id, "")
    file.rename_marker(late.id, "much too late", "dora")
    file.delete_marker(here.id, None)
    assert [(mark.name, mark.who, mark.at) for mark in file.markers()] == [("much too late", "dora", last - 1.0)]
    with pytest.raises(ValueError, match="not there any more"):
        file.delete_marker(here.id, None)
    text = io.StringIO()
    write_markers(describe_recordings(file), text)
    (row,) = csv.DictReader(io.StringIO(text.getvalue()))
    assert (row["who"], row["note"]) == ("dora", "much too late")
    assert float(row["seconds"]) == pytest.approx(last - 1.0 - first, abs=0.051)
    file.close()


def test_the_cue_of_a_time_is_the_one_that_was_called_last() -> None:
    calls = [CueCall(1.0, "main", "1"), CueCall(2.0, "main", "2.5")]
    assert [cue_at(calls, at) for at in (0.5, 1.0, 1.9, 9.0)] == ["", "1", "1", "2.5"]
