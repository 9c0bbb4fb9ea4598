"""People of ICT-FaceKit whose ears the modes fold: their fits fold nothing."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from benchmarks.scans import fit_measures, ict_people

SPACE = omote.load_cast().space


@pytest.mark.data
@pytest.mark.slow
@pytest.mark.parametrize("seed", [(9411201, 1), (572763, 9)])
def test_a_person_whose_ears_the_modes_fold_has_none_and_no_doubt(seed: tuple[int, int]) -> None:
    """The modes laid ears on themselves, and 37 and 26 edges of the fits were folded there without a doubt."""
    if not ict_people.at_hand():
        pytest.skip("ICT-FaceKit is not at hand")
    model = ict_people.read_model()
    person = model.draw(seed)
    fit = omote.fit(SPACE, person, model.triangles, landmarks=model.clicks(person))
    assert fit_measures.count_folds(SPACE, fit.face.positions.astype(np.float64)) == 0
    assert fit.doubts == ()
