"""The turns of ears are found in the displacement itself, whatever is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.extraction.ear_turns import fit_ear_turns, undo_ears
from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.gain import Gain
from omote.model.transfer.compound import compound

CAST = omote.load_cast()
HOUND = Face("hound", CAST.faces["dog"].positions, CAST.faces["dog"].parts, gains=(Gain("ears", 1.5),))


def displace(face: Face, shape: Expression) -> NDArray[np.float64]:
    """What a shape does to a face, metres."""
    return compound(CAST.space, face, shape).astype(np.float64) - face.positions


@pytest.mark.parametrize("unit", ["browInnerUp", "browDownLeft", "eyeWideLeft"])
def test_with_the_ears_turned_back_what_is_left_is_the_rest_of_the_shape(unit: str) -> None:
    shape = CAST.expressions[unit]
    moved = displace(HOUND, shape)
    still = displace(HOUND, replace(shape, ears=np.zeros((2, 3))))
    assert np.abs(moved - still).max() > 5e-3
    left = undo_ears(CAST.space, HOUND, moved, fit_ear_turns(CAST.space, HOUND, moved)) - still
    assert np.abs(left[CAST.space.on_sheet]).max() < 2e-5


def test_where_no_ear_turns_none_is_found() -> None:
    moved = displace(HOUND, CAST.expressions["jawOpen"])
    assert not fit_ear_turns(CAST.space, HOUND, moved).any()
    bare = Face("bare", HOUND.positions, HOUND.parts)  # without a gain for ears
    assert not fit_ear_turns(CAST.space, bare, displace(HOUND, CAST.expressions["browInnerUp"])).any()


def test_a_shape_that_turned_ears_is_worn_right_with_nothing_known() -> None:
    """On the dog itself, ears and all, and on the man, whom it would else give the dog's ears as a field."""
    shape = CAST.expressions["browInnerUp"]
    taken = extract(CAST.space, HOUND, displace(HOUND, shape))
    for face, bar in ((HOUND, 5e-5), (CAST.faces["man"], 1e-3)):
        assert np.linalg.norm(displace(face, taken) - displace(face, shape), axis=1).max() < bar
