"""Messages of a page with a microphone: what is none is rejected with a reason."""

import msgspec
import numpy as np
import pytest

from omote.inputs.microphone.microphone_messages import (
    LONGEST_SOUND,
    Begin,
    MicrophoneError,
    Sentence,
    Sound,
    Speak,
    read_message,
)
from omote.inputs.microphone.sound_features import BANDS


@pytest.mark.parametrize(
    "message",
    [Begin("Anna"), Begin("Anna", [-30.0] * BANDS, -34.0), Sentence("start"), Speak("two"), Sound(b"\0\0", 12.0)],
)
def test_messages_come_through(message: msgspec.Struct) -> None:
    assert read_message(msgspec.msgpack.encode(message)) == message


def test_a_speaker_comes_with_the_name() -> None:
    assert Begin("Anna").profile is None
    profile = Begin("Anna", [-30.0] * BANDS, -34.0).profile
    assert profile is not None
    assert profile.level == -34.0


@pytest.mark.parametrize("bands", [[-30.0], [float("nan")] * BANDS, [1e9] * BANDS])
def test_numbers_that_are_no_speaker_are_rejected(bands: list[float]) -> None:
    with pytest.raises(MicrophoneError, match="a speaker"):
        _ = Begin("Anna", bands).profile


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "nothing that a microphone says"),
        (b"hello", "nothing that a microphone says"),
        (msgspec.msgpack.encode({"type": "other"}), "nothing that a microphone says"),
        (msgspec.msgpack.encode(Begin("")), "nothing that a microphone says"),
        (msgspec.msgpack.encode(Sound(b"\0" * (LONGEST_SOUND + 2))), "nothing that a microphone says"),
        (msgspec.msgpack.encode(Sound(b"\0\0\0")), "3 bytes of sound"),
        (msgspec.msgpack.encode(Sound(b"\0\0", float("inf"))), "the clock of the sound"),
    ],
)
def test_what_is_no_message_is_rejected(data: bytes, said: str) -> None:
    with pytest.raises(MicrophoneError, match=said):
        read_message(data)


def test_damaged_messages_raise_nothing_else() -> None:
    random = np.random.default_rng(4)
    packet = msgspec.msgpack.encode(Sound(bytes(320), 7.0))
    for _ in range(3000):
        damaged = bytearray(packet[: int(random.integers(1, len(packet) + 1))])
        for place in random.integers(0, len(damaged), int(random.integers(1, 6))):
            damaged[place] = int(random.integers(256))
        try:
            read_message(bytes(damaged))
        except MicrophoneError:
            continue
