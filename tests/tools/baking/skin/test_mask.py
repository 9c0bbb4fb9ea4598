"""The layers of the skin as one picture."""

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_mask
from tests.pictures import read_png
from tools.baking.heads.head import Head
from tools.baking.layout import unwrap
from tools.baking.skin.mask import LAYERS
from tools.baking.skin.texels import SIZE, Texels

pytestmark = pytest.mark.long

Pictures = dict[str, NDArray[np.float64]]


@pytest.fixture(scope="module")
def pictures(texels: Texels) -> Pictures:
    """Every layer."""
    return {name: paint(texels) for name, paint in LAYERS.items()}


def test_every_layer_fills_the_layout_with_numbers_from_0_to_1(pictures: Pictures, texels: Texels) -> None:
    for name, picture in pictures.items():
        assert picture.shape == (SIZE, SIZE, 4), name
        assert (picture.min() >= 0.0, picture.max() <= 1.0) == (True, True), name
        assert np.ptp(picture[texels.covered], axis=0).min() > 0.2, name  # no channel is empty


def test_they_lie_one_below_the_other_and_are_painted_the_same_again(pictures: Pictures) -> None:
    stacked = np.concatenate([np.rint(picture * 255.0).astype(np.uint8) for picture in pictures.values()])
    np.testing.assert_array_equal(read_png(load_mask()), stacked)  # `bake` painted it, in another process


def test_colours_agree_across_the_borders_of_the_islands(
    head: Head, generic: NDArray[np.float64], pictures: Pictures
) -> None:
    """Both sides of a seam (the back of the head, the ears) show the same within a step of a texel."""
    layout = unwrap(head.skin, generic)
    pairs = np.stack([head.skin.triangles.ravel(), head.skin.uv_corners.ravel()], axis=1)
    pairs = np.unique(pairs, axis=0)
    split = [group for group in np.split(pairs[:, 1], np.flatnonzero(np.diff(pairs[:, 0])) + 1) if len(group) > 1]
    texel = np.minimum((layout * SIZE).astype(int), SIZE - 1)
    at = np.array([[texel[group[0]], texel[group[1]]] for group in split])
    height = np.array([generic[pairs[pairs[:, 1] == group[0], 0][0]] for group in split])
    bare = height[:, 2] < 0.06  # mouth and lids are seams too, where skin ends and another colour begins
    assert bare.sum() > 20
    for name in ("mask", "marks", "patches"):
        here, there = (pictures[name][at[bare, side, 1], at[bare, side, 0]] for side in (0, 1))
        assert np.median(np.abs(here - there)) < 0.05, name
