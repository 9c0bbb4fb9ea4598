"""PNG pictures: there and back, and what is none."""

import contextlib
import io
import resource
import struct
import tracemalloc
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from PIL import Image

from omote.interchange.formats.png import png_bytes, read_png


@given(arrays(np.uint8, st.tuples(st.integers(1, 9), st.integers(1, 9), st.sampled_from([3, 4]))))
def test_a_picture_comes_back_as_it_was(picture: np.ndarray) -> None:
    np.testing.assert_array_equal(read_png(png_bytes(picture)), picture)


@pytest.mark.parametrize("mode", ["L", "P", "LA", "I;16"])
def test_other_kinds_of_pictures_are_refused(mode: str) -> None:
    file = io.BytesIO()
    Image.new(mode, (4, 4)).save(file, "PNG")
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(file.getvalue())


@pytest.mark.parametrize("data", [b"", b"GIF89a", b"\x89PNG\r\n\x1a\n", b"\x89PNG\r\n\x1a\n" + bytes(40)])
def test_what_is_no_picture_is_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(data)


def test_a_picture_cut_short_is_refused() -> None:
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(png_bytes(np.zeros((8, 8, 4), np.uint8))[:-30])


def test_other_sizes_than_asked_for_are_refused() -> None:
    square = png_bytes(np.zeros((8, 8, 4), np.uint8))
    np.testing.assert_array_equal(read_png(square, sides=(4, 8)), 0)
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(square, sides=(16,))


def test_no_more_is_unpacked_than_the_head_says() -> None:
    """A bomb: 1 x 1 pixels, behind whose head 64 MB of zeros are packed."""
    body = zlib.compress(bytes(2**26), 9)
    data = png_bytes(np.zeros((1, 1, 4), np.uint8))[:33] + struct.pack(">I", len(body)) + b"IDAT" + body + bytes(4)
    tracemalloc.start()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with contextlib.suppress(ValueError):
        assert read_png(data).shape == (1, 1, 4)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 2**15, "kilobytes"
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2**22
