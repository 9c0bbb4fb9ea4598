"""A replay behind a real socket: its states are those of the recording, under numbers of its own; nothing is played."""

from __future__ import annotations

import zlib
from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import pytest
import pytest_asyncio
from aiohttp.test_utils import TestClient, TestServer

from omote.inputs.sounds.sound_file import read_sound
from omote.model.cast import Cast
from omote.server.access.security import own_names
from omote.server.http.cast_documents import CastDocuments
from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_thread import RecordingThread
from omote.server.recording.replay_player import TransportRequest
from omote.server.recording.replay_server import ReplayServer, silenced
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Hello, Refused, Welcome
from omote.show.objects.speech import PlaySound
from omote.show.objects.state import State
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession
from omote.show.wire import decode_answer, encode
from omote.showfile.recording_file import open_recording, recording_path
from tests.inputs.sounds.test_sound_file import wav
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
    assert msgspec.structs.replace(shown, **numbers) == msgspec.structs.replace(silenced(same[0]), **numbers)
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


async def test_sounds_are_heard_while_it_plays_in_their_time(cast: Cast, tmp_path: Path) -> None:
    path = recording_path(tmp_path / "show.omote")
    sound = read_sound(wav(1.5))
    writer = RecordingThread(path, pytest.fail, "test", {sound.key: sound.data}.get)
    session = ShowSession(cast)
    session.set_sounds({sound.key: sound.seconds})
    notes = Recorder(session)
    session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
    for number in range(120):
        if number == 30:
            session.receive("a", PlaySound("one", "1", sound.key), number / 60)
        sent = session.tick(number / 60)
        writer.note(notes.take(zlib.crc32(encode(sent))))
    writer.close()
    file = open_recording(path)
    reading = RecordedShow(file, cast)
    documents = CastDocuments(cast, meshes(cast), MASK)
    replay = ReplayServer(reading, reading.find_span(), documents, PAGES, [path])
    async with TestClient(TestServer(replay.server.application(own_names()))) as client:
        fetched = await client.get(f"/sounds/{sound.key}")
        assert await fetched.read() == sound.data
        assert (await client.get("/sounds/none")).status == 404

    def heard(now: float) -> tuple[str, float]:
        state = replay.server.session.tick(now)
        speech = state.characters["one"].speech
        assert speech is not None
        return speech.sound, state.time - speech.elapsed

    replay.player.obey(TransportRequest(position=1.0))
    assert heard(0.0)[0] == "", "what was heard before the jump ends"
    key, began = heard(0.1)
    said = sent.characters["one"].speech
    assert said is not None
    assert key == sound.key
    assert began == pytest.approx(sent.time - said.elapsed)
    replay.player.obey(TransportRequest(rate=0.5))
    assert heard(0.2)[0] == ""
    replay.player.obey(TransportRequest(rate=1.0, playing=False))
    assert heard(0.3)[0] == ""
    replay.player.obey(TransportRequest(playing=True))
    assert heard(0.4)[0] == sound.key
    documents.close()
    reading.close()
    file.close()
