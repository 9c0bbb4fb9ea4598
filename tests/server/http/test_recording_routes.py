"""The recording of a show over real sockets: moments are marked, runs are kept, and what there is is told."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest
from aiohttp import ClientWebSocketResponse

from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_thread import RecordingThread
from omote.show.declaration import ClientMessage, ServerMessage
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Refused
from omote.show.objects.recordings import (
    DeleteRecording,
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
