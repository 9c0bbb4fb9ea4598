"""Pictures: upright, as sRGB, without anything else that was in the file; bombs and other files are refused."""

import io
import struct
import zlib
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageCms

from omote.interchange.scans.picture_reader import read_picture, write_plain
from tests.interchange.scans import scan_samples as samples

PIXELS = samples.picture()


@pytest.mark.parametrize("kind", ["PNG", "WEBP", "BMP", "TIFF"])
def test_a_picture_without_loss_comes_back(kind: str) -> None:
    options: dict[str, Any] = {"lossless": True} if kind == "WEBP" else {}
    np.testing.assert_array_equal(read_picture(samples.picture_bytes(kind, **options)), PIXELS)


TURNS = {
    1: PIXELS, 2: PIXELS[:, ::-1], 3: PIXELS[::-1, ::-1], 4: PIXELS[::-1], 5: PIXELS.transpose(1, 0, 2),
    6: PIXELS[::-1].transpose(1, 0, 2), 7: PIXELS[::-1, ::-1].transpose(1, 0, 2), 8: PIXELS[:, ::-1].transpose(1, 0, 2),
}  # fmt: skip
"""What a picture is seen as by its orientation (Exif 2.32, tag 274)."""


@pytest.mark.parametrize("turn", TURNS)
def test_a_picture_stands_upright(turn: int) -> None:
    exif = Image.Exif()
    exif[274] = turn
    np.testing.assert_array_equal(read_picture(samples.picture_bytes("PNG", exif=exif)), TURNS[turn])


def test_a_telephones_picture_stands_upright_once() -> None:
    """Its header and its Exif both say how it lies."""
    found = read_picture(samples.HEIC).astype(int)
    assert found.shape == (64, 48, 3)
    seen = [found[8, 8], found[-8, 8], found[8, -8], found[-8, -8]]
    assert np.abs(np.subtract(seen, [[200, 30, 30], [30, 30, 200], [30, 200, 30], [30, 200, 30]])).max() <= 3
    again = read_picture(write_plain(read_picture(samples.HEIC), 32))
    assert again.shape == (32, 24, 3)


def test_a_jpeg_of_one_colour_keeps_it() -> None:
    flat = np.full((16, 16, 3), (200, 100, 50), np.uint8)
    assert np.abs(read_picture(samples.picture_bytes("JPEG", flat, quality=95)).astype(int) - flat).max() <= 2


def test_a_profile_is_followed() -> None:
    """Numbers by an sRGB profile stay; a damaged profile is passed over."""
    profile = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    np.testing.assert_array_equal(read_picture(samples.picture_bytes("PNG", icc_profile=profile)), PIXELS)
    np.testing.assert_array_equal(read_picture(samples.picture_bytes("PNG", icc_profile=b"no profile")), PIXELS)


@pytest.mark.parametrize("mode", ["L", "LA", "RGBA", "P", "1", "CMYK"])
def test_every_mode_becomes_three_channels(mode: str) -> None:
    image = Image.fromarray(PIXELS).convert(mode)
    found = io.BytesIO()
    image.save(found, "TIFF" if mode == "CMYK" else "PNG")
    assert read_picture(found.getvalue()).shape == (6, 5, 3)


def test_sixteen_bits_are_read_by_their_upper_half() -> None:
    found = io.BytesIO()
    Image.fromarray((np.arange(256, dtype=np.uint16) * 257).reshape(16, 16)).save(found, "PNG")
    np.testing.assert_array_equal(read_picture(found.getvalue())[..., 1], np.arange(256).reshape(16, 16))


def bomb(columns: int, rows: int) -> bytes:
    """A small PNG that declares many pixels."""

    def chunk(kind: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"\0" * 10**6)) + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"", "no picture, but an empty file"),
        (b"hello", "no picture, but text"),
        (samples.write_ply(), "no picture, but"),
        (bomb(20_000, 7_000), "20000 x 7000 pixels; expected 67108864"),
        (bomb(60_000, 60_000), "cannot be decoded|60000 x 60000 pixels"),
        (bomb(1_000, 1_000), "cannot be decoded"),
        (bomb(20, 6_000_000), "20 x 6000000 pixels; expected .* and 20000 a side"),
        (bomb(3_000, 3_000), "declares 3000 x 3000 pixels in"),
        (samples.picture_bytes("PNG")[:-30], "cannot be decoded|no picture"),
        (samples.picture_bytes("JPEG")[:300], "cannot be decoded"),
        (samples.HEIC[:-40], r"cannot be decoded .a picture .HEIC., damaged or cut off"),
        (samples.HEIC[:300], r"cannot be decoded .a picture .HEIC., damaged or cut off"),
        (b"\0\0\0\x18ftypqt  ", "no picture, but a film"),
    ],
)
def test_what_is_no_picture_is_refused_with_a_sentence(data: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_picture(data)
