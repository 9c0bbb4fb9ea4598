"""What colours the skin in small."""

import numpy as np

from tools.baking.skin.marks import beard, freckles, fur_strands
from tools.baking.skin.texels import Texels


def test_beards_grow_around_lips_and_on_jaws_and_nowhere_above_the_nose(texels: Texels) -> None:
    places = texels.places
    grown = beard(texels)
    assert not grown[(places[:, 1] > 0.02) & (places[:, 2] > 0.1)].any() or grown[places[:, 1] > 0.02].max() < 0.01
    assert grown[texels.lip_rings < 6.0].max() == 0.0
    chin = (np.abs(places[:, 0]) < 0.01) & (np.abs(places[:, 1] + 0.1) < 0.004) & (places[:, 2] > 0.12)
    assert grown[chin].min() > 0.8


def test_freckles_lie_over_nose_and_cheeks(texels: Texels) -> None:
    places = texels.places
    found = freckles(texels)
    face = (places[:, 2] > 0.1) & (np.abs(places[:, 1] + 0.02) < 0.015)
    assert found[face].mean() > 10 * found[places[:, 1] < -0.09].mean()
    assert found[places[:, 2] < 0.0].max() == 0.0


def test_fur_is_even_in_the_mean_and_never_flat(texels: Texels) -> None:
    strands = fur_strands(texels)
    assert abs(strands.mean() - 0.5) < 0.02
    assert strands.std() > 0.1
