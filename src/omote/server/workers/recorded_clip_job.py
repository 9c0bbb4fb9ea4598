"""The job that cuts a clip from the recording of a show that plays; `recording/recording_jobs.py` does it."""

from __future__ import annotations

import msgspec


class CutRecordedClip(msgspec.Struct, frozen=True, tag=True):
    """What a character did from `first` to `last` (seconds of the machine's clock) of the last start of a show. Made: a
    `StoredClip` of one lane, JSON. recording: the path of the recording."""

    recording: str
    character: str
    first: float
    last: float
