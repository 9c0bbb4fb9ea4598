"""A program's sounds: kept as a show keeps them, sent again where it has them no more."""

import asyncio
from pathlib import Path
from typing import Any

import pytest

from omote.client.sounds import SentSounds, read_bytes, split_sound, upload_sound
from omote.inputs.sounds.sound_file import read_sound
from omote.show.objects.speech import Say, StopSpeaking
from omote.show.session import ShowSession
from omote.show.speech.known_sounds import KnownSounds
from tests.client.test_program_link import linked
from tests.inputs.sounds.test_sound_file import wav
from tests.server.conftest import ShowHarness


def test_only_a_missing_sound_of_a_speech_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.client.sounds.MOST_SOUNDS", 2)
    sounds = SentSounds()
    for key in ("a", "b", "a", "c"):
        sounds.keep(key, key.encode())
    with pytest.raises(ValueError, match="there is no sound") as rejected:
        KnownSounds().complete(Say("one", "1", sound="a"))
    reason = str(rejected.value)
    assert sounds.find(["b", "c", "a", "c"]) == [b"c", b"a"]
    assert sounds.missing(Say("one", "1", sound="a"), reason) == b"a"
    assert sounds.missing(Say("one", "1", sound="b"), reason) is None
    assert sounds.missing(Say("one", "1", sound="a"), "another") is None
    assert sounds.missing(StopSpeaking("one", "1"), reason) is None


@pytest.mark.asyncio
async def test_a_show_that_has_lost_a_sound_gets_it_again(show_harness: ShowHarness) -> None:
    async with linked(show_harness) as link:
        key = await link.send_sound(wav(1.5))
        show_harness.show.session.sounds.set({})  # as a standby that takes over
        await link.send(Say("one", link.next_id(), "Hello", sound=key))
        assert link.state is not None
        speech = link.state.characters["one"].speech
        assert speech is not None
        assert speech.sound == key
        with pytest.raises(ValueError, match="there is no sound 'other'"):
            await link.send(Say("one", link.next_id(), "Hello", sound="other"))


@pytest.mark.asyncio
async def test_a_show_that_was_started_again_gets_the_sounds_of_what_is_said_and_waits(
    show_harness: ShowHarness,
) -> None:
    async with linked(show_harness) as link:
        for seconds in (500.0, 1.0, 2.0):
            name = link.next_id()
            await link.speak(Say("one", name, "Hello", queue=True, key=name), wav(seconds, rate=100))
        session = show_harness.show.session
        session.sounds.set({})
        session.epoch += 1
        await show_harness.show.links.close_all()
        for key in [read_sound(wav(seconds, rate=100)).key for seconds in (500.0, 1.0, 2.0)]:
            while not knows(session, key):
                await asyncio.sleep(0)


def knows(session: ShowSession, key: str) -> bool:
    try:
        session.sounds.complete(Say("one", "1", sound=key))
    except ValueError:
        return False
    return True


KEY = "0123456789abcdef" * 2


def test_a_sound_is_bytes_or_a_file(tmp_path: Path) -> None:
    file = tmp_path / "a.wav"
    file.write_bytes(b"sound")
    for sound in (file, b"sound", bytearray(b"sound"), memoryview(b"sound")):
        assert read_bytes(sound) == b"sound"
        assert split_sound(sound) == ("", b"sound")
    assert (split_sound(KEY), split_sound(""), split_sound(None)) == ((KEY, None), ("", None), ("", None))


@pytest.mark.parametrize(
    ("sound", "error", "words"),
    [
        ("a.wav", ValueError, r"sound is 'a.wav', which is neither a key .* give pathlib.Path\('a.wav'\)"),
        (3, TypeError, "the sound is a int; give the bytes of a file, or its Path"),
        (Path("nosuch.wav"), FileNotFoundError, "nosuch.wav"),
    ],
)
def test_what_is_no_sound_is_said_with_what_to_give(sound: Any, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        split_sound(sound)
    with pytest.raises(TypeError, match=r"for a file give its Path, pathlib.Path\('a.wav'\)"):
        read_bytes("a.wav")


@pytest.mark.asyncio
async def test_a_show_gives_a_key_or_its_reason(show_harness: ShowHarness) -> None:
    show = str(show_harness.client.make_url("/"))[:-1]
    given: dict[str, Any] = {"headers": {}, "trusted": True, "timeout": 20.0}
    key = await upload_sound(show, wav(0.5), **given)
    assert split_sound(key) == (key, None)
    with pytest.raises(ValueError, match="the WAV is cut off: it says that it has 8000 bytes"):
        await upload_sound(show, wav(0.5)[:-4000], **given)
    with pytest.raises(ConnectionError, match=r"the show at http://127.0.0.1:1 took no sound"):
        await upload_sound("http://127.0.0.1:1", wav(0.5), **given)
