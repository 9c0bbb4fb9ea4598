"""The mouth of a new face at rest: put in order once, and then it stays."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.mouth.mouth_at_rest import fit_mouth_at_rest
from omote.model.transfer.mouth_bag import find_mouth_bag
from tests.synthetic import space

CAST = omote.load_cast()


@pytest.mark.parametrize("name", ["kaori", "man", "count"])
def test_only_lips_and_bag_of_a_face_change_and_hardly_any_more_once_they_are_in_order(name: str) -> None:
    face, bag = CAST.faces[name], find_mouth_bag(CAST.space)
    assert bag is not None
    again = fit_mouth_at_rest(CAST.space, face.positions, face.parts)
    outside = ~np.isin(CAST.space.welded, bag.vertices)
    assert np.abs(again - face.positions)[outside].max() < 1e-7
    assert np.quantile(np.abs(again - face.positions).max(axis=1)[~outside], 0.9) < 0.002


def test_a_head_without_a_mouth_stays() -> None:
    positions = space().points.astype(np.float32)
    assert np.array_equal(fit_mouth_at_rest(space(), positions, {}), positions)
