"""Doubts: none of a good fit, one sentence for each thing that is wrong."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.fitting.fit_face import find_doubts
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.mode_fit import ModeFit
from omote.model.space.similarity import Similarity

SPACE = omote.load_cast().space
ZONES = head_zones(SPACE)
GOOD = np.full(SPACE.vertex_count, 0.1)


def found(weight: float = 0.0) -> ModeFit:
    """Modes of one weight each."""
    return ModeFit(np.full(110, weight), Similarity(1.0, np.eye(3), np.zeros(3)))


def test_a_good_fit_leaves_no_doubt() -> None:
    assert find_doubts(ZONES, found(), GOOD, 0, False, False, False) == ()


@pytest.mark.parametrize(
    ("fit", "residual", "folds", "filled", "turned", "word"),
    [
        (found(), np.where(ZONES.face, np.nan, 0.1), 0, False, False, "Only 0%"),
        (found(), 20 * GOOD, 0, False, False, "2.0 mm from the scan"),
        (found(5.0), GOOD, 0, False, False, "unlike those of people"),
        (found(), GOOD, 3, False, False, "folded at 3 triangles"),
        (found(), GOOD, 0, True, False, "closed between its lids"),
        (found(), GOOD, 0, False, True, "may be mirrored"),
    ],
)
def test_each_fault_is_said(
    fit: ModeFit, residual: np.ndarray, folds: int, filled: bool, turned: bool, word: str
) -> None:
    (sentence,) = find_doubts(ZONES, fit, residual, folds, filled, turned, False)
    assert word in sentence
    assert sentence.endswith(".")
