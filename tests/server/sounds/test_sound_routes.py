"""Sounds over HTTP: sent, fetched, rejected, forgotten."""

from __future__ import annotations

import pytest

from omote.server.sounds import sound_routes
from omote.show.objects.link import Refused
from omote.show.objects.speech import Say
from omote.show.objects.state import State
from omote.show.wire import encode
from tests.inputs.sounds.test_sound_file import wav
from tests.server.conftest import ShowHarness, answer, send_and_wait


@pytest.mark.asyncio
async def test_a_sound_is_kept_and_a_character_speaks_with_it(show_harness: ShowHarness) -> None:
    console = await show_harness.link()
    response = await show_harness.client.post("/sounds", data=wav(1.5))
    sent = await response.json()
    assert (response.status, sent["seconds"], sent["type"]) == (200, 1.5, "audio/wav")
    fetched = await show_harness.client.get(f"/sounds/{sent['sound']}")
    assert await fetched.read() == wav(1.5)
    assert fetched.content_type == "audio/wav"
    await send_and_wait(console, Say("one", "1", "Hello", sound=sent["sound"]))
    show_harness.tick()
    while not isinstance(state := await answer(console), State):
        pass
    speech = state.characters["one"].speech
    assert speech is not None
    assert (speech.text, speech.sound) == ("Hello", sent["sound"])
    assert speech.seconds == pytest.approx(1.5)


@pytest.mark.asyncio
async def test_rejects_what_is_no_sound_and_one_that_is_not_there(show_harness: ShowHarness) -> None:
    response = await show_harness.client.post("/sounds", data=b"<html>")
    assert response.status == 400
    assert "no WAV, MP3 or Ogg" in await response.text()
    assert (await show_harness.client.get("/sounds/none")).status == 404
    console = await show_harness.link()
    await console.send_bytes(sound_message("none"))
    refused = await answer(console)
    assert isinstance(refused, Refused)
    assert "send it to /sounds first" in refused.reason


@pytest.mark.asyncio
async def test_rejects_a_sound_that_is_too_large(show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.sounds.sound_routes.LARGEST_SOUND", 1000)
    monkeypatch.setattr("omote.inputs.sounds.sound_file.LARGEST_SOUND", 1000)
    response = await show_harness.client.post("/sounds", data=wav(1.5))
    assert response.status == 400
    assert "more than 1000 bytes" in await response.text()


@pytest.mark.asyncio
async def test_the_oldest_go_where_there_is_no_room(show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sound_routes, "MOST_SOUNDS", 2)
    keys = []
    for seconds in (0.5, 0.6, 0.5, 0.7):
        response = await show_harness.client.post("/sounds", data=wav(seconds))
        keys.append((await response.json())["sound"])
    found = [(await show_harness.client.get(f"/sounds/{key}")).status for key in keys]
    assert found == [200, 404, 200, 200]


def sound_message(key: str) -> bytes:
    """A speech with a sound."""

    return encode(Say("one", "2", sound=key))
