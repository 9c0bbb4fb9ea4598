"""What a program has a character say, as messages."""

import struct
from pathlib import Path
from typing import Any

import pytest

from omote.server.client.remote_speech import RemoteSpeech
from omote.show import messages as wire

KEY = "0123456789abcdef" * 2


class Sent(list[Any]):
    """What was sent, each message; a speech with the bytes of its sound."""

    def character(self) -> RemoteSpeech[None, None]:
        return RemoteSpeech("one", lambda: "id", self.append, lambda message, sound: self.append((message, sound)))


def test_times_go_as_single_floats_and_a_speech_is_named_by_its_message() -> None:
    sent = Sent()
    sent.character().say("Hi", timing="azure", marks=["21"], times=[0.5, 1.0], sound=KEY, queue=True)
    said = wire.Say("one", "id", "Hi", "azure", ["21"], struct.pack("<2f", 0.5, 1.0), sound=KEY, queue=True, key="id")
    assert sent == [(said, None)]


def test_a_sound_goes_along_as_bytes_or_as_the_path_of_its_file(tmp_path: Path) -> None:
    file = tmp_path / "hello.wav"
    file.write_bytes(b"RIFF")
    sent = Sent()
    for sound in (file, b"RIFF", bytearray(b"RIFF")):
        sent.character().say("Hi", sound=sound, key="greeting")  # type: ignore[arg-type]
    assert sent == [(wire.Say("one", "id", "Hi", key="greeting"), b"RIFF")] * 3


def test_gestures_and_stops_are_messages() -> None:
    sent = Sent()
    sent.character().gesture("tilt", amplitude=-1.0)
    sent.character().stop_speaking()
    assert sent == [wire.MakeGesture("one", "id", "tilt", -1.0), wire.StopSpeaking("one", "id")]


@pytest.mark.parametrize(
    ("error", "words", "wrong"),
    [
        (ValueError, "kind of timing", {"timing": "morse"}),
        (ValueError, "language", {"language": "fr"}),
        (TypeError, "queue", {"queue": "yes"}),
        (TypeError, r"marks is the text 'Hello you'; give a list, such as \['Hello', 'you'\]", {"marks": "Hello you"}),
        (TypeError, "a time \\(seconds\\) is '1'", {"times": ["1"]}),
        (ValueError, r"no key of send_sound; for a file give pathlib.Path\('hello.wav'\)", {"sound": "hello.wav"}),
        (TypeError, "the sound is a int; give the bytes of a file, or its Path", {"sound": 3}),
        (FileNotFoundError, "nosuch.wav", {"sound": Path("nosuch.wav")}),
    ],
)  # fmt: skip
def test_rejects_what_cannot_be_before_anything_is_sent(error: type[Exception], words: str, wrong: Any) -> None:
    sent = Sent()
    with pytest.raises(error, match=words):
        sent.character().say("a", **wrong)
    with pytest.raises(ValueError, match="gesture"):
        sent.character().gesture("dance")
    assert sent == []
