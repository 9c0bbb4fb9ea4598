"""Poses as bytes: they come back to half a step, and no byte string is another skeleton's."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.body.pose import FARTHEST, LARGEST_TURN, Pose
from omote.perform.figures.packed_pose import (
    BESIDE_BONES,
    PLACE_STEP,
    PLACES,
    TURN_STEP,
    pack_pose,
    pose_numbers,
    unpack_pose,
)


@given(st.integers(1, 80), st.integers(0, 2**32 - 1))
def test_a_pose_comes_back_to_half_a_step(bones: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    turns, feet_turns = (random.uniform(-LARGEST_TURN, LARGEST_TURN, (count, 3)) for count in (bones, 2))
    travel, feet = random.uniform(-FARTHEST, FARTHEST, 3), random.uniform(-FARTHEST, FARTHEST, (2, 3))
    numbers = pose_numbers(Pose("moment", turns, travel, feet, feet_turns))
    packed = pack_pose(numbers)
    assert len(packed) == 2 * (3 * bones + BESIDE_BONES)
    away = np.abs(unpack_pose(packed, bones) - numbers)
    places = slice(3 * bones, 3 * bones + PLACES)
    assert away[places].max() <= 0.5001 * PLACE_STEP
    assert np.delete(away, np.r_[places]).max() <= 0.5001 * TURN_STEP
    assert pack_pose(unpack_pose(packed, bones)) == packed


def test_numbers_end_at_their_range_and_lengths_are_told() -> None:
    numbers = np.full(3 + BESIDE_BONES, 100.0)
    assert unpack_pose(pack_pose(-numbers), 1).tolist() == (-unpack_pose(pack_pose(numbers), 1)).tolist()
    assert unpack_pose(pack_pose(numbers), 1).max() == pytest.approx(LARGEST_TURN)
    with pytest.raises(ValueError, match="a body of 36 bytes came for 2 bones; send 42"):
        unpack_pose(pack_pose(numbers), 2)
