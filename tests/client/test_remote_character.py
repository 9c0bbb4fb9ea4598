"""A character as a program plays it: what is wrong is said before it is sent; others by their labels."""

import struct
from pathlib import Path
from typing import Any, cast

import pytest

from omote.client.remote_character import CharacterLink, RemoteCharacter
from omote.inputs.voices.spoken_text import WantedSpeech
from omote.model.cast import Cast
from omote.show.declaration import ClientMessage
from omote.show.objects.motion import MakeGesture
from omote.show.objects.sources import Drive, Source
from omote.show.objects.speech import Say, StopSpeaking
from omote.show.objects.state import State
from tests.client.test_remote_show import Wired


@pytest.mark.parametrize("seconds", [None, "2", True])
def test_only_infinite_seconds_wait_for_the_t_bar(cast: Cast, seconds: Any) -> None:
    one = Wired(cast).show["one"]
    for call in (one.call_face, one.call_expression):
        with pytest.raises(TypeError, match=f"seconds is {seconds!r}; give a number, or math.inf, which waits"):
            call("broad", seconds=seconds)


def test_another_character_is_looked_at_by_its_label(cast: Cast) -> None:
    show = Wired(cast).show
    show.add("two", label="Beta")
    show["one"].look_at("character", "beta")
    motion = show["one"].frame.motion
    assert motion is not None
    assert (motion.target.kind, motion.target.name) == ("character", "two")
    with pytest.raises(ValueError, match="there is no character 'gamma' in this scene"):
        show["one"].look_at("character", "gamma")


KEY = "0123456789abcdef" * 2


class Sent(list[Any]):
    """What was sent, each message; a speech with the bytes of its sound."""

    def character(self) -> RemoteCharacter[None, None]:
        return RemoteCharacter("one", cast(CharacterLink[None, None], self))

    def send(self, message: ClientMessage) -> None:
        self.append(message)

    def next_id(self) -> str:
        return "id"

    def speak(self, message: Say, sound: bytes | None) -> None:
        self.append((message, sound))

    def drive(self, source: Source, frame: Drive) -> None:
        self.append((source, frame))

    def find_character(self, name: str) -> str:
        return name

    @property
    def state(self) -> State:
        raise NotImplementedError


def test_times_go_as_single_floats_and_a_speech_is_named_by_its_message() -> None:
    sent = Sent()
    sent.character().say("Hi", timing="azure", marks=["21"], times=[0.5, 1.0], sound=KEY, queue=True)
    said = Say("one", "id", "Hi", "azure", ["21"], struct.pack("<2f", 0.5, 1.0), sound=KEY, queue=True, key="id")
    assert sent == [(said, None)]


def test_a_sound_goes_along_as_bytes_or_as_the_path_of_its_file(tmp_path: Path) -> None:
    file = tmp_path / "hello.wav"
    file.write_bytes(b"RIFF")
    sent = Sent()
    for sound in (file, b"RIFF", bytearray(b"RIFF")):
        sent.character().say("Hi", sound=sound, key="greeting")  # type: ignore[arg-type]
    assert sent == [(Say("one", "id", "Hi", key="greeting"), b"RIFF")] * 3


def test_a_voice_of_the_show_is_asked_for_the_text() -> None:
    sent = Sent()
    sent.character().say("Mama\n", voice="de+f2", queue=True)
    assert sent == [(Say("one", "id", "Mama\n", queue=True, key="id"), WantedSpeech("Mama", "de+f2"))]


def test_nothing_to_say_is_refused_with_and_without_a_voice() -> None:
    sent = Sent()
    for voice in ("", "de"):
        with pytest.raises(ValueError, match=r"there is no(thing to say| text to speak)"):
            sent.character().say("", voice=voice)
    with pytest.raises(ValueError, match="nothing to say; give a text, marks or a sound"):
        sent.character().say()
    assert sent == []


def test_gestures_and_stops_are_messages() -> None:
    sent = Sent()
    sent.character().gesture("tilt", amplitude=-1.0)
    sent.character().stop_speaking()
    assert sent == [MakeGesture("one", "id", "tilt", -1.0), StopSpeaking("one", "id")]


@pytest.mark.parametrize(
    ("error", "words", "wrong"),
    [
        (ValueError, "kind of timing", {"timing": "morse"}),
        (ValueError, "language", {"language": "fr"}),
        (TypeError, "queue", {"queue": "yes"}),
        (TypeError, r"marks is the text 'Hello you'; give a list, such as \['Hello', 'you'\]", {"marks": "Hello you"}),
        (TypeError, "a time \\(seconds\\) is '1'", {"times": ["1"]}),
        (ValueError, r"nor the name of a sound; for a file give pathlib.Path\('hello.wav'\)", {"sound": "hello.wav"}),
        (TypeError, "the sound is a int; give the bytes of a file, or its Path", {"sound": 3}),
        (FileNotFoundError, "nosuch.wav", {"sound": Path("nosuch.wav")}),
        (ValueError, "a voice came with marks or a sound", {"voice": "de", "sound": b"RIFF"}),
        (ValueError, "a voice came with marks or a sound", {"voice": "de", "marks": ["a"], "times": [0.0]}),
        (TypeError, "the voice is 3", {"voice": 3}),
    ],
)  # fmt: skip
def test_rejects_what_cannot_be_before_anything_is_sent(error: type[Exception], words: str, wrong: Any) -> None:
    sent = Sent()
    with pytest.raises(error, match=words):
        sent.character().say("a", **wrong)
    assert sent == []
