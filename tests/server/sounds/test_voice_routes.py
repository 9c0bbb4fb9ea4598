"""The voices of a show over HTTP: listed, speaking, refusing; a program that speaks by one."""

from __future__ import annotations

import asyncio
from pathlib import Path

import msgspec
import pytest

from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import encode_message
from omote.inputs.voices.spoken_text import SpokenAnswer, Voice, WantedSpeech
from omote.server.sounds import voice_routes
from omote.server.workers.file_jobs import run_file_job
from omote.server.workers.job_server import Follow, JobError
from omote.show.objects.speech import Say
from omote.show.objects.state import State
from tests.client.test_program_link import linked
from tests.server.conftest import ShowHarness


async def do_job(job: bytes, follow: Follow) -> bytes:
    """A job as a process beside the show does it."""
    try:
        return await asyncio.to_thread(run_file_job, job, follow)
    except ValueError as error:
        raise JobError(str(error)) from error


@pytest.fixture
def speaking(show_harness: ShowHarness) -> ShowHarness:
    """A show that has voices."""
    show_harness.show.enable_files(lambda: Path("my.omote"), do_job)
    return show_harness


@pytest.mark.asyncio
async def test_voices_are_listed_and_one_speaks(speaking: ShowHarness) -> None:
    voices = msgspec.json.decode(await (await speaking.client.get("/voices")).read(), type=list[Voice])
    assert Voice("de", "German") in voices
    response = await speaking.client.post("/voices", data=b'{"text": "Mama", "voice": "de"}')
    spoken = msgspec.json.decode(await response.read(), type=SpokenAnswer)
    assert spoken.marks == ["PP", "aa", "PP", "aa", "sil"]
    assert (await speaking.client.get(f"/sounds/{spoken.sound}")).content_type == "audio/wav"


@pytest.mark.asyncio
async def test_a_program_speaks_by_a_voice_of_the_show(speaking: ShowHarness) -> None:
    async with linked(speaking) as link:
        message = Say("one", link.next_id(), "Mama", key="first")
        await link.speak(message, WantedSpeech("Mama", "de"))
        assert link.state is not None
        speech = link.state.characters["one"].speech
        assert speech is not None
        assert (speech.text, speech.keys) == ("Mama", ["first"])
        assert 0.4 < speech.seconds < 0.6
        assert (await speaking.client.get(f"/sounds/{speech.sound}")).status == 200
        speaking.show.session.sounds.set({})  # as a standby that takes over: the program has the sound
        await link.send(Say("one", link.next_id(), "Mama", sound=speech.sound))
        with pytest.raises(ValueError, match="nothing was said: there is no voice 'dee' in this show; near are de"):
            await link.speak(message, WantedSpeech("Mama", "dee"))


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("body", "why"),
    [
        (b"Mama", "malformed"),
        (b'{"text": 3}', "Expected `str`"),
        (b'{"text": "Hi", "word": 1}', "unknown field `word`"),
        (b'{"text": "..."}', "nothing was said: this voice finds nothing to speak in this text"),
        (b'{"text": "Hi", "speed": 9}', "speed of a voice"),
    ],
)
async def test_what_cannot_be_spoken_is_answered_with_a_sentence(speaking: ShowHarness, body: bytes, why: str) -> None:
    response = await speaking.client.post("/voices", data=body)
    assert response.status == 400
    assert why in await response.text()


@pytest.mark.asyncio
async def test_a_voice_speaks_by_osc_and_what_it_cannot_is_said_there(speaking: ShowHarness) -> None:
    session = speaking.show.session
    osc = OscInput(lambda: session)
    assert osc.receive(("desk", 7), encode_message("/omote/one/say/voice", "Mama", "de"), 0.0) == []
    while (speech := session.tick(speaking.clock.now).characters["one"].speech) is None:
        speaking.tick()
        await asyncio.sleep(0.01)
    assert (speech.text, 0.4 < speech.seconds < 0.6) == ("Mama", True)
    assert (await speaking.client.get(f"/sounds/{speech.sound}")).status == 200
    osc.receive(("desk", 7), encode_message("/omote/one/say/voice", "Mama", "dee"), 0.0)
    speaking.show.sources.append(OscSource(osc))
    while osc.last_rejection is None:
        speaking.tick()
        await asyncio.sleep(0.01)
    assert osc.last_rejection.reason.startswith("nothing was said: there is no voice 'dee' in this show; near are de")


class OscSource:
    """Tells senders of OSC what is on air, as a show does."""

    def __init__(self, osc: OscInput) -> None:
        self._osc = osc

    def hear(self, now: float) -> None:
        """Hears nothing."""

    def tell(self, state: State, now: float) -> None:
        """Tells them."""
        self._osc.news(state, now)


@pytest.mark.asyncio
async def test_a_show_without_a_file_has_no_voice(show_harness: ShowHarness) -> None:
    assert await (await show_harness.client.get("/voices")).json() == []
    response = await show_harness.client.post("/voices", data=b'{"text": "Hi"}')
    assert (response.status, await response.text()) == (503, voice_routes.NO_FILE)


@pytest.mark.asyncio
async def test_too_many_texts_at_once_are_refused(show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(voice_routes, "MOST_TURNS", 2)
    go = asyncio.Event()

    async def wait(job: bytes, follow: Follow) -> bytes:
        await go.wait()
        return await do_job(job, follow)

    show_harness.show.enable_files(lambda: Path("my.omote"), wait)
    asked = [asyncio.create_task(show_harness.client.post("/voices", data=b'{"text": "Hi"}')) for _ in range(3)]
    done, _ = await asyncio.wait(asked, return_when=asyncio.FIRST_COMPLETED)
    (refused,) = done
    assert refused.result().status == 503
    go.set()
    assert sorted([answer.status for answer in await asyncio.gather(*asked)]) == [200, 200, 503]
