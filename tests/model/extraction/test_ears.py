"""Ears that turned on a face are taken from it as turns, and stay still on faces that do not answer with theirs."""

from __future__ import annotations

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
    shape, face = CAST.expressions["browInnerUp"], HOUND if wearer == "hound" else CAST.faces[wearer]
    assert shape.ears.any()
    moved = compound(CAST.space, HOUND, shape).astype(np.float64) - HOUND.positions
    taken = extract(CAST.space, HOUND, moved, known=KNOWN)
    error = compound(CAST.space, face, taken).astype(np.float64) - compound(CAST.space, face, shape)
    assert np.linalg.norm(error, axis=1).max() < (5e-5 if wearer == "hound" else 1e-3)


def test_a_face_that_answers_with_no_ears_keeps_what_moved_there_in_the_field() -> None:
    face, shape = CAST.faces["man"], CAST.expressions["browInnerUp"]
    moved = compound(CAST.space, face, shape).astype(np.float64) - face.positions
    assert not extract(CAST.space, face, moved, known=KNOWN).ears.any()
