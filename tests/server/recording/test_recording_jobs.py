"""Jobs of a recording go where recordings are read; all others are those of files."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest

from omote.builtin import load_cast
from omote.server.recording.recording_jobs import run_job
from omote.server.recording.recording_thread import RecordingThread
from omote.server.workers.file_jobs import ListVoices
from omote.server.workers.recorded_clip_job import CutRecordedClip
from omote.show.objects.clips import StoredClip, clip_of
from omote.show.objects.documents import read_document
from tests.show.recording.random_show import RandomShow


def test_a_clip_is_cut_from_a_show_that_plays(tmp_path: Path) -> None:
    path = tmp_path / "a.omote-recording"
    cast = load_cast()
    show = RandomShow(31, {cast.digest: cast})
    writer = RecordingThread(path, pytest.fail, "test")
    writer.note_cast(cast, {})
    for _ in range(90):
        show.entries.clear()
        show.tick()
        writer.note(list(show.entries))
    writer.close()
    job = CutRecordedClip(str(path), "one", show.now - 1.0, show.now + 5.0)
    clip = clip_of(read_document(StoredClip, run_job(msgspec.msgpack.encode(job), lambda *_: None)))
    assert 0.5 < clip.seconds <= 1.4
    with pytest.raises(ValueError, match="nobody"):
        run_job(msgspec.msgpack.encode(msgspec.structs.replace(job, character="nobody")), lambda *_: None)
    with pytest.raises(ValueError, match="no recording"):
        run_job(msgspec.msgpack.encode(msgspec.structs.replace(job, recording=str(tmp_path / "b"))), lambda *_: None)


def test_other_jobs_are_those_of_files() -> None:
    assert isinstance(msgspec.msgpack.decode(run_job(msgspec.msgpack.encode(ListVoices()), lambda *_: None)), list)
