"""The library of eSpeak NG: a text as sound, with the sample at which each phone begins.

It is another program's (GPL-3), installed by whoever wants a voice; only a child process that ends with its task loads
it.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_SYNCHRONOUS = 2
_PIECE = 200
"""Milliseconds of sound that the library gives at once."""
_EVENTS_AND_IPA = 3
_PHONEME = 7
_UTF8 = 1
_CHARACTERS = 1
_RATE = 1
_PITCH = 3
_RANGE = 4
"""Parameters of the library's espeak_SetParameter."""
USUAL_RATE = 160
"""Words a minute."""
LONGEST = 600.0
"""Seconds after which it is stopped."""


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


class _Voice(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("languages", ctypes.c_char_p),
        ("identifier", ctypes.c_char_p),
        ("gender", ctypes.c_ubyte),
        ("age", ctypes.c_ubyte),
        ("variant", ctypes.c_ubyte),
        ("unused", ctypes.c_ubyte),
        ("score", ctypes.c_int),
        ("spare", ctypes.c_void_p),
    )


_CALLBACK = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_short), ctypes.c_int, ctypes.POINTER(_Event))


class LibraryVoice(NamedTuple):
    """A voice of the library: its language (`en-gb`), its name for people, and the file that it is loaded by."""

    language: str
    label: str
    identifier: str


class Sounded(NamedTuple):
    """A text as sound: samples, their rate (Hz), and the sample and the name in IPA of each phone ("" for a pause)."""

    sound: NDArray[np.int16]
    rate: int
    phones: list[tuple[int, str]]


class Espeak:
    """The synthesizer, one a process. library: its file; data: the folder that holds its data, None for the system's.
    OSError where it cannot be loaded."""

    def __init__(self, library: str, data: str | None = None) -> None:
        self._library = ctypes.CDLL(library)
        self._library.espeak_ListVoices.restype = ctypes.POINTER(ctypes.POINTER(_Voice))
        folder = None if data is None else data.encode()
        self._rate = self._library.espeak_Initialize(_SYNCHRONOUS, _PIECE, folder, _EVENTS_AND_IPA)
        if self._rate <= 0:
            raise OSError("eSpeak NG does not find its data; install omote[voice] again")
        self._sound: list[NDArray[np.int16]] = []
        self._phones: list[tuple[int, str]] = []
        self._length = 0
        self._callback = _CALLBACK(self._take)
        self._library.espeak_SetSynthCallback(self._callback)

    def voices(self) -> Iterator[LibraryVoice]:
        """All voices, one for each language."""
        listed = self._library.espeak_ListVoices(None)
        place = 0
        while listed[place]:
            voice = listed[place].contents
            language = voice.languages[1:].decode()  # a byte before it is its rank
            yield LibraryVoice(language, voice.name.decode().strip(), voice.identifier.decode())
            place += 1

    def speak(
        self, voice: str, text: str, *, rate: int = USUAL_RATE, pitch: int = 50, pitch_range: int = 50
    ) -> Sounded:
        """A text by a voice, which is stopped after 600 s; ValueError where the library does not have it.

        voice: its file and variant ("de+f2"); rate: words a minute (80..450); pitch, pitch_range: 0..99.
        """
        if self._library.espeak_SetVoiceByName(voice.encode()) != 0:
            raise ValueError(f"espeak-ng has no voice {voice}")
        for number, value in ((_RATE, rate), (_PITCH, pitch), (_RANGE, pitch_range)):
            self._library.espeak_SetParameter(number, value, 0)
        self._sound = []
        self._phones = []
        self._length = 0
        data = text.encode()
        self._library.espeak_Synth(data, len(data) + 1, 0, _CHARACTERS, 0, _UTF8, None, None)
        return Sounded(np.concatenate([*self._sound, np.zeros(0, np.int16)]), self._rate, self._phones)

    def _take(self, samples: object, count: int, events: object) -> int:
        if count > 0 and samples:
            self._sound.append(np.ctypeslib.as_array(samples, (count,)).copy())
            self._length += count
        place = 0
        while events[place].type != 0:  # type: ignore[index]
            event = events[place]  # type: ignore[index]
            if event.type == _PHONEME:
                self._phones.append((event.sample, event.id.string.decode(errors="ignore")))
            place += 1
        return int(self._length > LONGEST * self._rate)
