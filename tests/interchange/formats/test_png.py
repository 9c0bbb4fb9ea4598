"""PNG pictures: there and back, and what is none."""

import struct
import tracemalloc
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from omote.interchange.formats.png import png_bytes, read_png


@given(arrays(np.uint8, st.tuples(st.integers(1, 9), st.integers(1, 9), st.sampled_from([3, 4]))))
def test_a_picture_comes_back_as_it_was(picture: np.ndarray) -> None:
    np.testing.assert_array_equal(read_png(png_bytes(picture)), picture)


def predicted(kind: int, left: int, above: int, corner: int) -> int:
    """What a filter of the specification predicts of a byte."""
    nearest = min((left, above, corner), key=lambda each: abs(left + above - corner - each))
    return (0, left, above, (left + above) // 2, nearest)[kind]


@given(
    arrays(np.uint8, st.tuples(st.integers(1, 6), st.integers(1, 6), st.sampled_from([3, 4]))),
    st.lists(st.integers(0, 4), min_size=6, max_size=6),
)
def test_every_filter_of_a_line_is_undone(picture: np.ndarray, kinds: list[int]) -> None:
    rows, _, channels = picture.shape
    flat = np.pad(picture.reshape(rows, -1).astype(int), ((1, 0), (channels, 0)))
    lines = b"".join(
        bytes([kind])
        + bytes(
            (flat[row + 1, at] - predicted(kind, flat[row + 1, at - channels], flat[row, at], flat[row, at - channels]))
            % 256
            for at in range(channels, flat.shape[1])
        )
        for row, kind in zip(range(rows), kinds, strict=False)
    )
    head = png_bytes(picture)[:33]
    body = zlib.compress(lines)
    data = head + struct.pack(">I", len(body)) + b"IDAT" + body + bytes(4)
    np.testing.assert_array_equal(read_png(data), picture)


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
    with pytest.raises(ValueError, match="no PNG of 8 bits"):
        read_png(data)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2**22
