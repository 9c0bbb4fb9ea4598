"""The columns of a row of teeth, by the places of its vertices alone."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.model.space.teeth_cage import COLUMN_ROWS, COLUMNS, cage_columns
from omote.model.transfer.gum_line import GUMS

SPACE = load_cast().space
BOTH = pytest.mark.parametrize("name", [*GUMS])


@BOTH
def test_columns_are_found_in_whatever_order_rows_come(name: str) -> None:
    points = SPACE.parts[name].points
    columns = cage_columns(points, upper=name == "teeth_upper")
    assert columns is not None
    assert sorted(columns.ravel()) == list(range(COLUMNS * COLUMN_ROWS))
    order = np.random.default_rng(3).permutation(len(points))
    found = cage_columns(points[order], upper=name == "teeth_upper")
    assert found is not None
    np.testing.assert_array_equal(order[found], columns)
    edges = points[columns[:, 2]] - points.mean(axis=0)
    assert (np.diff(np.arctan2(edges[:, 0], edges[:, 2])) > 0.0).all(), "from the right end to the left"
    assert cage_columns(points[1:], upper=True) is None
