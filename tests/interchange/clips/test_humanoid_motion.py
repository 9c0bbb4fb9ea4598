"""The motion of a humanoid: what it can be, and turns against parents and along the house."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.clips.humanoid_motion import MOST_TURNS, PARENTS, HumanoidMotion, check_size, turns_of_worlds
from tests.interchange.clips.humanoids import MIXAMO, moving


def test_all_bones_of_a_humanoid_have_their_parents_before_them() -> None:
    assert set(PARENTS) == set(humanoid_bones())
    seen = {""}
    for bone, parent in PARENTS.items():
        assert parent in seen
        seen.add(bone)


def test_turns_along_the_house_come_back_as_they_were() -> None:
    motion = moving(tuple(MIXAMO))
    names, turns = turns_of_worlds(motion.worlds())
    assert names == motion.names
    assert np.abs(np.abs((turns * motion.turns).sum(axis=2)) - 1.0).max() < 1e-12
    assert motion.stands
    assert not moving(("hips", "neck", "head")).stands


def test_what_is_no_motion_is_rejected() -> None:
    one = moving(("hips", "head"), frames=2)

    def made(**changes: Any) -> HumanoidMotion:
        return HumanoidMotion(**{**vars(one), **changes})

    refused: dict[str, dict[str, Any]] = {
        "expected those of VRM": {"names": ("hips", "tail")},
        "do not rise": {"times": [1.0, 1.0]},
        "the hips of a motion is": {"hips": [[0.0, 0.0, 0.0]]},
        "no finite number": {"hips": [[np.nan, 0.0, 0.0]] * 2},
        "go farther": {"hips": [[1e6, 0.0, 0.0]] * 2},
        "length 0": {"turns": np.zeros((2, 2, 4))},
        "expected some": {"times": []},
    }
    for said, changes in refused.items():
        with pytest.raises(ValueError, match=said):
            made(**changes)
    with pytest.raises(ValueError, match="cut it into parts"):
        check_size(MOST_TURNS, 2)
