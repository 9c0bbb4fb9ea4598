"""Samples laid over one another."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.clips.clip_parts import PLACES
from omote.perform.clips.sample import Sample, empty_sample, lay_over
from tests.perform.clips.curves import curve, same

shares = st.lists(st.sampled_from([0.0, 0.25, 1.0]), min_size=PLACES, max_size=PLACES).map(np.array)


def sample(seed: int, given_shares: np.ndarray[tuple[int], np.dtype[np.float64]]) -> Sample:
    made = curve(seed, seconds=0.1)
    return Sample(made.layout, made.values(0.05), given_shares)


@given(lower=shares, upper=shares)
def test_what_is_above_shows_as_much_as_it_takes(
    lower: np.ndarray[tuple[int], np.dtype[np.float64]], upper: np.ndarray[tuple[int], np.dtype[np.float64]]
) -> None:
    below, above = sample(1, lower), sample(2, upper)
    found = lay_over(below, above)
    assert found.shares == pytest.approx(upper + (1.0 - upper) * lower)
    whole, over = lower[found.layout.places], upper[found.layout.places]
    assert (found.values[over == 1.0] == above.values[over == 1.0]).all()
    total = over + (1.0 - over) * whole
    wanted = over * above.values + (1.0 - over) * whole * below.values
    assert (total * found.values)[total > 0.0] == pytest.approx(wanted[total > 0.0], abs=1e-12)
    assert same(lay_over(empty_sample(below.layout), above), above)
    assert same(lay_over(above, empty_sample(below.layout)), above)
