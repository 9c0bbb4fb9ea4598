"""What the processes of a show do beside jobs of files: they replay a recording while the show plays on."""

from __future__ import annotations

import sqlite3
from pathlib import Path

import msgspec

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.server.recording.recorded_clip import curve_of
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.server.workers.file_jobs import run_file_job
from omote.server.workers.job_server import Follow
from omote.server.workers.recorded_clip_job import CutRecordedClip
from omote.show.objects.clips import stored_clip
from omote.showfile.database_errors import describe_error
from omote.showfile.recording_file import open_recording
from omote.showfile.schema import ShowFileError

_tag = msgspec.msgpack.Decoder(dict[str, msgspec.Raw])
_job = msgspec.msgpack.Decoder(CutRecordedClip)
_OWN = msgspec.msgpack.encode(CutRecordedClip.__struct_config__.tag)


def run_job(job: bytes, follow: Follow, /) -> bytes:
    """Does an encoded job of a recording or of a file and returns what it makes; ValueError with a sentence for what
    cannot be done.

    job: MessagePack; follow: told of steps done, all steps and what is done now.
    """
    if bytes(_tag.decode(job).get("type", msgspec.Raw())) != _OWN:
        return run_file_job(job, follow)
    try:
        return cut_clip(_job.decode(job), load_cast())
    except (ShowFileError, OSError, sqlite3.Error) as error:
        raise ValueError(describe_error(error)) from error


def cut_clip(wanted: CutRecordedClip, cast: Cast) -> bytes:
    """The clip that is wanted, as `StoredClip` (JSON). cast: the built-in one. ValueError where it cannot be cut,
    ShowFileError or sqlite3.Error where the recording cannot be read."""
    recorded = open_recording(Path(wanted.recording))
    show = RecordedShow(recorded, cast)
    try:
        whole = show.find_span()
        span = Span(whole.start, max(whole.first, wanted.first), min(whole.last, wanted.last))
        return stored_clip(Clip([Lane(curve_of(show, span, wanted.character))])).encode()
    finally:
        show.close()
        recorded.close()
