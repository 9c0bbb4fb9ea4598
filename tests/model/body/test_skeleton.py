"""Skeletons: parents before children, and sides that mirror one another."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_figures
from omote.model.body.skeleton import Skeleton


def test_a_child_comes_after_its_parent_and_no_name_twice() -> None:
    for names, parents in ((("a", "b"), [-1, 1]), (("a", "a"), [-1, 0]), (("a",), [0]), ((), []), (("a", "b"), [-1])):
        with pytest.raises(ValueError, match=r"parents"):
            Skeleton(names, np.array(parents, np.int32))


def test_the_mirror_of_the_mirror_is_the_bone_and_parents_mirror_too() -> None:
    skeleton = load_figures().space.skeleton
    mirror = skeleton.mirror
    np.testing.assert_array_equal(mirror[mirror], np.arange(len(mirror)))
    np.testing.assert_array_equal(skeleton.parents[mirror][1:], mirror[skeleton.parents[1:]])
