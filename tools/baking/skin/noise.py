"""Seeded noise in space: it knows nothing of texture coordinates, so it has no seams.

Value noise after K. Perlin ("An Image Synthesizer", 1985), cells after S. Worley ("A Cellular Texture Basis Function",
1996), strands as line integrals after B. Cabral and L. Leedom ("Imaging Vector Fields Using Line Integral
Convolution", 1993).
"""

from __future__ import annotations

import numpy as np
from numba import njit

from tools.baking.heads.basemesh import Floats


@njit(cache=True)
def _dice(i: int, j: int, k: int, seed: int) -> float:
    """A number in [0, 1) for a place on the lattice."""
    mixed = (i * 73856093) ^ (j * 19349663) ^ (k * 83492791) ^ (seed * 2654435761)
    mixed &= 0xFFFFFFFF
    for factor in (0x7FEB352D, 0x846CA68B):
        mixed = ((mixed ^ (mixed >> 16)) * factor) & 0xFFFFFFFF
    return float((mixed ^ (mixed >> 15)) & 0xFFFFFF) / 16777216.0


@njit(cache=True)
def _value(x: float, y: float, z: float, seed: int) -> float:
    """Noise in [0, 1] at a place, smooth over lattice cells of size one."""
    i, j, k = int(np.floor(x)), int(np.floor(y)), int(np.floor(z))
    u, v, w = x - i, y - j, z - k
    u, v, w = u * u * (3.0 - 2.0 * u), v * v * (3.0 - 2.0 * v), w * w * (3.0 - 2.0 * w)
    total = 0.0
    for a in range(2):
        for b in range(2):
            for c in range(2):
                share = (u if a else 1.0 - u) * (v if b else 1.0 - v) * (w if c else 1.0 - w)
                total += share * _dice(i + a, j + b, k + c, seed)
    return total


@njit(cache=True)
def _values(places: Floats, seed: int) -> Floats:
    out = np.empty(len(places))
    for n in range(len(places)):
        out[n] = _value(places[n, 0], places[n, 1], places[n, 2], seed)
    return out


@njit(cache=True)
def _cells(places: Floats, seed: int) -> Floats:
    """Distance to the nearest and the second point of a jittered lattice, and a number in [0, 1) of the nearest."""
    out = np.empty((len(places), 3))
    for n in range(len(places)):
        x, y, z = places[n]
        i, j, k = int(np.floor(x)), int(np.floor(y)), int(np.floor(z))
        first = 9.0
        second = 9.0
        label = 0.0
        for a in range(i - 1, i + 2):
            for b in range(j - 1, j + 2):
                for c in range(k - 1, k + 2):
                    dx = a + _dice(a, b, c, seed) - x
                    dy = b + _dice(a, b, c, seed + 1) - y
                    dz = c + _dice(a, b, c, seed + 2) - z
                    far = dx * dx + dy * dy + dz * dz
                    if far < first:
                        first, second, label = far, first, _dice(a, b, c, seed + 3)
                    elif far < second:
                        second = far
        out[n, 0], out[n, 1], out[n, 2] = np.sqrt(first), np.sqrt(second), label
    return out


@njit(cache=True)
def _strands(places: Floats, flow: Floats, taps: int, seed: int) -> Floats:
    out = np.empty(len(places))
    for n in range(len(places)):
        total = 0.0
        for tap in range(taps):
            at = (tap + 0.5) / taps - 0.5
            total += _value(
                places[n, 0] + at * flow[n, 0], places[n, 1] + at * flow[n, 1], places[n, 2] + at * flow[n, 2], seed
            )
        out[n] = total / taps
    return out


def value_noise(places: Floats, size: float, *, seed: int) -> Floats:
    """Smooth noise (n,) in [0, 1] at places (n, 3), its blobs about `size` across.

    size: metres; seed: which noise.
    """
    return np.asarray(_values(np.ascontiguousarray(places / size), seed))


def cloud_noise(places: Floats, size: float, *, seed: int, octaves: int = 3) -> Floats:
    """Noise (n,) in [0, 1] of several sizes, each half the one before and half as strong.

    places (n, 3): metres; size: of the largest blobs, metres; seed: which noise; octaves: how many sizes.
    """
    parts = [value_noise(places, size / 2**octave, seed=seed + octave) * 0.5**octave for octave in range(octaves)]
    return np.asarray(sum(parts) / (2.0 - 0.5 ** (octaves - 1)))


def cell_noise(places: Floats, size: float, *, seed: int) -> tuple[Floats, Floats, Floats]:
    """Distances (n,) to the nearest and to the second of points scattered `size` apart, in units of `size`, and a
    number (n,) in [0, 1) that is the nearest point's own.

    places (n, 3): metres; seed: which points.
    """
    found = _cells(np.ascontiguousarray(places / size), seed)
    return found[:, 0], found[:, 1], found[:, 2]


def strand_noise(places: Floats, flow: Floats, width: float, *, seed: int) -> Floats:
    """Noise (n,) around 0.5 that is drawn out along `flow` (n, 3; its length is the strand's) and `width` across.

    places (n, 3), width: metres; seed: which noise.
    """
    taps = max(2, round(float(np.linalg.norm(flow, axis=1).max()) / width))
    found = _strands(np.ascontiguousarray(places / width), np.ascontiguousarray(flow / width), taps, seed)
    return np.asarray(np.clip(0.5 + (found - 0.5) * 0.8 * np.sqrt(taps), 0.0, 1.0))
