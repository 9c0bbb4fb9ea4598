"""The outline of a tooth: its measures, its symmetry, and where it lies in its row."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.tooth_profiles import JAWS, MOST_CROWN, RIBS, TEETH, Tooth, ToothRow, outline

ROWS = [row for rows in JAWS.values() for row in rows.values()]
TOOTH_OF_ROW = [(tooth, row) for row in ROWS for tooth in row.teeth]
UP, INWARD, HEIGHT, ACROSS = range(4)


def test_each_row_has_as_many_teeth() -> None:
    assert {len(row.teeth) for row in ROWS} == {TEETH}


@given(st.sampled_from(TOOTH_OF_ROW), st.floats(0.0, 1.0), st.floats(14.0, 24.0))
def test_a_tooth_is_the_same_on_both_sides(found: tuple[Tooth, ToothRow], t: float, reach: float) -> None:
    np.testing.assert_array_equal(outline(*found, t, reach), outline(*found, -t, reach))


@pytest.mark.parametrize("found", [each for each in TOOTH_OF_ROW if each[0].height > 0.0])
def test_a_crown_is_as_high_as_its_measure_and_its_sides_are_lower(found: tuple[Tooth, ToothRow]) -> None:
    tooth, row = found
    ribs = outline(tooth, row, 0.0, 18.0)
    half = ribs[ribs[:, HEIGHT] == 0.5, UP][0]
    edge = ribs[ribs[:, HEIGHT] == 1.0, UP][0]
    assert 2.0 * (half - edge) == pytest.approx(min(tooth.height, MOST_CROWN * 18.0 + tooth.over + row.over))
    side = outline(tooth, row, 1.0, 18.0)
    assert (side[side[:, HEIGHT] == 1.0, UP] >= edge - 1e-9).all(), "corners lie behind the middle"
    assert len(ribs) == len(side) == RIBS


@given(st.sampled_from(TOOTH_OF_ROW), st.floats(-1.0, 1.0), st.floats(14.0, 24.0))
def test_palate_and_floor_meet_the_other_side_halfway(
    found: tuple[Tooth, ToothRow], t: float, reach: float
) -> None:  # fmt: skip
    ribs = outline(*found, t, reach)
    assert ribs[-1, ACROSS] == 0.5
    assert (ribs[:-2, ACROSS] == 0.0).all()
    assert (ribs[:, INWARD] >= found[1].inside - 0.11).all(), "nothing stands out of the cage but the gum's swelling"
