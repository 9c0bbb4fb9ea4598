"""Sound to what a mouth can be read from: 24 bands of mel, level, and how voiced it is, every 10 ms.

Bands: triangles on the mel scale of O'Shaughnessy (1987), 80 Hz to 7.6 kHz, of a Hann window of 25 ms. Voicing: the
largest normalised autocorrelation at a lag of 2.5 to 12.5 ms, divided by the window's own (Boersma 1993).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats

SAMPLE_RATE = 16000
HOP = 160
WINDOW = 400
TRANSFORM = 512
FRAME_SECONDS = HOP / SAMPLE_RATE
BANDS = 24
LOWEST_HERTZ = 80.0
HIGHEST_HERTZ = 7600.0
LAGS = (40, 200)
"""Samples of the shortest and the longest period of a voice."""
QUIETEST = -100.0
"""dB of full scale below which sound counts as silence: the noise of 16 bits lies at -98."""


@dataclass(frozen=True)
class SoundFeatures:
    """Frames of sound. bands: (frames, 24) dB of full scale; level: (frames,) dB; voicing: (frames,) 0..1."""

    bands: Floats
    level: Floats
    voicing: Floats

    def __len__(self) -> int:
        return len(self.level)


class FeatureStream:
    """Features of a stream of samples, whatever the lengths of the pieces that it comes in."""

    def __init__(self) -> None:
        self._rest = np.zeros(WINDOW - HOP, np.float32)

    def push(self, samples: Floats) -> SoundFeatures:
        """The features of the frames that these samples complete. samples: -1..1, at 16 kHz."""
        sound = np.concatenate([self._rest, samples.astype(np.float32, copy=False)])
        count = max(0, (len(sound) - WINDOW) // HOP + 1)
        self._rest = sound[count * HOP :]
        if count == 0:
            return SoundFeatures(np.zeros((0, BANDS), np.float32), np.zeros(0, np.float32), np.zeros(0, np.float32))
        frames = np.lib.stride_tricks.sliding_window_view(sound, WINDOW)[: count * HOP : HOP]
        return _measure(frames * _HANN)


def read_pcm(data: bytes) -> Floats:
    """Samples of 16 bits, little-endian, as numbers from -1 to 1."""
    samples: Floats = np.frombuffer(data, "<i2").astype(np.float32) / np.float32(32768.0)
    return samples


def band_hertz() -> NDArray[np.float64]:
    """The middle of each band, Hz."""
    return _edges()[1:-1]


def _measure(frames: Floats) -> SoundFeatures:
    """The features of windowed frames."""
    power = np.abs(np.fft.rfft(frames, TRANSFORM)) ** 2
    level = np.sum(frames * frames, axis=1) / _HANN_POWER
    correlation = np.fft.irfft(power)[:, : LAGS[1] + 1]
    periodic = np.max(correlation[:, LAGS[0] :] / _HANN_CORRELATION[LAGS[0] :], axis=1)
    voicing = np.clip(periodic / np.maximum(correlation[:, 0], 1e-12), 0.0, 1.0)
    return SoundFeatures(_decibels(power @ _TRIANGLES), _decibels(level), voicing.astype(np.float32))


def _decibels(power: NDArray[np.floating]) -> Floats:
    bands: Floats = (10.0 * np.log10(np.maximum(power, 10.0 ** (QUIETEST / 10.0)))).astype(np.float32)
    return bands


def _triangles() -> Floats:
    """What each frequency adds to each band: mean power of the band, of a full-scale sine 0 dB in sum."""
    edges = _edges()
    hertz = np.fft.rfftfreq(TRANSFORM, 1.0 / SAMPLE_RATE)[:, None]
    rising = (hertz - edges[:-2]) / (edges[1:-1] - edges[:-2])
    falling = (edges[2:] - hertz) / (edges[2:] - edges[1:-1])
    bands: Floats = (np.maximum(0.0, np.minimum(rising, falling)) * 2.0 / (TRANSFORM * _HANN_POWER)).astype("f4")
    return bands


def _edges() -> NDArray[np.float64]:
    """Where the bands begin, culminate and end, Hz."""
    lowest, highest = (2595.0 * np.log10(1.0 + hertz / 700.0) for hertz in (LOWEST_HERTZ, HIGHEST_HERTZ))
    edges: NDArray[np.float64] = 700.0 * (10.0 ** (np.linspace(lowest, highest, BANDS + 2) / 2595.0) - 1.0)
    return edges


_HANN = np.hanning(WINDOW).astype(np.float32)
_HANN_POWER = float(np.sum(_HANN.astype(float) ** 2))
_HANN_CORRELATION = (np.correlate(_HANN, _HANN, "full")[WINDOW - 1 : WINDOW + LAGS[1]] / _HANN_POWER).astype(np.float32)
_TRIANGLES = _triangles()
