"""The weighted sum of arrays against NumPy's."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.blending.weighted_sum import sum_rows, weighted_sum


@given(st.integers(1, 11), st.integers(0, 5000), st.integers(0, 2**32 - 1))
def test_it_is_the_sum_of_factor_times_array(count: int, vertices: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    arrays = rng.standard_normal((count, vertices, 3)).astype(np.float32)
    factors = rng.standard_normal(count)
    expected = np.tensordot(factors, arrays.astype(np.float64), axes=1)
    assert weighted_sum(list(zip(factors, arrays, strict=True))) == pytest.approx(expected, abs=1e-4, rel=1e-4)


def test_one_array_at_weight_one_comes_back_bit_by_bit() -> None:
    array = np.random.default_rng(1).standard_normal((100, 3)).astype(np.float32)
    array.setflags(write=False)
    assert np.array_equal(weighted_sum([(1.0, array)]), array)


@pytest.mark.parametrize(
    ("arrays", "sentence"),
    [
        ([], "there is nothing to blend"),
        ([np.zeros((3, 3))], "an array of float64"),
        ([np.zeros((3, 3), np.float32), np.zeros((4, 3), np.float32)], r"float32 \(4, 3\) among"),
        ([np.zeros((3, 3), np.float32).T], "expected C-contiguous"),
        ([np.zeros((6, 3), np.float32)[::2]], "expected C-contiguous"),
    ],
)
def test_arrays_that_do_not_fit_are_refused(arrays: list[np.ndarray], sentence: str) -> None:
    if "C-contiguous" in sentence and arrays[0].shape == (3, 3) and arrays[0].flags.c_contiguous:
        pytest.fail("the case is not what it says")
    with pytest.raises(ValueError, match=sentence):
        weighted_sum([(1.0, array) for array in arrays])


@given(st.integers(0, 9), st.integers(1, 5000), st.integers(0, 2**32 - 1))
def test_rows_of_a_table_are_summed_alike(count: int, length: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    table = rng.standard_normal((10, length)).astype(np.float32)
    rows = rng.integers(0, 10, count)
    factors = rng.standard_normal(count).astype(np.float32)
    out = np.full(length, np.nan, np.float32)
    sum_rows(table, rows, factors, out)
    assert out == pytest.approx(factors @ table[rows], abs=1e-4, rel=1e-4)
