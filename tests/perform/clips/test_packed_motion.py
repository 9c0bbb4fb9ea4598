"""Packed motion comes back as float32, and what is damaged is refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.clips.packed_motion import pack_motion, rounded, unpack_motion
from tests.perform.clips.curves import curve


@given(seed=st.integers(0, 2**16), seconds=st.sampled_from([0.0, 0.5]))
def test_a_curve_comes_back_as_it_was_rounded(seed: int, seconds: float) -> None:
    exact = curve(seed, seconds=seconds)
    made = rounded(exact)
    assert np.abs(made.table - exact.table).max() <= 2.0**-25
    packed = pack_motion(made)
    again = unpack_motion(packed)
    assert again.layout is made.layout
    assert (again.times.tobytes(), again.table.tobytes()) == (made.times.tobytes(), made.table.tobytes())
    assert pack_motion(again) == packed


REJECTED: dict[str, dict[str, Any]] = {
    "has 0 frames": {"frames": 0},
    "frames of": {"frames": 2**30},
    "without a part": {"parts": (9,) * 15},
    "cannot be read": {"numbers": b"no deflated bytes"},
    "bytes; expected": {"frames": 3},
}


@pytest.mark.parametrize("reason", REJECTED)
def test_what_is_damaged_is_refused(reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        unpack_motion(replace(pack_motion(curve(1)), **REJECTED[reason]))
