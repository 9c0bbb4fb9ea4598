"""Textures of several materials in one picture: every corner keeps its pixel."""

import numpy as np

from omote.interchange.scans.atlas import PATCH, join_textures, plain_picture
from tests.interchange.scans import scan_samples as samples


def test_corners_keep_their_pixels_when_pictures_of_other_sizes_are_joined() -> None:
    one = samples.picture()
    other = samples.picture(9, 3)[:, ::-1].copy()
    of = np.arange(252) % 2
    whole, moved = join_textures([one, other], samples.texcoords(), of)
    assert whole is not None
    assert moved is not None
    at = (moved * [whole.shape[1], whole.shape[0]]).astype(int)
    seen = whole[at[..., 1], at[..., 0]]
    for number, picture in enumerate((one, other)):
        rows, columns = picture.shape[:2]
        own = np.minimum((samples.texcoords()[of == number] * [columns, rows]).astype(int), [columns - 1, rows - 1])
        np.testing.assert_array_equal(seen[of == number], picture[own[..., 1], own[..., 0]])


def test_one_picture_stays_as_it_is_and_plain_colours_alone_are_none() -> None:
    picture = samples.picture()
    uv = samples.texcoords()
    whole, moved = join_textures([picture, None], uv, np.zeros(252, np.int64))
    assert whole is picture
    assert moved is uv
    assert join_textures([plain_picture((1, 0, 0))], uv, np.zeros(252, np.int64)) == (None, None)


def test_a_plain_picture_is_encoded_and_what_is_no_number_is_black() -> None:
    np.testing.assert_array_equal(
        plain_picture((0.0, 1.0, float("nan"))), np.broadcast_to([0, 255, 0], (PATCH, PATCH, 3))
    )
