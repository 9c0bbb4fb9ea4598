"""Looks by what pictures show: medians of zones that were seen, and nothing painted twice."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.model.albedo import Albedo
from omote.model.appearance.look_suggestion import plain_look, suggest_look
from omote.model.appearance.taken_albedo import TakenAlbedo
from omote.model.cast import Look

SIDE = 1024
LOOK = load_cast().looks["kaori"]


def zone(rows: slice) -> NDArray[np.float32]:
    found = np.zeros((SIDE, SIDE), np.float32)
    found[rows] = 1.0
    return found


def taken(bands: dict[int, tuple[int, int, int]], seen: slice = slice(None)) -> TakenAlbedo:
    """A picture of bands of 100 rows in colours of their own; the rows `seen` were seen."""
    texels = np.full((SIDE, SIDE, 4), 255, np.uint8)
    shown = np.zeros((SIDE, SIDE), np.uint8)
    for first, colour in bands.items():
        texels[first : first + 100, :, :3] = colour
    shown[seen] = 255
    return TakenAlbedo(Albedo(texels), shown)


def test_each_colour_is_the_median_of_its_zone() -> None:
    picture = taken({0: (201, 150, 120), 100: (160, 80, 70), 200: (40, 30, 20)})
    zones = {"skin": zone(slice(0, 100)), "lip": zone(slice(100, 200)), "hair": zone(slice(200, 300))}
    found = suggest_look(LOOK, picture, zones)
    assert (found.skin, found.lip, found.hair) == ("#c99678", "#a05046", "#281e14")
    assert found.albedo is picture.albedo
    assert found.brow == LOOK.brow  # of which no zone says anything


def test_brows_take_the_colour_of_their_hairs_and_not_of_the_skin_between() -> None:
    picture = taken({0: (200, 160, 140), 100: (30, 20, 10)})
    assert suggest_look(LOOK, picture, {"brow": zone(slice(40, 140))}).brow == "#1e140a"


def test_what_was_not_seen_says_nothing() -> None:
    picture = taken({0: (1, 2, 3)}, seen=slice(500, 600))
    assert suggest_look(LOOK, picture, {"skin": zone(slice(0, 100))}).skin == LOOK.skin


def test_a_face_wears_none_of_its_own_painted_marks_under_its_picture() -> None:
    look = Look(
        brows=0.7, freckles=0.4, stubble=0.5, pores=0.8, makeup=0.6, gloss=0.9, hair_style="bob", iris="#112233"
    )
    found = suggest_look(look, taken({}), {})
    assert (found.brows, found.freckles, found.stubble, found.fur) == (0.0, 0.0, 0.0, 0.0)
    assert (found.makeup, found.gloss, found.pores) == (look.makeup, look.gloss, look.pores)  # relief and finish stay
    assert (found.hair_style, found.iris) == (look.hair_style, look.iris)
    assert plain_look(look).makeup == plain_look(look).scalp == plain_look(look).brows == 0.0


def test_zones_of_another_size_are_refused() -> None:
    with pytest.raises(ValueError, match="zone 'skin' has shape"):
        suggest_look(LOOK, taken({}), {"skin": np.zeros((2, 2))})
