"""A sound of a program: its bytes, its file or its key, and its way to a show."""

from pathlib import Path
from typing import Any

import pytest

from omote.server.client.link.sound_upload import read_bytes, split_sound, upload_sound
from tests.inputs.sounds.test_sound_file import wav
from tests.server.conftest import ShowHarness

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
        ("a.wav", ValueError, r"sound is 'a.wav', which is no key .* give pathlib.Path\('a.wav'\)"),
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
