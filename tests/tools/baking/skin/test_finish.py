"""How the skin takes light."""

import numpy as np

from tools.baking.skin.finish import hollows, mottling, oil, thinness
from tools.baking.skin.texels import Texels


def test_ears_are_thin_and_the_skull_is_not(texels: Texels) -> None:
    found = thinness(texels)
    assert found[np.abs(texels.places[:, 0]) > 0.08].min() == 1.0
    assert found[(texels.places[:, 1] > 0.06) & (np.abs(texels.places[:, 0]) < 0.06)].max() < 0.2


def test_the_nose_is_oilier_than_the_neck(texels: Texels) -> None:
    found = oil(texels)
    places = texels.places
    nose = (places[:, 2] > 0.15) & (np.abs(places[:, 1] + 0.025) < 0.01)
    assert found[nose].mean() > 2 * found[places[:, 1] < -0.11].mean()


def test_hollows_and_mottling_stay_in_range(texels: Texels) -> None:
    for found in (hollows(texels), mottling(texels)):
        assert (found.min() >= 0.0, found.max() <= 1.0) == (True, True)
    assert abs(mottling(texels).mean() - 0.5) < 0.05
