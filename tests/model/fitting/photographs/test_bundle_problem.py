"""Where unknowns stand."""

from __future__ import annotations

import numpy as np

from omote.builtin import load_cast, load_identity_modes, load_landmark_table
from omote.model.fitting.photographs.bundle_problem import LIGHTS, PAINTS, Problem
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.skin_evidence import unknowns

MODES = load_identity_modes()
TABLE = load_landmark_table()


def test_each_unknown_stands_at_one_place_and_lenses_are_shared() -> None:
    views = [Photograph(np.full((478, 2), 9.0), 500, 500)] * 3
    problem = Problem(
        load_cast().space, MODES, TABLE, views, TABLE.places(MODES.skin), TABLE.places(MODES.moves),
        np.stack(list(TABLE.units.values())), [0, 1, 0], [None] * 3,
    )  # fmt: skip
    columns = [problem.columns(view) for view in range(3)]
    own = [set(each[problem.common :]) for each in columns]
    assert len(own[0] & own[2]) == 1
    assert not own[0] & own[1]
    used = np.unique(np.concatenate([*columns, *(unknowns(problem, view) for view in range(3))]))
    assert np.array_equal(used, np.arange(problem.size))
    assert problem.size - problem.lit == 3 * LIGHTS + PAINTS
