"""Folds of a skin are found and smoothed away; what is not folded stays."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.fitting.skin_repair import SLIGHT, find_folds, repair_folds, repair_slight_folds

SPACE = omote.load_cast().space
CHEEK = int(np.linalg.norm(SPACE.points - [0.05, -0.04, 0.12], axis=1).argmin())


def folded_skin() -> np.ndarray:
    """The generic head with one vertex of a cheek drawn over its neighbours."""
    skin = SPACE.points.copy()
    skin[CHEEK] += [0.02, 0.02, 0.0]
    return skin


def test_folds_are_those_around_what_was_drawn_over() -> None:
    found = find_folds(SPACE, SPACE.points, folded_skin())
    assert len(found) > 0
    assert (SPACE.sheet_triangles[found] == CHEEK).any(axis=1).all()
    assert len(find_folds(SPACE, SPACE.points, SPACE.points)) == 0


def test_folds_are_mended_and_the_rest_stays() -> None:
    skin = folded_skin()
    repaired = repair_folds(SPACE, SPACE.points, skin)
    assert len(find_folds(SPACE, SPACE.points, repaired)) == 0
    far = np.linalg.norm(SPACE.points - SPACE.points[CHEEK], axis=1) > 0.05
    assert np.array_equal(repaired[far], skin[far])
    assert np.array_equal(repair_folds(SPACE, SPACE.points, SPACE.points + 0.01), SPACE.points + 0.01)


def test_a_sliver_that_folds_by_hundredths_of_a_millimetre_is_mended() -> None:
    """A corner that went over the edge before it: what was left after all smoothing."""
    skin = SPACE.points.copy()
    rows = SPACE.sheet_triangles[(SPACE.sheet_triangles == CHEEK).any(axis=1)][0]
    one, other = rows[rows != CHEEK]
    along = skin[other] - skin[one]
    foot = skin[one] + along * ((skin[CHEEK] - skin[one]) @ along) / (along @ along)
    over = (foot - skin[CHEEK]) / np.linalg.norm(foot - skin[CHEEK])
    skin[CHEEK] = foot + 2e-5 * over
    assert 0 < len(find_folds(SPACE, SPACE.points, skin)) <= 13
    mended = repair_slight_folds(SPACE, SPACE.points, skin)
    assert len(find_folds(SPACE, SPACE.points, mended)) == 0
    assert 0.0 < np.abs(mended - skin).max() <= SLIGHT


def test_what_folds_far_stays_and_is_told() -> None:
    skin = folded_skin()
    assert repair_slight_folds(SPACE, SPACE.points, skin) is skin
