"""What colours the skin at large."""

import numpy as np

from tools.baking.skin.coat import dark_rims, leather, make_up, mask_paint
from tools.baking.skin.texels import Texels


def test_the_tip_of_the_nose_is_bare_and_the_cheeks_are_not(texels: Texels) -> None:
    places = texels.places
    found = leather(texels)
    assert found[places[:, 2] > 0.166].min() > 0.95
    assert found[np.abs(places[:, 0]) > 0.03].max() == 0.0


def test_lids_and_lips_have_dark_rims_and_nothing_far_from_them_has(texels: Texels) -> None:
    found = dark_rims(texels)
    assert found[(texels.lid_rings < 1.0) | (texels.lip_rings < 1.0)].min() > 0.95
    far = (texels.lid_rings > 9.0) & (texels.lip_rings > 9.0)
    assert found[far & (np.abs(texels.places[:, 0]) > 0.035)].max() < 0.01
    assert found[far].mean() < 0.01  # beside the eyes' inner corners some more


def test_make_up_is_on_the_lids_only(texels: Texels) -> None:
    found = make_up(texels)
    assert found[texels.lid_rings > 12.0].max() == 0.0
    assert found.max() > 0.8


def test_the_brows_of_a_mask_are_high_on_its_forehead(texels: Texels) -> None:
    places = texels.places
    found = mask_paint(texels)
    face = (places[:, 2] > 0.12) & (np.abs(places[:, 0]) < 0.045) & (places[:, 1] < 0.068)
    painted = places[face & (found > 0.4)]
    assert painted[:, 1].min() > 0.035
    assert abs(np.abs(painted[:, 0]).mean() - 0.029) < 0.004


def test_a_mask_s_hair_ends_around_its_ears(texels: Texels) -> None:
    x, y, z = np.abs(texels.places[:, 0]), texels.places[:, 1], texels.places[:, 2]
    found = mask_paint(texels)
    outer = ~texels.inner
    assert found[outer & (x > 0.078) & (y < -0.004) & (y > -0.042)].max() < 0.1  # the ears
    above = outer & (x > 0.0715) & (np.abs(y - 0.017) < 0.003) & (z > 0.025) & (z < 0.06)
    assert found[above].min() > 0.9
