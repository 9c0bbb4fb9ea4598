"""PNG pictures: there and back, and what is none."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from omote.interchange.formats.png import png_bytes, read_png


@given(arrays(np.uint8, st.tuples(st.integers(1, 9), st.integers(1, 9), st.sampled_from([3, 4]))))
def test_a_picture_comes_back_as_it_was(picture: np.ndarray) -> None:
    np.testing.assert_array_equal(read_png(png_bytes(picture)), picture)


@pytest.mark.parametrize("data", [b"", b"GIF89a", b"\x89PNG\r\n\x1a\n", b"\x89PNG\r\n\x1a\n" + bytes(40)])
def test_what_is_no_picture_is_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(data)


def test_a_picture_cut_short_is_refused() -> None:
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(png_bytes(np.zeros((8, 8, 4), np.uint8))[:-30])
