"""What lies under each pixel of the skin's pictures."""

import numpy as np
from numpy.typing import NDArray

from tools.baking.skin.texels import SIZE, Texels, blob, ramp


def test_normals_look_outwards_and_places_lie_on_the_head(texels: Texels, generic: NDArray[np.float64]) -> None:
    np.testing.assert_allclose(np.linalg.norm(texels.normals, axis=1), 1.0)
    assert (texels.places >= generic.min(axis=0) - 1e-12).all()
    assert (texels.places <= generic.max(axis=0) + 1e-12).all()
    tip = texels.places[:, 2] > generic[:, 2].max() - 0.002
    assert texels.normals[tip, 2].min() > 0.5


def test_the_mouth_bag_is_inside_and_the_cheek_is_not(texels: Texels) -> None:
    front = (texels.places[:, 2] > 0.1) & (np.abs(texels.places[:, 0]) > 0.04) & (texels.places[:, 1] < -0.02)
    assert not texels.inner[front].any()
    assert texels.inner[(texels.lip_rings < 0.5) | (texels.lid_rings < 0.5)].any()


def test_islands_are_grown_by_their_own_values(texels: Texels) -> None:
    picture = texels.spread(np.stack([texels.places[:, 0], np.ones(len(texels.places))], axis=1))
    assert picture.shape == (SIZE, SIZE, 2)
    np.testing.assert_array_equal(picture[texels.covered, 0], texels.places[:, 0])
    grown = picture[..., 1] == 1.0
    assert grown.sum() > texels.covered.sum()
    assert not picture[~grown].any()


def test_a_ramp_stands_in_either_order() -> None:
    values = np.linspace(-1.0, 2.0, 31)
    np.testing.assert_allclose(ramp(values, 0.0, 1.0) + ramp(values, 1.0, 0.0), 1.0)
    assert (ramp(values, 0.0, 1.0)[values <= 0.0] == 0.0).all()


def test_a_blob_is_alike_on_both_sides_and_full_at_its_centre() -> None:
    centre = np.array([[0.03, 0.01, 0.1], [-0.03, 0.01, 0.1], [0.05, 0.01, 0.1]])
    found = blob(centre, (0.03, 0.01, 0.1), (0.02, 0.02, 0.02))
    np.testing.assert_allclose(found, [1.0, 1.0, np.exp(-1.0)])
