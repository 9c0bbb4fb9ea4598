"""A pose of the moment as the bytes that go over links: 16 bits a number, little-endian."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.model.body.pose import FARTHEST, FEET, LARGEST_TURN, Pose

TURN_STEP = LARGEST_TURN / 32767.0
"""Radians; a hundredth of a millimetre at the end of an arm."""
PLACE_STEP = FARTHEST / 32767.0
"""Leg lengths; a tenth of a millimetre."""
PLACES = 3 + 3 * FEET
"""Numbers that say where hips and feet are; turns of bones stand before them, those of the feet after."""
BESIDE_BONES = PLACES + 3 * FEET


def pose_numbers(pose: Pose) -> Values:
    """A pose as one vector (3 J + 15,): the turns of its bones, where hips and feet are, the turns of the feet."""
    parts = (pose.turns, pose.travel, pose.feet, pose.feet_turns)
    return np.concatenate([np.asarray(part).ravel() for part in parts])


def pack_pose(numbers: Values) -> bytes:
    """The bytes of a pose, whose numbers go to the end of their range at most. numbers: as of `pose_numbers`."""
    steps = np.rint(numbers / _steps(len(numbers)))
    return np.clip(steps, -32767, 32767).astype("<i2").tobytes()


def unpack_pose(packed: bytes, bones: int) -> Values:
    """The numbers of packed bytes; ValueError where they are not those of so many bones."""
    expected = 2 * (3 * bones + BESIDE_BONES)
    if len(packed) != expected:
        raise ValueError(f"a body of {len(packed)} bytes came for {bones} bones; send {expected}: 16 bits a number")
    values = np.frombuffer(packed, "<i2").astype(np.float64)
    return np.maximum(values, -32767.0) * _steps(len(values))


def _steps(count: int) -> Values:
    steps = np.full(count, TURN_STEP)
    steps[count - BESIDE_BONES : count - BESIDE_BONES + PLACES] = PLACE_STEP
    return steps
