"""Poses: what is none is rejected."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.body.pose import Pose


def test_what_is_no_pose_is_rejected_and_one_is_frozen() -> None:
    still = np.zeros((4, 3))
    assert not Pose("still", still).turns.flags.writeable
    assert Pose("small_bow", still).label == "Small bow"
    wrongs = ({"turns": still + 4.0}, {"turns": np.zeros(4)}, {"travel": [0.0, 9.0, 0.0]}, {"feet": np.zeros((3, 3))})
    for wrong in (*wrongs, {"feet_turns": np.full((2, 3), np.inf)}, {"name": ""}):
        with pytest.raises(ValueError, match=r"turns|travel|feet|name"):
            Pose(**({"name": "still", "turns": still} | wrong))
