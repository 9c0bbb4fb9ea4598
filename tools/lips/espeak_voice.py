"""Speech by espeak-ng with the time of each phone, through its library (`apt-get install espeak-ng`)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.inputs.voices.phones import claim_closures
from omote.server.sandbox.espeak_ng import Espeak as Library
from omote.server.sandbox.voices import segments_of
from tools.lips.spoken import Spoken, resample

_LIBRARY = "libespeak-ng.so.1"


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
            self._library = Library(_LIBRARY)
        except OSError as error:
            raise OSError(f"{_LIBRARY} is not there: apt-get install espeak-ng") from error

    def speak(self, voice: EspeakVoice, text: str) -> Spoken:
        """A text by a voice; ValueError where espeak-ng does not have it."""
        sounded = self._library.speak(
            voice.name, text, rate=voice.rate, pitch=voice.pitch, pitch_range=voice.pitch_range
        )
        sound = sounded.sound.astype(np.float32) / 32768.0
        return Spoken(resample(sound, sounded.rate), tuple(claim_closures(segments_of(sounded), sound, sounded.rate)))
