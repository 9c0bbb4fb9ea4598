"""Decodes untrusted pictures (PNG, JPEG, HEIC and others) as sRGB, upright, without anything else that was in them."""

from __future__ import annotations

import io
import warnings

import numpy as np
from numpy.typing import NDArray
from pi_heif import register_heif_opener
from PIL import (
    AvifImagePlugin,
    BmpImagePlugin,
    GifImagePlugin,
    Image,
    ImageCms,
    ImageOps,
    JpegImagePlugin,
    MpoImagePlugin,
    PngImagePlugin,
    TiffImagePlugin,
    UnidentifiedImageError,
    WebPImagePlugin,
)  # fmt: skip

from omote.interchange.formats.file_content import describe_content

MOST_PIXELS = 2**26
MOST_SIDE = 20_000
"""Of one picture, and of its longer side."""
MOST_PER_BYTE = 1000
ANY_RATIO = 2**22
"""Pixels that a byte of a picture may stand for, where it has more than ANY_RATIO: only bombs hold more."""
LARGEST_PICTURE = 256 * 2**20
"""Bytes of a picture's file at most."""
_PLUGINS = (
    PngImagePlugin, JpegImagePlugin, MpoImagePlugin, WebPImagePlugin, BmpImagePlugin, GifImagePlugin, TiffImagePlugin,
    AvifImagePlugin,
)  # fmt: skip
register_heif_opener(thumbnails=False)  # HEIC, as telephones write it
FORMATS: list[str] = [
    name for name in ("PNG", "JPEG", "MPO", "WEBP", "BMP", "GIF", "TIFF", "AVIF", "HEIF") if name in Image.OPEN
]
"""What Pillow is let read: formats with a signature; a build of it may lack one."""
_DEEP = ("I;16", "I;16B", "I;16L", "I;16N", "I")


def read_picture(data: bytes, /) -> NDArray[np.uint8]:
    """The picture (height, width, 3) of a file, row 0 at the top of what people see.

    ValueError for what is no picture, is damaged or has more than 67 million pixels.
    """
    if len(data) > LARGEST_PICTURE:
        raise ValueError(f"the picture has {len(data)} bytes; expected {LARGEST_PICTURE} at most: save a smaller one")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of Pillow, about what is refused or mended here
            return _decode(data)
    except (ValueError, Image.DecompressionBombError) as error:
        if isinstance(error, _PictureError):
            raise
        raise ValueError(_damaged(data)) from error
    except Exception as error:  # decoders of other people: whatever they raise on damaged bytes, the bytes are damaged
        raise ValueError(_damaged(data)) from error


class _PictureError(ValueError):
    """A sentence of ours."""


def _damaged(data: bytes) -> str:
    return f"the picture cannot be decoded ({describe_content(data)}, damaged or cut off); save it anew as PNG or JPEG"


def write_plain(picture: NDArray[np.uint8], longest: int, /) -> bytes:
    """A picture (height, width, 3) as JPEG without anything but its pixels, its longer side no longer than `longest`
    pixels."""
    image = Image.fromarray(picture)
    image.thumbnail((longest, longest), Image.Resampling.LANCZOS)
    file = io.BytesIO()
    image.save(file, "JPEG", quality=95)
    return file.getvalue()


def _decode(data: bytes) -> NDArray[np.uint8]:
    try:
        image: Image.Image = Image.open(io.BytesIO(data), formats=FORMATS)
    except UnidentifiedImageError:
        what = describe_content(data)
        if what.startswith("a picture"):
            raise _PictureError(_damaged(data)) from None
        raise _PictureError(
            f"the file is no picture, but {what}; expected PNG, JPEG, HEIC or WebP: save it as one"
        ) from None
    columns, rows = image.size
    if not 0 < columns * rows <= MOST_PIXELS or max(columns, rows) > MOST_SIDE:
        raise _PictureError(
            f"the picture has {columns} x {rows} pixels; expected {MOST_PIXELS} in all at most, and {MOST_SIDE} a side"
            ": save a smaller one"
        )
    if columns * rows > max(ANY_RATIO, MOST_PER_BYTE * len(data)):
        raise _PictureError(f"the picture declares {columns} x {rows} pixels in {len(data)} bytes; save it again")
    image.load()
    profile = image.info.get("icc_profile")
    image = ImageOps.exif_transpose(image)
    return np.array(_to_srgb(image, profile), np.uint8)


def _to_srgb(image: Image.Image, profile: object) -> Image.Image:
    """A picture in 8 bits of sRGB; an embedded profile is followed where it can be."""
    if image.mode in _DEEP:
        numbers = np.asarray(image, np.float64)
        return Image.fromarray(np.clip(numbers / 257.0, 0, 255).astype(np.uint8)).convert("RGB")
    if isinstance(profile, bytes) and image.mode in ("RGB", "L", "CMYK"):
        try:
            source = ImageCms.ImageCmsProfile(io.BytesIO(profile))
            converted = ImageCms.profileToProfile(image, source, ImageCms.createProfile("sRGB"), outputMode="RGB")
        except (ImageCms.PyCMSError, OSError, ValueError):
            converted = None  # a profile of another kind than the picture, or damaged
        if converted is not None:
            return converted
    return image.convert("RGB")
