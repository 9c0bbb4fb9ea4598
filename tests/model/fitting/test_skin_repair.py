"""Folds of a skin are found and smoothed away; what is not folded stays."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.builtin import load_identity_modes
from omote.model.fitting.skin_repair import (
    SLIGHT,
    ease_creases,
    find_creases,
    find_folds,
    repair_folds,
    repair_slight_folds,
)

SPACE = omote.load_cast().space
MODES = load_identity_modes()
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


@pytest.mark.parametrize("strength", [1.0, 2.0])
def test_what_modes_crease_is_eased_and_who_has_no_crease_stays(strength: float) -> None:
    """Modes lay thin ears on themselves: a fit that began from such a head was folded as it is, without a doubt."""
    creased = 0
    for seed in range(12):
        head = MODES.shape_skin(strength * np.random.default_rng(seed).standard_normal(len(MODES.moves)))
        before = find_creases(SPACE, MODES.skin, head)
        eased = ease_creases(SPACE, MODES.skin, head)
        assert len(find_creases(SPACE, MODES.skin, eased)) == 0
        assert np.abs(eased - head).max() < 0.0035 * strength
        assert len(before) or eased is head
        creased += bool(len(before))
    assert creased >= 3


def test_a_head_that_is_turned_has_folds_against_the_generic_one_and_no_creases() -> None:
    turned = SPACE.points * [-1.0, 1.0, -1.0]
    assert len(find_folds(SPACE, SPACE.points, turned))
    assert len(find_creases(SPACE, SPACE.points, turned)) == 0
    assert ease_creases(SPACE, SPACE.points, turned) is turned
