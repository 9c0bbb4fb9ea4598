"""Encodes and decodes PNG pictures of 8 bits a channel as arrays: the bake's, exported textures and rendered ones."""

from __future__ import annotations

import io
from collections.abc import Collection

import numpy as np
from PIL import Image

from omote.arrays import Picture


def png_bytes(picture: Picture, /) -> bytes:
    """A PNG of a picture (rows, columns, 3 or 4); alpha is not multiplied into the colours."""
    file = io.BytesIO()
    Image.fromarray(picture).save(file, "PNG")
    return file.getvalue()


def read_png(data: bytes, /, sides: Collection[int] | None = None) -> Picture:
    """The picture (rows, columns, 3 or 4) in a PNG of 8 bits a channel; ValueError for any other.

    data: the file; sides: how many rows and columns there may be; nothing is unpacked of other pictures.
    """
    try:
        with Image.open(io.BytesIO(data), formats=["PNG"]) as image:
            if image.mode not in ("RGB", "RGBA") or (sides is not None and not set(image.size) <= set(sides)):
                raise ValueError(f"it has {image.width} x {image.height} pixels of {image.mode}")
            return np.array(image)
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise ValueError("a picture is no PNG of 8 bits and 3 or 4 channels, or of another size") from error
