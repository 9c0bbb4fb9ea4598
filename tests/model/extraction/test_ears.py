"""Ears that turned on a face are taken as turns; a face that turns none gives those of the sum that it wears."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.model.extraction.extract import extract
from omote.model.space.face import Face
from omote.model.space.gain import Gain
from omote.model.transfer.compound import compound

CAST = omote.load_cast()
HOUND = Face("hound", CAST.faces["dog"].positions, CAST.faces["dog"].parts, gains=(Gain("ears", 1.5),))
KNOWN = [CAST.expressions[name] for name in ("browInnerUp", "browDownLeft", "jawOpen", "mouthSmileLeft")]


@pytest.mark.parametrize("wearer", ["hound", "man"])
def test_what_turned_the_ears_of_one_face_is_worn_by_others_as_it_was_meant(wearer: str) -> None:
    shape = CAST.expressions["browInnerUp"]
    face = HOUND if wearer == "hound" else CAST.faces[wearer]
    assert shape.ears.any()
    moved = compound(CAST.space, HOUND, shape).astype(np.float64) - HOUND.positions
    taken = extract(CAST.space, HOUND, moved, known=KNOWN)
    error = compound(CAST.space, face, taken).astype(np.float64) - compound(CAST.space, face, shape)
    assert np.linalg.norm(error, axis=1).max() < (5e-5 if wearer == "hound" else 1e-3)


@pytest.mark.parametrize("weight", [1.0, 0.6])
def test_a_face_that_turns_no_ears_gives_those_of_the_known_sum_that_it_wears(weight: float) -> None:
    """The man's ears are still, and so is his head; the same expression, taken from him, turns the dog's as it did."""
    face = CAST.faces["man"]
    shape = CAST.expressions["browInnerUp"]
    moved = compound(CAST.space, face, shape, weight).astype(np.float64) - face.positions
    nodding = replace(shape, head=np.array([0.0, 0.2, 0.1]))
    taken = extract(CAST.space, face, moved, known=[nodding, *KNOWN[1:]])
    assert np.abs(taken.ears - weight * shape.ears).max() < 1e-5
    assert np.abs(taken.head - weight * nodding.head).max() < 1e-5
    error = compound(CAST.space, HOUND, taken).astype(np.float64) - compound(CAST.space, HOUND, shape, weight)
    assert np.linalg.norm(error, axis=1).max() < 5e-5


def test_ears_that_nothing_tells_of_stay_still() -> None:
    """Neither what is known of other shapes nor nothing at all says how the ears of a man turn, who turns none."""
    face = CAST.faces["man"]
    shape = CAST.expressions["browInnerUp"]
    moved = compound(CAST.space, face, shape).astype(np.float64) - face.positions
    for known in ((), KNOWN[1:]):
        taken = extract(CAST.space, face, moved, known=known)
        assert not taken.ears.any()
        assert not taken.head.any()
