"""The check that numbers and names pass on their way in."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.limits import check_known, check_within


@given(st.floats(-0.5, 1.5))
def test_a_number_in_range_passes_untouched(value: Any) -> None:
    assert check_within(value, -0.5, 1.5, "the channel jawOpen") == value


@pytest.mark.parametrize("value", [1, np.float32(0.5), np.int64(1), Fraction(1, 3)])
def test_every_kind_of_real_number_passes_as_float(value: Any) -> None:
    assert check_within(value, 0.0, 1.0, "the T-bar") == float(value)
    assert type(check_within(value, 0.0, 1.0, "the T-bar")) is float


@pytest.mark.parametrize(
    "value", [math.nan, math.inf, -math.inf, 1.6, -0.51, 10**400, pytest.param(-(10**5000), id="-1e5000")]
)
def test_a_number_out_of_range_is_refused_by_name(value: Any) -> None:
    with pytest.raises(ValueError, match=r"the channel jawOpen is .*; give a number from -0.5 to 1.5"):
        check_within(value, -0.5, 1.5, "the channel jawOpen")


@pytest.mark.parametrize("value", [True, False, "0.5", None, 1j, [0.5], np.array([0.5])])
def test_what_is_no_number_is_refused_by_name(value: Any) -> None:
    with pytest.raises(TypeError, match="the channel jawOpen must be a number"):
        check_within(value, -0.5, 1.5, "the channel jawOpen")


def test_an_unknown_name_is_refused_with_the_nearest() -> None:
    assert check_known("kaori", ["generic", "kaori"], "face") == "kaori"
    with pytest.raises(ValueError, match="there is no face 'koari' in this cast; near are kaori"):
        check_known("koari", ["generic", "kaori"], "face")
    with pytest.raises(ValueError, match="there is no face '7' in this cast; there are generic, kaori"):
        check_known(7, ["generic", "kaori"], "face")
