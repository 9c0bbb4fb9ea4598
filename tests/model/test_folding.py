"""Where skin folds: in front, by how far the cast presses it, alike on both sides."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.model.controls.mirror import mirror_rows
from omote.model.folding import LIDS, RANGE, asked_of, most_compression

CAST = load_cast()
SPACE = CAST.space


def test_what_is_asked_lies_in_front_and_on_the_sheet() -> None:
    asked = asked_of(SPACE)
    assert SPACE.on_sheet[asked].all()
    assert (SPACE.points[asked, 2] > 0.0).all()
    assert CAST.folding is not None
    assert np.array_equal(CAST.folding > 0, asked)


def test_nothing_worn_presses_by_the_least_that_counts_and_more_presses_more() -> None:
    rest = most_compression(SPACE, [])
    least = round(255 * RANGE[0] / RANGE[1])
    assert {*np.unique(rest).tolist()} == {0, least}
    frown = most_compression(SPACE, [CAST.expressions["browDownLeft"]])
    both = most_compression(SPACE, [CAST.expressions[name] for name in ("browDownLeft", "browDownRight")])
    assert (frown >= rest).all()
    assert (both >= frown).all()
    between = (np.abs(SPACE.points[:, 0]) < 0.008) & (np.abs(SPACE.points[:, 1] - 0.02) < 0.006) & (rest > 0)
    assert both[between].max() > 3 * least


def test_both_sides_are_pressed_alike() -> None:
    assert CAST.folding is not None
    apart = CAST.folding.astype(int) - CAST.folding[mirror_rows(SPACE)].astype(int)
    assert np.abs(apart).max() <= 40


@pytest.mark.parametrize("name", LIDS)
def test_units_of_lids_are_of_the_cast(name: str) -> None:
    assert name in CAST.expressions
