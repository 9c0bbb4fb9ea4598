"""Curves: every frame to the bit, and a cubic between frames."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.clips.motion_curve import make_curve
from tests.perform.clips.curves import PARTS, curve

seeds = st.integers(0, 2**16)
times = st.floats(0.0, 2.0)


def test_every_frame_is_itself_to_the_bit_and_what_is_near_it() -> None:
    made = curve(1)
    for place, time in enumerate(made.times):
        for near in (time, time + 5e-8, time - 5e-8):
            assert (made.values(near) == made.table[place]).all()
    assert (made.values(-1.0) == made.table[0]).all()
    assert (made.values(9.0) == made.table[-1]).all()


@given(seed=seeds, time=times)
def test_a_parabola_comes_back_between_unequal_frames_and_mixes_sum_to_one(seed: int, time: float) -> None:
    random = np.random.default_rng(seed)
    at = np.cumsum(random.uniform(0.01, 0.1, 80))
    whole = make_curve(at, {"jawOpen": 0.01 * (at - 2.0) ** 2}, PARTS)
    inner = at[1] + (at[-2] - at[1]) * time / 2.0
    values = dict(zip(whole.layout.columns, whole.values(inner), strict=True))
    assert values["channel/jawOpen"] == pytest.approx(0.01 * (inner - 2.0) ** 2, abs=1e-12)
    mixed = dict(zip(*(lambda c: (c.layout.columns, c.values(time)))(curve(seed)), strict=True))
    assert mixed["mouth/joy"] + mixed["mouth/neutral"] == pytest.approx(1.0, abs=1e-12)


@given(seed=seeds)
def test_speed_is_continuous_through_every_frame(seed: int) -> None:
    made = curve(seed, seconds=0.25)
    h = 1e-5
    for time in made.times[1:-1]:
        before = (made.values(time - 1e-6) - made.values(time - 1e-6 - h)) / h
        after = (made.values(time + 1e-6 + h) - made.values(time + 1e-6)) / h
        assert np.abs(after - before).max() < 0.5  # of slopes up to 64 a second; a line between frames bends by those


REJECTED: dict[str, Any] = {
    "times of a motion do not rise": lambda: make_curve([0.0, 0.0], {}, PARTS),
    "channel/jawOpen of a motion is 9": lambda: make_curve([0.0], {"jawOpen": [9.0]}, PARTS),
    "channel/jawOpen of a motion is no number": lambda: make_curve([0.0], {"jawOpen": [float("nan")]}, PARTS),
    "the length of a motion": lambda: make_curve([0.0, 4000.0], {}, PARTS),
    "expected a row for each time": lambda: make_curve([], {}, PARTS),
}


@pytest.mark.parametrize("reason", REJECTED)
def test_what_no_curve_can_be_is_rejected(reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        REJECTED[reason]()
