"""What pages read and note of a recording, over real sockets."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest

from omote.server.recording.recording_thread import RecordingThread
from omote.show.objects.recordings import RecordingsDocument, RunDocument
from omote.show.recording.curves import join_curves, unpack_curves
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio


async def test_notes_are_stamped_when_their_writer_began_and_changed_and_deleted(
    show_harness: ShowHarness, tmp_path: Path
) -> None:
    writer = RecordingThread(tmp_path / "a.omote-recording", pytest.fail, "test")
    client = show_harness.client
    assert (await client.get("/recordings")).status == 204
    assert (await client.post("/markers", json={"name": "late"})).status == 400
    show_harness.show.recording.enable(writer)
    for _ in range(90):
        show_harness.tick()
    now = show_harness.show.clock()
    assert (await client.post("/markers", json={"name": " late ", "before": 0.5, "who": "dora"})).status == 204
    for wrong in ({"name": " "}, {"name": "x", "before": -1.0}, {"name": "x", "after": 1.0}, {}):
        refused = await client.post("/markers", json=wrong)
        assert refused.status == 400
        assert "Nothing was noted" in await refused.text()
    told = await recorded(show_harness)
    (mark,) = told.markers
    assert (mark.name, mark.who) == ("late", "dora")
    assert mark.at == pytest.approx(now - 0.5)
    assert told.files == ["a.omote"]
    assert told.now == pytest.approx(mark.written + 0.5)
    assert (await client.post(f"/markers/{mark.id}", json={"name": "too late"})).status == 204
    assert [each.name for each in (await recorded(show_harness)).markers] == ["too late"]
    assert (await client.delete(f"/markers/{mark.id}")).status == 204
    assert (await recorded(show_harness)).markers == []
    gone = await client.delete(f"/markers/{mark.id}")
    assert (gone.status, await gone.text()) == (400, "that note is not there any more. Nothing was changed.")
    assert (await client.delete("/markers/last")).status == 404
    span = told.spans[0]
    asked = {"start": span.start, "first": span.first, "last": span.first + 60.0}
    run = msgspec.msgpack.decode(await (await client.get("/curves", params=asked)).read(), type=RunDocument)
    curves = join_curves([unpack_curves(piece) for piece in run.pieces])
    assert len(curves.times) > 10
    assert list(curves.values) == ["one"]
    assert (await client.get("/curves", params=asked | {"first": "soon"})).status == 400
    assert (await client.get("/curves", params=asked | {"file": "1"})).status == 404
    writer.close()


async def recorded(harness: ShowHarness) -> RecordingsDocument:
    return msgspec.json.decode(await (await harness.client.get("/recordings")).read(), type=RecordingsDocument)
