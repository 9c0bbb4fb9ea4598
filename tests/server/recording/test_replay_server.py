"""A replay behind a real socket: its states are those of the recording, under numbers of its own; nothing is played."""

from __future__ import annotations

from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import pytest
import pytest_asyncio
from aiohttp.test_utils import TestClient, TestServer

from omote.model.cast import Cast
from omote.server.access.security import own_names
from omote.server.http.cast_documents import CastDocuments
from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.replay_server import ReplayServer
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Hello, Refused, Welcome
from omote.show.objects.state import State
from omote.show.wire import decode_answer, encode
from omote.showfile.recording_file import open_recording, recording_path
from tests.server.conftest import answer
from tests.server.recording.test_recorded_show import record
from tests.server.synthetic_server import MASK, PAGES, meshes

pytestmark = pytest.mark.asyncio


@dataclass
class Harness:
    """A replay, and a client of it."""

    replay: ReplayServer
    client: TestClient[Any, Any]
    states: list[State]

    async def ask(self, **asked: object) -> dict[str, Any]:
        """Asks for something, and returns how far it is."""
        response = await self.client.post("/replay/transport", json=asked)
        assert response.status == 200, await response.text()
        return dict(await response.json())


@pytest_asyncio.fixture
async def harness(cast: Cast, tmp_path: Path) -> AsyncIterator[Harness]:
    """A replay of two seconds."""
    path = recording_path(tmp_path / "show.omote")
    show = record(path, 12, 2.0)
    file = open_recording(path)
    reading = RecordedShow(file, cast)
    documents = CastDocuments(cast, meshes(cast), MASK)
    replay = ReplayServer(reading, reading.find_span(), documents, PAGES, [path])
    sent = [decode_answer(data) for data in show.states]
    async with TestClient(TestServer(replay.server.application(own_names()))) as client:
        yield Harness(replay, client, [state for state in sent if isinstance(state, State)])
    documents.close()
    reading.close()
    file.close()


async def next_state(link: Any) -> State:
    said = await answer(link)
    while not isinstance(said, State):
        said = await answer(link)
    return said


async def test_pages_see_the_recording_and_cannot_play_into_it(harness: Harness) -> None:
    link = await harness.client.ws_connect(LINK_PATH)
    await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
    assert isinstance(await answer(link), Welcome)
    await harness.ask(playing=False)
    await harness.replay.tick()
    first = await next_state(link)
    told = await harness.ask(position=1.0)
    await harness.replay.tick()
    shown = await next_state(link)
    assert shown.epoch > first.epoch
    same = [state for state in harness.states if state.time == shown.time]
    assert len(same) == 1
    numbers = {"epoch": 0, "number": 0, "revision": 0}
    assert msgspec.structs.replace(shown, **numbers) == msgspec.structs.replace(same[0], **numbers)
    assert not told["playing"]
    await link.send_bytes(encode(CallFace("one", "1", "broad", 1.0)))
    refused = await answer(link)
    assert isinstance(refused, Refused)
    assert "only looked at" in refused.reason


@pytest.mark.parametrize("wrong", [{"position": 99.0}, {"rate": 9.0}, {"loop": [0.0, 0.1]}, {"speed": 1.0}])
async def test_what_cannot_be_done_is_said(harness: Harness, wrong: dict[str, object]) -> None:
    before = await (await harness.client.get("/replay/transport")).json()
    response = await harness.client.post("/replay/transport", json=wrong)
    assert response.status == 400
    assert "Nothing has changed" in await response.text()
    assert await (await harness.client.get("/replay/transport")).json() == before


async def test_moments_are_told_in_their_order(harness: Harness) -> None:
    moments = await (await harness.client.get("/replay/moments")).json()
    marks = [moment for moment in moments if moment["what"] == "mark_moment"]
    assert [(mark["name"], mark["who"]) for mark in marks] == [("here", "ana")]
    assert moments == sorted(moments, key=lambda moment: moment["at"])
