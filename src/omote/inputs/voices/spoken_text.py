"""What a synthetic voice makes of a text: its sound, and the visemes in it with their times, as `say` takes them."""

from __future__ import annotations

import re
import struct
import unicodedata

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.inputs.voices.phones import Segment, visemes_of
from omote.perform.limits import check_within
from omote.perform.speech.speech_timing import LONGEST_TEXT
from omote.show.objects.speech import USUAL_VOICE

SLOWEST = 0.5
FASTEST = 2.0
"""How fast a voice may speak, as a share of its own speed."""
VOICES_PATH = "/voices"
"""Where the voices of a show are read (GET), and where one speaks (POST), over HTTP."""
HOW_TO_GET_A_VOICE = "install one where the show runs: pip install 'omote[voice]'"
NO_VOICE = f"this show has no voice; {HOW_TO_GET_A_VOICE}"
FULL_SCALE = 32768.0
"""What samples of 16 bits are shares of."""
_LONG_RUN = re.compile(r"[^\s。、,.!?;:]{40}(?=\S)")
"""So many letters without a space: eSpeak NG leaves out what a word of more than some 60 has beyond them, as a sentence
in Japanese or Thai is, so that it is parted."""


class Voice(msgspec.Struct, frozen=True):
    """A voice: what to call it, and its language for people."""

    name: str
    label: str


class WantedSpeech(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a voice is asked to say. text: to 2000 characters; voice: its name, `de`, with a variant `de+f2`; speed: as
    a share of the voice's own, 0.5 to 2."""

    text: str
    voice: str = USUAL_VOICE
    speed: float = 1.0


class SpokenText(msgspec.Struct, frozen=True):
    """A text that was spoken. sound: a WAV; seconds: its length; marks: visemes, each beginning at its place of
    `times` (seconds; one more is the end of the last)."""

    sound: bytes
    seconds: float
    marks: list[str]
    times: list[float]


class SpokenAnswer(msgspec.Struct, frozen=True):
    """What a show answers where a voice has spoken: the key of the sound that it keeps, its length, its visemes."""

    sound: str
    seconds: float
    marks: list[str]
    times: list[float]


def check_wanted(wanted: WantedSpeech) -> WantedSpeech:
    """The same with a text that a voice can read; ValueError with a sentence for one that is empty, too long or too
    fast."""
    if not isinstance(wanted.text, str):
        raise TypeError(f"the text is {wanted.text!r:.80}; give what is said, as text")
    check_within(wanted.speed, SLOWEST, FASTEST, "the speed of a voice")
    if len(wanted.text) > LONGEST_TEXT:
        raise ValueError(f"the text has {len(wanted.text)} characters; say at most {LONGEST_TEXT} at once")
    text = "".join(" " if unicodedata.category(letter) in ("Cc", "Cs") else letter for letter in wanted.text).strip()
    if not text:
        raise ValueError("there is no text to speak; give words")
    return WantedSpeech(_LONG_RUN.sub(r"\g<0> ", text), wanted.voice, wanted.speed)


def put_together(sound: NDArray[np.int16], rate: int, segments: list[Segment], *, most: int) -> SpokenText:
    """What was spoken; ValueError where nothing is heard in it, or more than `most` visemes.

    sound: samples; rate: of them, Hz; segments: phones in time.
    """
    seconds = len(sound) / rate
    marks, times = visemes_of(segments, seconds)
    if set(marks) <= {"sil"}:
        raise ValueError("this voice finds nothing to speak in this text; give words of its language")
    if len(marks) > most:
        raise ValueError(f"the text has {len(marks)} sounds, at most {most} at once; say it in parts, with queue")
    return SpokenText(encode_wav(sound, rate), seconds, marks, times)


def encode_wav(sound: NDArray[np.int16], rate: int) -> bytes:
    """A WAV of one channel. sound: samples; rate: of them, Hz."""
    data = sound.astype("<i2").tobytes()
    form = struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, 1, rate, 2 * rate, 2, 16)
    body = form + struct.pack("<4sI", b"data", len(data)) + data
    return struct.pack("<4sI4s", b"RIFF", 4 + len(body), b"WAVE") + body
