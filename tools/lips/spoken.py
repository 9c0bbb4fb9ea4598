"""Speech with the phones that are in it, and the viseme of every 10 ms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import gcd

import numpy as np
from scipy.signal import resample_poly

from omote.inputs.microphone.sound_features import HOP, SAMPLE_RATE, WINDOW
from omote.perform.speech.visemes import VISEMES
from tools.lips.phones import Shapes

UNKNOWN = -1
"""The viseme of frames that nobody knows: they neither train nor count."""
_STOPS = ("PP", "DD", "kk", "CH")
_LONGEST_CLOSURE = 0.13
_SILENT = 10.0 ** (-55 / 20)
_STEP = 0.005
_GLIDE = 0.55
"""Where in a diphthong the second vowel begins."""


@dataclass(frozen=True)
class Segment:
    """A phone from `start` to `end` (seconds). shapes: its visemes, () of a neighbour's shape, None unknown."""

    start: float
    end: float
    name: str
    shapes: Shapes | None


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


def claim_closures(segments: Sequence[Segment], sound: np.ndarray, rate: int) -> list[Segment]:
    """Gives each stop the silence before its burst: espeak-ng marks a stop at the burst, and what is silent before it
    is the closure, in which lips or tongue are shut already.

    segments: phones and their times; sound: samples; rate: Hz.
    """
    claimed = list(segments)
    for index in range(1, len(claimed)):
        before = claimed[index - 1]
        stop = claimed[index]
        if not stop.shapes or stop.shapes[0] not in _STOPS or before.shapes == ("sil",):
            continue
        start = _silence_start(sound, rate, before)
        if start < before.end - _STEP:
            claimed[index - 1], claimed[index] = replace(before, end=start), replace(stop, start=start)
    return claimed


def _silence_start(sound: np.ndarray, rate: int, segment: Segment) -> float:
    """Where the silence at the end of a segment begins, seconds; its end where there is none."""
    start = segment.end
    while start - _STEP > max(segment.start, segment.end - _LONGEST_CLOSURE):
        piece = sound[round((start - _STEP) * rate) : round(start * rate)]
        if np.sqrt(np.mean(piece**2)) > _SILENT:
            break
        start -= _STEP
    return start


def label_frames(spoken: Spoken) -> np.ndarray:
    """The viseme of each frame of features, by the phone in the middle of its window; UNKNOWN where there is none."""
    count = max(0, (len(spoken.sound) + WINDOW - HOP - WINDOW) // HOP + 1)
    times = (np.arange(count) * HOP + HOP - WINDOW / 2) / SAMPLE_RATE
    labels = np.full(count, UNKNOWN)
    for segment, shapes in zip(spoken.segments, _shapes_in_place(spoken.segments), strict=True):
        if not shapes:
            continue
        inside = (times >= segment.start) & (times < segment.end)
        late = times >= segment.start + _GLIDE * (segment.end - segment.start)
        labels[inside] = VISEMES.index(shapes[0])
        labels[inside & late] = VISEMES.index(shapes[-1])
    labels[times < (spoken.segments[0].start if spoken.segments else 0.0)] = VISEMES.index("sil")
    return labels


def _shapes_in_place(segments: Sequence[Segment]) -> list[Shapes | None]:
    """The visemes of each segment; one without a shape of its own (h) has that of the next."""
    shapes: list[Shapes | None] = []
    after: Shapes | None = None
    for segment in reversed(segments):
        shapes.append(after[:1] if segment.shapes == () and after and after != ("sil",) else segment.shapes)
        after = segment.shapes
    return shapes[::-1]
