"""The recording of a show over real sockets: moments are marked, runs are kept, and what there is is told."""

from __future__ import annotations

import asyncio
from pathlib import Path

import msgspec
import pytest
from aiohttp import ClientWebSocketResponse

from omote.perform.clips.clip_parts import CLIP_PARTS
from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_jobs import cut_clip
from omote.server.recording.recording_thread import RecordingThread
from omote.server.workers.recorded_clip_job import CutRecordedClip
from omote.show.declaration import ClientMessage, ServerMessage
from omote.show.objects.calls import CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Refused
from omote.show.objects.recordings import (
    DeleteRecording,
    KeepClip,
    KeepRecording,
    MarkMoment,
    RecordingKept,
    RecordingsDocument,
)
from omote.show.wire import encode
from omote.showfile.recording_file import open_recording
from tests.server.conftest import ShowHarness, answer, send_and_wait

pytestmark = pytest.mark.asyncio


async def test_a_show_is_recorded_marked_and_kept(show_harness: ShowHarness, tmp_path: Path) -> None:
    path = tmp_path / "a.omote-recording"
    writer = RecordingThread(path, pytest.fail, "test")
    show_harness.show.recording.enable(writer)
    link = await show_harness.link()
    await send_and_wait(link, CallFace("one", "1", "broad", 1.0), MarkMoment("2", "laugh"))
    for _ in range(20):
        show_harness.tick()
    for message, kind in (
        (KeepRecording("3", "opening", 1.0), RecordingKept),
        (KeepRecording("4", "opening", 1.0), Refused),
        (KeepRecording("5", "other", -1.0), Refused),
        (DeleteRecording("6", "nothing"), Refused),
    ):
        assert isinstance(await asked(show_harness, link, message), kind)
    told = msgspec.json.decode(await (await show_harness.client.get("/recordings")).read(), type=RecordingsDocument)
    assert [span.name for span in told.kept] == ["opening"]
    assert [(mark.name, mark.who) for mark in told.markers] == [("laugh", "console 1")]
    assert len(told.spans) == 1
    writer.close()
    file = open_recording(path)
    reading = RecordedShow(file, show_harness.show.documents.cast)
    ticks = list(reading.replay(reading.find_span("opening")))
    assert len(ticks) >= 20
    assert all(tick.same for tick in ticks)
    reading.close()
    file.close()


async def test_a_clip_is_kept_of_what_showed_while_the_show_plays(show_harness: ShowHarness, tmp_path: Path) -> None:
    path = tmp_path / "a.omote-recording"
    writer = RecordingThread(path, pytest.fail, "test")
    jobs: list[CutRecordedClip] = []

    async def run_job(job: bytes, _: object) -> bytes:
        jobs.append(msgspec.msgpack.decode(job, type=CutRecordedClip))
        return await asyncio.to_thread(cut_clip, jobs[-1], show_harness.show.documents.cast)

    show_harness.show.recording.enable(writer, run_job)
    link = await show_harness.link()
    await send_and_wait(link, SetChannel("one", "jawOpen", 1.0))
    for _ in range(30):
        show_harness.tick()
    assert isinstance(await asked(show_harness, link, KeepClip("3", "line", "one", 60.0)), RecordingKept)
    assert isinstance(await asked(show_harness, link, KeepClip("4", "line", "one", 60.0, ["mouth"])), RecordingKept)
    clip = show_harness.show.session.clips.clips["line"]
    assert [lane.parts for lane in clip.lanes] == [CLIP_PARTS, ("mouth",)]
    assert clip.lanes[0].curve.stop > 0.4
    refused = await asked(show_harness, link, KeepClip("5", "other", "nobody"))
    assert isinstance(refused, Refused)
    assert len(jobs) == 2
    writer.close()


async def asked(harness: ShowHarness, link: ClientWebSocketResponse, message: ClientMessage) -> ServerMessage:
    """What a message of the recording is answered with: the thread answers after the tick that hands it over."""
    await link.send_bytes(encode(message))
    while True:
        harness.tick()
        said = await answer(link)
        if isinstance(said, RecordingKept | Refused):
            return said


async def test_a_show_that_is_not_recorded_says_so(show_harness: ShowHarness) -> None:
    link = await show_harness.link()
    for message in (MarkMoment("1", "laugh"), KeepRecording("2", "opening")):
        await link.send_bytes(encode(message))
        refused = await answer(link)
        assert isinstance(refused, Refused)
        assert "not recorded" in refused.reason
    assert (await show_harness.client.get("/recordings")).status == 204
