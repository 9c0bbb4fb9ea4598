"""Recipes of poses: sides mirror one another, and joints bend the way people's do."""

from __future__ import annotations

import msgspec
import pytest

from omote.builtin import POSES
from omote.builtin.figurefile import read_poses


def test_the_library_has_poses_enough_and_each_says_what_it_is() -> None:
    recipes = read_poses(POSES.read_bytes())
    assert len({recipe.name for recipe in recipes}) == len(recipes) >= 30
    assert all(recipe.label for recipe in recipes)


def test_a_recipe_with_what_nobody_knows_is_rejected() -> None:
    for text in (b"[[pose]]\nname = 'a'\ntail = 3", b"[[pose]]\nname = 'a'\nleft = { elbow = 900 }", b"name = 'a'"):
        with pytest.raises((msgspec.ValidationError, ValueError)):
            read_poses(text)
