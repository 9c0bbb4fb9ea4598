"""Files of motion by their names."""

from __future__ import annotations

import pytest

from omote.interchange.clips.motion_files import read_motion
from tests.interchange.clips.humanoids import MIXAMO, bvh_of, moving


def test_a_motion_is_read_by_its_name() -> None:
    assert read_motion("Walk.BVH", bvh_of(moving(tuple(MIXAMO)), MIXAMO)).stands


def test_other_names_and_nothing_are_rejected() -> None:
    for name, data, said in (("a.fbx", b"x", "give .bvh or .vrma"), ("a.bvh", b" \n", "it is empty")):
        with pytest.raises(ValueError, match=said):
            read_motion(name, data)
