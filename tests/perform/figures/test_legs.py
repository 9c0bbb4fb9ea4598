"""Legs reach their feet, and knees point where they are told."""

from __future__ import annotations

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from omote.perform.figures.legs import STRAIGHTEST, reach_foot

HIP = np.array([0.1, 0.0, 0.0])
KNEE = np.array([0.1, -0.45, 0.02])
ANKLE = np.array([0.1, -0.86, 0.0])
THIGH = float(np.linalg.norm(KNEE - HIP))
SHIN = float(np.linalg.norm(ANKLE - KNEE))


@given(st.tuples(st.floats(-0.6, 0.6), st.floats(-1.2, -0.1), st.floats(-0.6, 0.6)), st.floats(-1.0, 1.0))
def test_an_ankle_comes_to_its_target_or_as_near_as_the_leg_is_long(
    at: tuple[float, float, float], aside: float
) -> None:
    target = HIP + np.array(at)
    ahead = np.array([np.sin(aside), 0.0, np.cos(aside)])
    thigh, shin, ankle = reach_foot(HIP, KNEE, ANKLE, target, ahead)
    knee = HIP + thigh @ (KNEE - HIP)
    np.testing.assert_allclose(knee + shin @ (ANKLE - KNEE), ankle, atol=1e-9)
    way = np.linalg.norm(target - HIP)
    reach = STRAIGHTEST * (THIGH + SHIN)
    nearest = abs(THIGH - SHIN) + 1e-4
    np.testing.assert_allclose(ankle, HIP + (target - HIP) / way * np.clip(way, nearest, reach), atol=1e-9)
    bent = knee - HIP - (target - HIP) * ((knee - HIP) @ (target - HIP)) / way**2
    plane = np.cross(target - HIP, ahead)
    assume(np.linalg.norm(plane) > 0.1)
    assert abs(bent @ plane) < 1e-7  # in the plane of the leg and the way ahead
    assert bent @ ahead > -1e-9
