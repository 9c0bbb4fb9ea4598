"""`omote recording` and `omote replay`: what a show has recorded, for people and for programs."""

from __future__ import annotations

import json
import signal
import zipfile
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from omote.builtin import load_cast
from omote.cli import app
from omote.recording_commands import opened, read_clock, told_length
from omote.server.persistence.offline_show import open_offline_show
from omote.server.recording.archive import write_archive
from omote.server.recording.recording_thread import RecordingThread
from omote.show.objects.recordings import MarkMoment
from omote.show.objects.speech import PlaySound
from omote.showfile.recording_file import open_recording, recording_path
from omote.showfile.show_file import open_show
from tests.show.recording.random_show import RandomShow


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A show file with three seconds of recording."""
    path = tmp_path_factory.mktemp("recorded") / "a.omote"
    open_show(path).close()
    cast = load_cast()
    show = RandomShow(5, {cast.digest: cast})
    writer = RecordingThread(recording_path(path), pytest.fail, "test")
    writer.note_cast(cast, {})
    for number in range(180):
        if number == 30:
            show.send("ana", MarkMoment("mark-1", "laugh"))
        show.entries.clear()
        show.tick()
        writer.note(list(show.entries))
    writer.close()
    return path


def said(*arguments: object, status: int = 0) -> str:
    """What a command prints."""
    result = CliRunner().invoke(app, ["recording", *map(str, arguments)], env={"COLUMNS": "160"})
    assert result.exit_code == status, result.output
    return result.output


def test_what_is_recorded_is_listed_kept_and_let_go(file: Path) -> None:
    rows = json.loads(said("list", file, "--json"))
    assert [row["what"] for row in rows] == ["ring", "marker"]
    assert "opening is kept: 0:00:01.0" in said("keep", file, "opening", "--from", "0:01", "--to", "2")
    assert "opening" in said("list", file)
    assert "already" in said("keep", file, "opening", status=1)
    assert "no longer" in said("delete", file, "opening")
    assert "there is no recording 'opening'" in said("check", file, "opening", status=1)


def test_a_recording_is_checked(file: Path) -> None:
    assert "all 180 states are those that were sent" in said("check", file)
    assert "nothing between 1:00:00.0 and the end" in said("check", file, "--from", "1:00:00", status=1)


def test_a_replay_that_differs_says_where(file: Path, tmp_path: Path) -> None:
    from omote.server.recording.recording_thread import read_entries
    from omote.show.recording.entries import Ticked
    from omote.show.recording.packing import pack_entries

    other = tmp_path / "b.omote"
    original = open_recording(recording_path(file))
    original.copy_into(recording_path(other))
    original.close()
    recorded = open_recording(recording_path(other))
    (piece,) = recorded.pieces()
    entries = read_entries(recorded, piece.id)
    wrong = [place for place, entry in enumerate(entries) if isinstance(entry, Ticked)][99]
    entries[wrong] = Ticked(entries[wrong].now, 1)  # type: ignore[union-attr, arg-type]
    recorded.pack(piece.id, pack_entries(entries))
    recorded.close()
    assert "the state 100, 0:00:01" in said("check", other, status=1)


def test_who_did_what_is_told(file: Path) -> None:
    rows = json.loads(said("log", file, "--json"))
    assert {"ana", "bo", "cy", "di"} >= {row["who"] for row in rows} - {"phone one", "phone two"}
    assert [row["of"] for row in rows if row["what"] == "mark_moment"] == ["laugh"]


def test_a_log_tells_times_of_the_whole_whatever_it_begins_with(file: Path) -> None:
    rows = json.loads(said("log", file, "--json"))
    later = json.loads(said("log", file, "--json", "--from", "-1"))
    assert 0 < len(later) < len(rows)
    assert later == rows[-len(later) :]


def test_an_earlier_start_is_kept_told_checked_and_cut(file: Path, tmp_path: Path) -> None:
    """The show was killed and started again: what came before is named by its number."""
    other = tmp_path / "b.omote"
    open_show(other).close()
    original = open_recording(recording_path(file))
    original.copy_into(recording_path(other))
    original.close()
    cast = load_cast()
    show = RandomShow(6, {cast.digest: cast}, calm=1e9)
    writer = RecordingThread(recording_path(other), pytest.fail, "test")
    writer.note_cast(cast, {})
    show.play(0.5)
    writer.note(show.entries)
    writer.close()
    listed = json.loads(said("list", other, "--json"))
    assert [row["start"] for row in listed if row["what"] == "ring"] == [1, 2]
    assert "all 30 states" in said("check", other)
    assert "all 180 states" in said("check", other, "--start", "1")
    assert json.loads(said("log", other, "--json", "--start", "1")) == json.loads(said("log", file, "--json"))
    assert "laugh" in said("notes", other, "--start", "1")
    assert "laugh" not in said("notes", other, "--start", "2")
    assert "before is kept: 0:00:02.0" in said("keep", other, "before", "--start", "1", "--from", "-2")
    assert "not both" in said("check", other, "before", "--start", "1", status=1)
    refusal = " ".join(said("keep", other, "gone", "--start", "3", status=1).split())
    assert "of the start 3 of the show; there are 1 (" in refusal
    assert ", 2 (" in refusal
    assert "the clip before" in said("clip", other, "before", "--start", "1", "--from", "0:01", "--to", "2")


def test_a_day_is_one_archive(file: Path, tmp_path: Path) -> None:
    archive = tmp_path / "day.zip"
    told = said("archive", file, "-o", archive)
    assert "writes who did what in start 1 of 1 ..." in told
    assert "packs a.omote-recording, " in told
    with zipfile.ZipFile(archive) as opened:
        assert sorted(opened.namelist()) == ["a.omote", "a.omote-recording", "log-1.csv", "main.cues.toml"]
        opened.extractall(tmp_path / "out")
    assert "all 180 states" in said("check", tmp_path / "out" / "a.omote")
    assert "there already" in said("archive", file, "-o", archive, status=1)


def test_an_archive_that_is_stopped_leaves_nothing(file: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    folder.mkdir()

    def stop(step: str) -> None:
        if step.startswith("packs"):
            signal.raise_signal(signal.SIGTERM)

    with opened(file) as (show, recorded), pytest.raises(SystemExit, match=str(128 + signal.SIGTERM)):
        write_archive(file, recorded, show, folder / "day.zip", stop)
    assert [*folder.iterdir()] == []
    assert signal.getsignal(signal.SIGTERM) == signal.SIG_DFL


def test_without_a_recording_that_is_said(tmp_path: Path) -> None:
    open_show(tmp_path / "a.omote").close()
    assert "no recording" in said("list", tmp_path / "a.omote", status=1)


@pytest.mark.parametrize(
    ("text", "seconds"), [("12.5", 12.5), ("1:30", 90.0), ("1:02:30", 3750.0), ("90", 90.0), ("-20:00", -1200.0)]
)
def test_a_time_is_read_as_people_write_it(text: str, seconds: float) -> None:
    assert read_clock(text) == seconds


@pytest.mark.parametrize("text", ["", "soon", "1:2:3:4", "--5", "1::2"])
def test_what_is_no_time_is_refused(text: str) -> None:
    with pytest.raises(typer.BadParameter, match="no time"):
        read_clock(text)


def test_a_length_is_told_as_people_write_it() -> None:
    assert told_length(3725.26) == "1:02:05.3"


def test_a_sound_is_forgotten_once_no_show_plays_the_file(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    open_show(path).close()
    cast = load_cast()
    show = RandomShow(5, {cast.digest: cast}, calm=1e9)
    writer = RecordingThread(recording_path(path), pytest.fail, "test", {"bell": b"ding"}.get)
    show.send("ana", PlaySound("one", "a", "bell"))
    show.play(0.1)
    writer.note(show.entries)
    writer.close()
    assert "there is no sound 'gong' in this recording" in said("forget", path, "bell", "gong", status=1)
    with open_offline_show(path):
        assert "plays" in said("forget", path, "bell", status=1)
    assert "no recording of bell any more" in said("forget", path, "bell")
    assert "there is no sound 'bell'" in said("forget", path, "bell", status=1)
    assert b"ding" not in recording_path(path).read_bytes()
