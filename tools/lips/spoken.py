"""Speech with the phones that are in it, and the viseme of every 10 ms."""

from __future__ import annotations

from dataclasses import dataclass
from math import gcd

import numpy as np
from scipy.signal import resample_poly

from omote.inputs.microphone.sound_features import HOP, SAMPLE_RATE, WINDOW
from omote.inputs.voices.phones import GLIDE, Segment, shapes_in_place
from omote.perform.speech.visemes import VISEMES

UNKNOWN = -1
"""The viseme of frames that nobody knows: they neither train nor count."""


@dataclass(frozen=True, eq=False)
class Spoken:
    """Sound (samples at 16 kHz, -1..1) and its phones in order."""

    sound: np.ndarray
    segments: tuple[Segment, ...]


def resample(sound: np.ndarray, rate: int) -> np.ndarray:
    """Sound at 16 kHz.

    sound: samples; rate: of them, Hz.
    """
    if rate == SAMPLE_RATE:
        return sound.astype(np.float32)
    step = gcd(rate, SAMPLE_RATE)
    made: np.ndarray = resample_poly(sound, SAMPLE_RATE // step, rate // step).astype(np.float32)
    return made


def label_frames(spoken: Spoken) -> np.ndarray:
    """The viseme of each frame of features, by the phone in the middle of its window; UNKNOWN where there is none."""
    count = max(0, (len(spoken.sound) + WINDOW - HOP - WINDOW) // HOP + 1)
    times = (np.arange(count) * HOP + HOP - WINDOW / 2) / SAMPLE_RATE
    labels = np.full(count, UNKNOWN)
    for segment, shapes in zip(spoken.segments, shapes_in_place(spoken.segments), strict=True):
        if not shapes:
            continue
        inside = (times >= segment.start) & (times < segment.end)
        late = times >= segment.start + GLIDE * (segment.end - segment.start)
        labels[inside] = VISEMES.index(shapes[0])
        labels[inside & late] = VISEMES.index(shapes[-1])
    labels[times < (spoken.segments[0].start if spoken.segments else 0.0)] = VISEMES.index("sil")
    return labels
