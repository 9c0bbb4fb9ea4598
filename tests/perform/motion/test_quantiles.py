"""Statistics as tables of quantiles."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion import quantiles
from omote.perform.motion.quantiles import Quantiles, even, lognormal


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_a_quantile_rises_with_its_share_and_lies_between_the_ends(one: float, other: float) -> None:
    table = quantiles.BLINK_PAUSE
    low, high = sorted((one, other))
    assert table.values[0] <= table.at(low) <= table.at(high) <= table.values[-1]


@given(st.floats(0.5, 10.0), st.floats(0.05, 0.6))
def test_a_lognormal_table_has_the_mean_and_the_spread_that_it_was_made_for(mean: float, spread: float) -> None:
    table = lognormal(mean, spread, 0.0, 1e6)
    values = np.array([table.at(share) for share in np.linspace(0.0, 1.0, 4001)])
    assert table.mean == pytest.approx(mean, rel=0.02)
    assert values.mean() == pytest.approx(mean, rel=0.02)
    assert np.log(values).std() == pytest.approx(spread, rel=0.05)


def test_an_even_table_is_a_straight_line() -> None:
    assert [even(1.0, 3.0).at(share) for share in (0.0, 0.25, 1.0)] == [1.0, 1.5, 3.0]


@pytest.mark.parametrize("values", [(), (1.0,), (2.0, 1.0)], ids=["none", "one", "falling"])
def test_what_is_no_distribution_is_rejected(values: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match="expected two or more, rising"):
        Quantiles(values)
