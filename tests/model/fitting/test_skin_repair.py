"""Folds of a skin are found and smoothed away; what is not folded stays."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.fitting.skin_repair import find_folds, repair_folds

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
