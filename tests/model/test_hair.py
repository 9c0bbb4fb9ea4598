"""Hair is carried by the skin beneath it: exactly where that only shifts, linearly wherever it goes."""

from dataclasses import replace

import numpy as np
import pytest

from omote.model.cast import Look
from omote.model.hair import LINKS, STRETCH, place_strands
from tests import synthetic
from tests.model.tufts import tuft

SKIN, _ = synthetic.head()
RNG = np.random.default_rng(4)


def test_hair_stays_on_its_own_face_and_goes_along_with_a_shift() -> None:
    hair = tuft()
    shift = np.array([0.01, -0.02, 0.03])
    assert np.array_equal(place_strands(hair, SKIN, SKIN), hair.points)
    assert place_strands(hair, SKIN, SKIN + shift) == pytest.approx(hair.points + shift, abs=1e-8)


def test_a_mix_of_faces_wears_the_mix_of_their_hair() -> None:
    hair = tuft()
    one = SKIN * [1.1, 1.0, 0.9]
    two = SKIN + RNG.normal(0.0, 0.005, SKIN.shape)
    mixed = 0.3 * place_strands(hair, SKIN, one) + 0.7 * place_strands(hair, SKIN, two)
    assert place_strands(hair, SKIN, 0.3 * one + 0.7 * two) == pytest.approx(mixed, abs=1e-8)


def test_skin_that_is_torn_apart_does_not_knot_a_strand() -> None:
    hair = tuft()
    torn = SKIN + RNG.normal(0.0, 0.1, SKIN.shape)
    pieces, before = (np.diff(points, axis=1) for points in (place_strands(hair, SKIN, torn), hair.points))
    length = np.linalg.norm(before, axis=2)
    change = np.linalg.norm(pieces - before, axis=2) / length
    assert change.max() == pytest.approx(STRETCH)
    assert ((pieces * before).sum(axis=2) > 0.0).all()  # none turns back on itself


def test_arrays_that_do_not_belong_together_are_refused() -> None:
    with pytest.raises(ValueError, match=r"light of hair style 'tuft' has shape \(5, 2\); expected \(5, 3\)"):
        replace(tuft(), light=np.ones((5, 2), np.float32))
    with pytest.raises(ValueError, match="weights of hair style 'tuft' do not sum to one"):
        replace(tuft(), weights=np.ones((5, 3, LINKS), np.float32))


def test_a_look_with_a_style_that_the_cast_has_not_is_refused() -> None:
    bald = synthetic.cast()
    look = {"generic": Look(hair_style="tuft")}
    with pytest.raises(ValueError, match="the look of 'generic' has hair style 'tuft'; this cast has none: choose one"):
        replace(bald, looks=look)
    worn = replace(bald, looks=look, hair={"tuft": tuft()})
    assert worn.looks["generic"].hair_style == "tuft"


def test_the_strands_belong_to_the_digest() -> None:
    bald = synthetic.cast()
    hair = tuft()
    longer = replace(hair, points=hair.points * np.float32(1.01))
    worn = [replace(bald, hair={"tuft": each}) for each in (hair, longer)]
    assert len({cast.digest for cast in (bald, *worn)}) == 3
