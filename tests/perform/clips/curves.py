"""Curves and samples that tests of clips begin from."""

from __future__ import annotations

from typing import Any

import numpy as np

from omote.perform.clips.motion_curve import MotionCurve, make_curve
from omote.perform.clips.sample import Sample

PARTS = {"browInnerUp": 0, "eyeBlinkLeft": 1, "jawOpen": 2}
STEP = 1.0 / 64.0
"""A binary fraction, so that sums of times are exact."""


def curve(seed: int, *, seconds: float = 2.0, **changes: Any) -> MotionCurve:
    """Noise in every column."""
    random = np.random.default_rng(seed)
    count = round(seconds / STEP) + 1
    joy = random.uniform(0.0, 1.0, count)
    given: dict[str, Any] = {
        "mixes": {"mouth": {"joy": joy, "neutral": 1.0 - joy}},
        "head": random.uniform(-0.3, 0.3, (count, 3)),
        "gaze": random.uniform(-0.3, 0.3, (count, 2)),
    }
    channels = {name: random.uniform(0.0, 1.0, count) for name in (*PARTS, "whole")}
    return make_curve([place * STEP for place in range(count)], channels, PARTS, **{**given, **changes})


def same(one: Sample, other: Sample) -> bool:
    """Whether two samples are the same to the bit, wherever anything of them shows."""
    shown = one.shares[one.layout.places] > 0.0
    values = dict(zip(np.array(one.layout.columns)[shown], one.values[shown], strict=True))
    others = dict(zip(other.layout.columns, other.values, strict=True))
    return bool((one.shares == other.shares).all()) and all(others[name] == value for name, value in values.items())
