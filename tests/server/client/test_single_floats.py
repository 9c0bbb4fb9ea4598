"""Numbers of a program: packed, or rejected in words."""

import struct

import numpy as np
import pytest

from omote.server.client.single_floats import pack_numbers


def test_numbers_of_any_kind_are_packed() -> None:
    assert pack_numbers([1, 0.5, np.float32(0.25)], "a time") == struct.pack("<3f", 1.0, 0.5, 0.25)


@pytest.mark.parametrize("values", [["0.1"], [None], [True], "0.1", 3])
def test_what_is_no_number_is_said(values: object) -> None:
    with pytest.raises(TypeError, match="give a"):
        pack_numbers(values, "a time")  # type: ignore[arg-type]


def test_a_number_that_no_single_float_holds_is_said() -> None:
    with pytest.raises(ValueError, match="not so large"):
        pack_numbers([1e300], "a time")
