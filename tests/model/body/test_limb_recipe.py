"""Limb fields as people write them."""

from __future__ import annotations

import pytest

from omote.model.body.limb_recipe import limb_channels, read_limb_recipes

WRITTEN = b"""
[[field]]
name = "calf"
label = "Calf"
pair = true
bumps = [{ limb = "lowerleg", way = 0.3, out = 0.2 }]
[[field]]
name = "belly"
label = "Belly"
bumps = [{ limb = "trunk", way = 0.3, out = 0.2 }]
"""


def test_a_pair_has_a_channel_a_side_and_others_move_both() -> None:
    calf, belly = (limb_channels(recipe) for recipe in read_limb_recipes(WRITTEN))
    assert [(each.name, each.label, each.sides) for each in calf] == [
        ("calfLeft", "Calf, left", ("L",)),
        ("calfRight", "Calf, right", ("R",)),
    ]
    assert [(each.name, each.sides) for each in belly] == [("belly", ("L", "R"))]


@pytest.mark.parametrize("wrong", [b'limb = "tail"', b"out = 0.9", b"deep = 1"])
def test_what_no_limb_can_have_is_refused(wrong: bytes) -> None:
    text = WRITTEN.replace(b'limb = "trunk"', wrong) if wrong.startswith(b"limb") else WRITTEN + b"\n"
    if not wrong.startswith(b"limb"):
        text = WRITTEN.replace(b'"trunk", way = 0.3, out = 0.2', b'"trunk", way = 0.3, ' + wrong)
    with pytest.raises(ValueError, match="bumps"):
        read_limb_recipes(text)
