"""People of ICT-FaceKit whose ears the modes fold: their fits fold nothing."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from benchmarks.scans import fit_measures, ict_people

SPACE = omote.load_cast().space


@pytest.mark.data
@pytest.mark.slow
def test_a_person_whose_ears_the_modes_fold_has_none_and_no_doubt() -> None:
    """The modes' head had 50 folded edges, the fit 37 at its right ear and no doubt."""
    if not ict_people.at_hand():
        pytest.skip("ICT-FaceKit is not at hand")
    model = ict_people.read_model()
    person = model.draw((9411201, 1))
    fit = omote.fit(SPACE, person, model.triangles, landmarks=model.clicks(person))
    assert fit_measures.count_folds(SPACE, fit.face.positions.astype(np.float64)) == 0
    assert fit.doubts == ()
