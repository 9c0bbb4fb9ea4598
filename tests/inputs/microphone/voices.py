"""Voices without a synthesizer: pulses through resonators, as vocal cords and a mouth."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from omote.inputs.microphone.sound_features import SAMPLE_RATE

Sound = NDArray[np.float32]
Formants = tuple[tuple[float, float], ...]
AA: Formants = ((750.0, 80.0), (1200.0, 90.0), (2500.0, 120.0), (3500.0, 200.0))
II: Formants = ((280.0, 60.0), (2250.0, 100.0), (2900.0, 150.0), (3500.0, 200.0))
UU: Formants = ((310.0, 60.0), (800.0, 80.0), (2300.0, 150.0), (3400.0, 200.0))
FADE = 0.02


def vowel(seconds: float, formants: Formants = AA, *, pitch: float = 120.0, rate: int = SAMPLE_RATE) -> Sound:
    """A vowel, its largest sample 0.5."""
    time = np.arange(int(seconds * rate)) / rate
    sound = np.diff(np.floor(time * pitch), prepend=0.0)
    for hertz, width in formants:
        pole = np.exp(-np.pi * width / rate)
        sound = lfilter([1.0], [1.0, -2.0 * pole * np.cos(2.0 * np.pi * hertz / rate), pole * pole], sound)
    edge = np.minimum(1.0, np.minimum(time, time[-1] - time) / FADE)
    return np.asarray(0.5 * edge * sound / np.abs(sound).max(), np.float32)


def pause(seconds: float, *, rate: int = SAMPLE_RATE) -> Sound:
    """Nobody speaks; a little noise, as of any microphone."""
    noise = np.random.default_rng(0).normal(0.0, 10.0 ** (-66.0 / 20.0), int(seconds * rate))
    return noise.astype(np.float32)


def pcm(sound: Sound) -> bytes:
    """Samples of 16 bits."""
    return np.asarray(np.clip(sound, -1.0, 1.0) * 32767.0, "<i2").tobytes()
