"""Lines of age."""

import numpy as np

from tools.baking.skin.texels import Texels
from tools.baking.skin.wrinkles import fine_net, lines_of_age, spots_of_age


def test_lines_are_grooves_where_age_draws_them(texels: Texels) -> None:
    depth, crease = lines_of_age(texels)
    places = texels.places
    fold = (
        (np.abs(np.abs(places[:, 0]) - 0.0295) < 0.001) & (np.abs(places[:, 1] + 0.054) < 0.002) & (places[:, 2] > 0.1)
    )
    tip = (np.abs(places[:, 0]) < 0.006) & (np.abs(places[:, 1] + 0.03) < 0.005) & (places[:, 2] > 0.15)
    assert fold.any()
    assert tip.any()
    assert depth[fold].mean() > 0.0002
    assert np.abs(depth[tip]).max() == crease[tip].max() == 0.0
    assert (crease.min(), crease.max() <= 1.0) == (0.0, True)


def test_nothing_is_deeper_than_a_millimetre(texels: Texels) -> None:
    assert np.abs(lines_of_age(texels)[0]).max() < 0.002
    assert np.abs(fine_net(texels)).max() < 0.0005


def test_spots_are_few_and_leave_the_nose(texels: Texels) -> None:
    spots = spots_of_age(texels)
    assert 0.0 < (spots > 0.5).mean() < 0.05
    nose = (np.abs(texels.places[:, 0]) < 0.01) & (np.abs(texels.places[:, 1] + 0.03) < 0.01)
    assert not spots[nose].any()
