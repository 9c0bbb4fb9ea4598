"""The job comes to its process as it was sent."""

import msgspec

from omote.server.workers.recorded_clip_job import CutRecordedClip


def test_a_job_comes_back() -> None:
    job = CutRecordedClip("a", "one", 1.0, 2.0)
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(job), type=CutRecordedClip) == job
