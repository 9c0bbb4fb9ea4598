"""The coats of fur: a hound's and a tabby's."""

import numpy as np

from tools.baking.skin.pelt import hound_dark, hound_pale, paint_pelt, tabby_dark, tabby_pale
from tools.baking.skin.texels import Texels


def test_a_hound_has_a_pale_muzzle_and_blaze_and_dark_ears(texels: Texels) -> None:
    places = texels.places
    pale = hound_pale(texels)
    dark = hound_dark(texels)
    outer = ~texels.inner
    lip = outer & (np.abs(places[:, 0]) < 0.01) & (np.abs(places[:, 1] + 0.058) < 0.004) & (places[:, 2] > 0.14)
    blaze = outer & (np.abs(places[:, 0]) < 0.002) & (np.abs(places[:, 1] - 0.03) < 0.01) & (places[:, 2] > 0.12)
    ear = outer & (np.abs(places[:, 0]) > 0.078)
    cheek = outer & (np.abs(np.abs(places[:, 0]) - 0.055) < 0.004) & (np.abs(places[:, 1] + 0.02) < 0.005)
    assert min(pale[lip].mean(), pale[blaze].mean()) > 0.9
    assert dark[ear].min() > 0.5
    assert max(pale[cheek & (places[:, 2] > 0.08)].max(), dark[cheek & (places[:, 2] > 0.08)].max()) < 0.1


def test_a_tabby_wears_an_m_and_a_streak_over_each_eye(texels: Texels) -> None:
    places = texels.places
    pale = tabby_pale(texels)
    dark = tabby_dark(texels)
    forehead = ~texels.inner & (np.abs(places[:, 0]) < 0.035) & (places[:, 1] > 0.026) & (places[:, 1] < 0.055)
    forehead &= places[:, 2] > 0.11
    x = np.abs(places[:, 0])
    assert pale[forehead & (places[:, 1] > 0.034)].max() < 0.1  # a hound's blaze and spots are not the cat's
    streak = forehead & (np.abs(places[:, 1] - 0.0265) < 0.001) & (np.abs(x - 0.023) < 0.002)
    assert 0.3 < pale[streak].mean() < 0.9
    at_40 = forehead & (np.abs(places[:, 1] - 0.040) < 0.001)
    assert dark[at_40 & (np.abs(x - 0.006) < 0.001)].mean() > 0.5  # the inner stroke of the M
    assert dark[at_40 & (np.abs(x - 0.0214) < 0.001)].mean() > 0.5  # the outer one
    assert dark[at_40 & (np.abs(x - 0.0135) < 0.002)].max() < 0.3  # between them


def test_an_inner_ear_is_pale_and_its_back_dark_on_a_tabby(texels: Texels) -> None:
    places = texels.places
    out = texels.normals[:, 0] * np.sign(places[:, 0])
    ear = ~texels.inner & (np.abs(places[:, 0]) > 0.076) & (places[:, 1] > -0.04) & (places[:, 1] < 0.02)
    assert tabby_pale(texels)[ear & (out > 0.6)].mean() > 0.6
    assert tabby_dark(texels)[ear & (out > 0.2)].max() < 0.3
    assert tabby_dark(texels)[ear & (out < -0.3)].mean() > 0.5


def test_both_coats_are_alike_on_both_sides_and_leave_the_inner_skin_alone(texels: Texels) -> None:
    picture = paint_pelt(texels)
    assert picture.shape[2] == 4
    assert 0.0 <= picture.min() <= picture.max() <= 1.0
    assert not picture[texels.covered][texels.inner].any()


def test_spots_over_eyes_are_fur_that_fades_and_never_whole(texels: Texels) -> None:
    x, y, z = np.abs(texels.places[:, 0]), texels.places[:, 1], texels.places[:, 2]
    for pale in (hound_pale(texels), tabby_pale(texels)):
        spot = pale[~texels.inner & (x > 0.013) & (x < 0.036) & (y > 0.018) & (y < 0.036) & (z > 0.11)]
        assert 0.3 < spot.max() < 0.7
        fading = ((spot > 0.05) & (spot < 0.8 * spot.max())).sum()
        assert fading > (spot >= 0.8 * spot.max()).sum()
