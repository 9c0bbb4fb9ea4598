"""Speech by espeak-ng with the time of each phone, through its library (`apt-get install espeak-ng`)."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

import numpy as np

from tools.lips.phones import shapes_of_ipa
from tools.lips.spoken import Segment, Spoken, claim_closures, resample

_LIBRARY = "libespeak-ng.so.1"
_SYNCHRONOUS = 2
_EVENTS_AND_IPA = 3
_PHONEME_EVENT = 7
_RATE = 1
_PITCH = 3
_RANGE = 4
"""Parameters of the library's espeak_SetParameter."""


class _Name(ctypes.Union):
    _fields_ = (("number", ctypes.c_int), ("name", ctypes.c_char_p), ("string", ctypes.c_char * 8))


class _Event(ctypes.Structure):
    _fields_ = (
        ("type", ctypes.c_int),
        ("identifier", ctypes.c_uint),
        ("text_position", ctypes.c_int),
        ("length", ctypes.c_int),
        ("audio_position", ctypes.c_int),
        ("sample", ctypes.c_int),
        ("user_data", ctypes.c_void_p),
        ("id", _Name),
    )


_CALLBACK = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_short), ctypes.c_int, ctypes.POINTER(_Event))


@dataclass(frozen=True)
class EspeakVoice:
    """A voice: language and variant ("de+f2"), words a minute (80..450), pitch and its range (0..99)."""

    name: str
    rate: int = 160
    pitch: int = 50
    pitch_range: int = 50


class Espeak:
    """The synthesizer, one a process."""

    def __init__(self) -> None:
        try:
            self._library = ctypes.CDLL(_LIBRARY)
        except OSError as error:
            raise OSError(f"{_LIBRARY} is not there: apt-get install espeak-ng") from error
        self._rate = self._library.espeak_Initialize(_SYNCHRONOUS, 200, None, _EVENTS_AND_IPA)
        self._sound: list[np.ndarray] = []
        self._events: list[tuple[int, str]] = []
        self._callback = _CALLBACK(self._take)
        self._library.espeak_SetSynthCallback(self._callback)

    def speak(self, voice: EspeakVoice, text: str) -> Spoken:
        """A text by a voice; ValueError where espeak-ng does not have it."""
        if self._library.espeak_SetVoiceByName(voice.name.encode()) != 0:
            raise ValueError(f"espeak-ng has no voice {voice.name}")
        for number, value in ((_RATE, voice.rate), (_PITCH, voice.pitch), (_RANGE, voice.pitch_range)):
            self._library.espeak_SetParameter(number, value, 0)
        self._sound = []
        self._events = []
        data = text.encode()
        self._library.espeak_Synth(data, len(data) + 1, 0, 1, 0, 1, None, None)
        sound = np.concatenate([*self._sound, np.zeros(0, np.int16)]).astype(np.float32) / 32768.0
        return self._cut(sound)

    def _take(self, samples: object, count: int, events: object) -> int:
        if count > 0 and samples:
            self._sound.append(np.ctypeslib.as_array(samples, (count,)).copy())
        index = 0
        while events[index].type != 0:  # type: ignore[index]
            event = events[index]  # type: ignore[index]
            if event.type == _PHONEME_EVENT:
                self._events.append((event.sample, event.id.string.decode(errors="ignore")))
            index += 1
        return 0

    def _cut(self, sound: np.ndarray) -> Spoken:
        starts = [start / self._rate for start, _ in self._events]
        ends = [*starts[1:], len(sound) / self._rate]
        segments = [
            Segment(start, end, name, shapes_of_ipa(name))
            for start, end, (_, name) in zip(starts, ends, self._events, strict=True)
            if end > start
        ]
        return Spoken(resample(sound, self._rate), tuple(claim_closures(segments, sound, self._rate)))
