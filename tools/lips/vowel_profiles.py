"""The way of uLipSync 3.1 as a baseline: the distance of MFCC to profiles of a speaker's vowels (protocols.md, 7.1)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.fft import dct

from omote.inputs.microphone.sound_features import HOP, SAMPLE_RATE
from omote.perform.speech.visemes import SIL, VISEMES
from tools.lips.spoken import Spoken, label_frames

WINDOW = 1024
BANDS = 30
COEFFICIENTS = 12
PRE_EMPHASIS = 0.97
PHONES = ("aa", "I", "U", "E", "O", "nn")
CALIBRATION_FRAMES = 16
QUIETEST = 2.5
"""The logarithm (base 10) of the ratio of volumes, from the loudest, at which the mouth is shut."""


@dataclass(frozen=True, eq=False)
class VowelProfiles:
    """The mean coefficients of a speaker's phones, and the largest volume."""

    means: np.ndarray
    volume: float


def measure_profiles(spoken: Spoken, sound: np.ndarray) -> VowelProfiles:
    """Calibrated as well as can be: on frames from the middle of the phones whose times are known.

    spoken: speech and its phones; sound: its samples.
    """
    coefficients, volumes = mel_coefficients(sound)
    labels = label_frames(spoken)[: len(coefficients)]
    means = []
    for phone in PHONES:
        places = np.flatnonzero(labels == VISEMES.index(phone))
        steady = places[(places > 1) & (places < len(labels) - 2)]
        steady = steady[(labels[steady - 2] == labels[steady]) & (labels[steady + 2] == labels[steady])]
        chosen = (steady if len(steady) else places)[:CALIBRATION_FRAMES]
        means.append(np.mean(coefficients[chosen], axis=0) if len(chosen) else np.full(COEFFICIENTS, 1e3))
    return VowelProfiles(np.stack(means), float(np.max(volumes)))


def read_visemes(profiles: VowelProfiles, sound: np.ndarray) -> np.ndarray:
    """The weights of the 15 visemes of each frame of 10 ms; silence by volume.

    profiles: of the vowels; sound: samples.
    """
    coefficients, volumes = mel_coefficients(sound)
    distance = np.sqrt(np.mean((coefficients[:, None] - profiles.means) ** 2, axis=2))
    scores = 10.0 ** (-np.minimum(distance, 300.0))
    shares = scores / np.maximum(np.sum(scores, axis=1, keepdims=True), 1e-300)
    opened = np.clip(1.0 + np.log10(np.maximum(volumes / profiles.volume, 1e-9)) / QUIETEST, 0.0, 1.0)
    weights = np.zeros((len(sound_frames(sound)), len(VISEMES)))
    for place, phone in enumerate(PHONES):
        weights[:, VISEMES.index(phone)] = opened * shares[:, place]
    weights[:, SIL] = 1.0 - opened
    return weights


def sound_frames(sound: np.ndarray) -> np.ndarray:
    """Windows of 64 ms that end every 10 ms."""
    padded = np.concatenate([np.zeros(WINDOW - HOP, np.float32), sound])
    return np.lib.stride_tricks.sliding_window_view(padded, WINDOW)[::HOP]


def mel_coefficients(sound: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Twelve coefficients of each frame, and its volume (root mean square)."""
    frames = sound_frames(sound)
    volumes = np.sqrt(np.mean(frames.astype(float) ** 2, axis=1))
    emphasized = np.concatenate([frames[:, :1], frames[:, 1:] - PRE_EMPHASIS * frames[:, :-1]], axis=1)
    windowed = emphasized * np.hamming(WINDOW)
    windowed = windowed / np.maximum(np.max(np.abs(windowed), axis=1, keepdims=True), 1e-9)
    spectrum = np.abs(np.fft.rfft(windowed))
    decibels = 10.0 * np.log10(np.maximum(spectrum @ _mel_bands(), 1e-10))
    return dct(decibels, axis=1)[:, 1 : COEFFICIENTS + 1] / BANDS, volumes


def _mel_bands() -> np.ndarray:
    highest = 2595.0 * np.log10(1.0 + SAMPLE_RATE / 2 / 700.0)
    edges = 700.0 * (10.0 ** (np.linspace(0.0, highest, BANDS + 2) / 2595.0) - 1.0)
    hertz = np.fft.rfftfreq(WINDOW, 1.0 / SAMPLE_RATE)[:, None]
    rising = (hertz - edges[:-2]) / (edges[1:-1] - edges[:-2])
    falling = (edges[2:] - hertz) / (edges[2:] - edges[1:-1])
    return np.maximum(0.0, np.minimum(rising, falling))
