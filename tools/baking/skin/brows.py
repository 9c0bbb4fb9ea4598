"""Eyebrows drawn hair by hair on the front of the generic head."""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats

HAIRS = 1300  # per brow
BUSHIEST = 1.7  # half heights from the middle line to the last hair
WIDTH = 0.00017  # metres, half the thickness of a drawn hair at its root
REACH = (0.0125, 0.0535)  # metres from the mirror plane to the first and to the last hair
# The middle line of the character's left brow on the generic head: x, y, half height (metres), from nose to temple.
LINE = np.array(
    [
        [0.0120, 0.0176, 0.0028],
        [0.0200, 0.0196, 0.0033],
        [0.0300, 0.0214, 0.0031],
        [0.0400, 0.0221, 0.0024],
        [0.0480, 0.0204, 0.0016],
        [0.0550, 0.0170, 0.0008],
    ]
)


def brow_cover(places: Floats, *, seed: int) -> Floats:
    """How much each place (n, 3) on the generic head is covered by eyebrow, 0 to 1.

    Hairs far from the middle line are fainter: a thinner brow is the part above a higher threshold.

    places (n, 3): metres; seed: of the hairs.
    """
    cover = np.zeros(len(places))
    across = np.abs(places[:, 0])
    near = (across > 0.008) & (across < 0.062) & (np.abs(places[:, 1] - 0.02) < 0.014) & (places[:, 2] > 0.06)
    flat = np.stack([across[near], places[near, 1]], axis=1)
    drawn = 0.36 * _body(flat)
    for root, tip, strength in _hairs(seed):
        drawn = np.maximum(drawn, strength * _stroke(flat, root, tip))  # not darker where they cross: gaps stay
    cover[near] = drawn
    return cover


def _body(flat: Floats) -> Floats:
    """The soft tint under the hairs (n,)."""
    middle, half = _line_at(flat[:, 0])
    inside = np.clip(1.25 - np.abs(flat[:, 1] - middle) / np.maximum(half, 1e-6), 0.0, 1.0)
    ends = np.clip((flat[:, 0] - 0.0115) / 0.006, 0.0, 1.0) * np.clip((0.056 - flat[:, 0]) / 0.008, 0.0, 1.0)
    return inside * ends


def _line_at(x: Floats) -> tuple[Floats, Floats]:
    return np.interp(x, LINE[:, 0], LINE[:, 1]), np.interp(x, LINE[:, 0], LINE[:, 2])


def _hairs(seed: int) -> list[tuple[Floats, Floats, float]]:
    """Roots, tips (2,) and strengths of one brow's hairs: upright near the nose, lying outwards towards the temple."""
    rng = np.random.default_rng(seed)
    along = np.sort(rng.uniform(0.0, 1.0, HAIRS))
    hairs = []
    for share in along:
        x = REACH[0] + share * (REACH[1] - REACH[0])
        middle, half = _line_at(np.array(x))
        height = rng.uniform(-1.0, 1.0) * BUSHIEST
        strength = 1.0 - 0.75 * min(1.0, max(0.0, abs(height) - 0.5) / (BUSHIEST - 0.5))
        root = np.array([x, float(middle) + float(half) * height])
        lean = np.deg2rad(70.0 - 62.0 * share**0.7 - 16.0 * height + rng.normal(0.0, 5.0))
        length = (0.0042 + 0.0016 * np.sin(np.pi * share)) * rng.uniform(0.7, 1.2)
        slope = np.interp(x + 0.004, LINE[:, 0], LINE[:, 1]) - np.interp(x, LINE[:, 0], LINE[:, 1])
        turn = lean * 0.46 + np.arctan2(slope, 0.004)
        hairs.append((root, root + length * np.array([np.cos(turn), np.sin(turn)]), strength * rng.uniform(0.6, 1.0)))
    return hairs


def _stroke(flat: Floats, root: Floats, tip: Floats) -> Floats:
    """Coverage (n,) of one hair that thins towards its tip."""
    span = tip - root
    share = np.clip((flat - root) @ span / (span @ span), 0.0, 1.0)
    off = np.linalg.norm(flat - root - share[:, None] * span, axis=1)
    soft = np.clip(1.0 - off / (2.0 * WIDTH * (1.15 - 0.7 * share)), 0.0, 1.0)
    return np.asarray(soft * (1.0 - 0.35 * share))
