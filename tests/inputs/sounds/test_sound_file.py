"""Sounds that programs send: WAV, MP3, Ogg, and all that is none."""

from __future__ import annotations

import io
import struct
import wave

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.sounds.sound_file import LARGEST_SOUND, read_sound


def wav(seconds: float, rate: int = 8000) -> bytes:
    made = io.BytesIO()
    with wave.open(made, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(rate)
        file.writeframes(bytes(2 * int(seconds * rate)))
    return made.getvalue()


def ogg(head: bytes, position: int) -> bytes:
    def page(at: int, body: bytes) -> bytes:
        return b"OggS" + struct.pack("<BBqIIIB", 0, 0, at, 1, 0, 0, 1) + bytes([len(body)]) + body

    return page(0, head) + page(position, b"x" * 20)


VORBIS = b"\x01vorbis" + struct.pack("<IBI", 0, 2, 44100) + bytes(20)
OPUS = b"OpusHead" + struct.pack("<BBHI", 1, 2, 312, 44100) + bytes(8)
MP3 = (b"\xff\xfb\x90\x00" + bytes(413)) * 40
"""Forty frames of MPEG 1, layer III, 128 kbit/s, 44.1 kHz."""


def test_a_wav_has_its_length_and_a_key_of_its_bytes() -> None:
    sound = read_sound(wav(1.5))
    assert (sound.type, sound.seconds) == ("audio/wav", 1.5)
    assert sound.key == read_sound(wav(1.5)).key != read_sound(wav(1.6)).key


def test_a_wav_that_was_streamed_has_the_length_of_what_came() -> None:
    data = bytearray(wav(1.0))
    at = data.index(b"data")
    data[at + 4 : at + 8] = b"\xff\xff\xff\xff"
    assert read_sound(bytes(data)).seconds == 1.0


@pytest.mark.parametrize("declared", [0xFFFFFFFF, 0x7FFFFFFF, 0x7FFFF000, 0x7FFFF024])
def test_who_streams_into_a_pipe_does_not_know_the_length(declared: int) -> None:
    data = bytearray(wav(1.0))
    at = data.index(b"data")
    struct.pack_into("<I", data, at + 4, declared)
    assert read_sound(bytes(data)).seconds == 1.0


def test_a_wav_that_is_cut_off_is_rejected_with_both_lengths() -> None:
    whole = wav(2.0)
    said = r"the WAV is cut off: it says that it has 32000 bytes of sound \(2 s\), and 8000 came \(0.5 s\)"
    with pytest.raises(ValueError, match=said):
        read_sound(whole[:-24000])
    assert read_sound(whole[:-2]).seconds == pytest.approx(2.0, abs=0.001)


def test_ogg_and_mp3_have_their_lengths() -> None:
    assert read_sound(ogg(VORBIS, 88200)) == read_sound(ogg(VORBIS, 88200))
    assert (read_sound(ogg(VORBIS, 88200)).type, read_sound(ogg(VORBIS, 88200)).seconds) == ("audio/ogg", 2.0)
    assert read_sound(ogg(OPUS, 96312)).seconds == 2.0
    tagged = b"ID3\x03\x00\x00" + bytes([0, 0, 0, 5]) + b"hello" + MP3
    for data in (MP3, tagged):
        assert read_sound(data).type == "audio/mpeg"
        assert read_sound(data).seconds == pytest.approx(40 * 1152 / 44100)


@pytest.mark.parametrize(
    ("data", "match"),
    [
        (b"", "no WAV, MP3 or Ogg"),
        (b"<html>", "no WAV, MP3 or Ogg"),
        (wav(0.0), "lasts 0 s"),
        (wav(601.0, 100), "lasts 601 s"),
        (wav(1.0)[:20], "no sound in it|cut off"),
        (b"RIFF\x00\x00\x00\x00WAVEdata\x04\x00\x00\x00\x00\x00\x00\x00", "no sound in it"),
        (ogg(b"fishead\x00", 100), "send Vorbis or Opus"),
        (ogg(VORBIS, -1), "does not say how long"),
        (ogg(VORBIS, 100)[:20], "cut off|Vorbis"),
        (bytes(LARGEST_SOUND + 1), "more than 16777216 bytes"),
    ],
)
def test_rejects_what_is_no_sound(data: bytes, match: str) -> None:
    with pytest.raises(ValueError, match=match):
        read_sound(data)


@given(st.sampled_from([wav(0.1), ogg(VORBIS, 4000), ogg(OPUS, 4000), MP3[:2000]]), st.data())
def test_damaged_bytes_are_a_sound_or_a_sentence(sound: bytes, data: st.DataObject) -> None:
    damaged = bytearray(sound)
    for _ in range(data.draw(st.integers(1, 6))):
        damaged[data.draw(st.integers(0, min(len(damaged) - 1, 120)))] = data.draw(st.integers(0, 255))
    cut = data.draw(st.integers(0, len(damaged)))
    try:
        found = read_sound(bytes(damaged[:cut]))
    except ValueError:
        return
    assert 0.0 < found.seconds <= 600.0
