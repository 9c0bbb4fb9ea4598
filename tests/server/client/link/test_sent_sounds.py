"""A program's sounds: kept as a show keeps them, sent again where it has them no more."""

import asyncio

import pytest

from omote.inputs.sounds.sound_file import read_sound
from omote.server.client.link import sent_sounds
from omote.server.client.link.sent_sounds import SentSounds
from omote.show import messages as wire
from omote.show.session import ShowSession
from omote.show.speech.known_sounds import KnownSounds
from tests.inputs.sounds.test_sound_file import wav
from tests.server.client.link.test_program_link import linked
from tests.server.conftest import ShowHarness


def test_only_a_missing_sound_of_a_speech_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sent_sounds, "MOST_SOUNDS", 2)
    sounds = SentSounds()
    for key in ("a", "b", "a", "c"):
        sounds.keep(key, key.encode())
    with pytest.raises(ValueError, match="there is no sound") as rejected:
        KnownSounds().complete(wire.Say("one", "1", sound="a"))
    reason = str(rejected.value)
    assert sounds.find(["b", "c", "a", "c"]) == [b"c", b"a"]
    assert sounds.missing(wire.Say("one", "1", sound="a"), reason) == b"a"
    assert sounds.missing(wire.Say("one", "1", sound="b"), reason) is None
    assert sounds.missing(wire.Say("one", "1", sound="a"), "another") is None
    assert sounds.missing(wire.StopSpeaking("one", "1"), reason) is None


@pytest.mark.asyncio
async def test_a_show_that_has_lost_a_sound_gets_it_again(show_harness: ShowHarness) -> None:
    async with linked(show_harness) as link:
        key = await link.send_sound(wav(1.5))
        show_harness.show.session.sounds.set({})  # as a standby that takes over
        await link.send(wire.Say("one", link.next_id(), "Hello", sound=key))
        assert link.state is not None
        speech = link.state.characters["one"].speech
        assert speech is not None
        assert speech.sound == key
        with pytest.raises(ValueError, match="there is no sound 'other'"):
            await link.send(wire.Say("one", link.next_id(), "Hello", sound="other"))


@pytest.mark.asyncio
async def test_a_show_that_was_started_again_gets_the_sounds_of_what_is_said_and_waits(
    show_harness: ShowHarness,
) -> None:
    async with linked(show_harness) as link:
        for seconds in (500.0, 1.0, 2.0):
            name = link.next_id()
            await link.speak(wire.Say("one", name, "Hello", queue=True, key=name), wav(seconds, rate=100))
        session = show_harness.show.session
        session.sounds.set({})
        session.epoch += 1
        await show_harness.show.links.close_all()
        for key in [read_sound(wav(seconds, rate=100)).key for seconds in (500.0, 1.0, 2.0)]:
            while not knows(session, key):
                await asyncio.sleep(0)


def knows(session: ShowSession, key: str) -> bool:
    try:
        session.sounds.complete(wire.Say("one", "1", sound=key))
    except ValueError:
        return False
    return True
