"""The layers of the skin as one picture."""

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_mask
from tests.pictures import read_png
from tools.baking.heads.head import Head
from tools.baking.layout import unwrap
from tools.baking.package import BakeError
from tools.baking.skin.mask import LAYERS, as_bytes
from tools.baking.skin.texels import SIZE, Texels

Pictures = dict[str, NDArray[np.float64]]


@pytest.fixture(scope="module")
def pictures() -> Pictures:
    """Every layer as it was baked; tests/tools/test_bake.py bakes them again."""
    layers = np.split(read_png(load_mask()) / 255.0, len(LAYERS))
    return dict(zip(LAYERS, layers, strict=True))


def test_every_layer_fills_the_layout(pictures: Pictures, texels: Texels) -> None:
    for name, picture in pictures.items():
        assert picture.shape == (SIZE, SIZE, 4), name
        assert np.ptp(picture[texels.covered], axis=0).min() > 0.2, name  # no channel is empty


@pytest.mark.parametrize("wrong", [-0.01, 1.01, float("nan")])
def test_a_number_outside_0_to_1_is_rejected(wrong: float) -> None:
    with pytest.raises(BakeError, match=f"the layer relief .*{wrong}.* expected 0 to 1"):
        as_bytes("relief", np.array([0.5, wrong]))


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
