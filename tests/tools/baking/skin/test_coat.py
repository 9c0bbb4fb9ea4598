"""What colours the skin at large."""

import numpy as np
from scipy.spatial import KDTree

from tools.baking.skin.coat import ALWAYS, PATCH, dark_marks, make_up, mask_paint, patches
from tools.baking.skin.texels import Texels


def test_leather_lies_inside_a_patch(texels: Texels) -> None:
    """One channel holds both, so every way to the leather leads over the patch."""
    places, found = texels.places, patches(texels)
    tip = places[:, 2] > 0.166
    assert found[tip].min() > PATCH
    outer = ~texels.inner
    leather = KDTree(places[outer & (found > 0.85)])
    assert found[outer & (leather.query(places, distance_upper_bound=0.0008)[0] < 0.0008)].min() > 0.5


def test_what_every_coat_has_lies_above_the_stripes(texels: Texels) -> None:
    places, marks = texels.places, dark_marks(texels)
    assert marks[texels.lid_rings < 1.0].min() > ALWAYS
    crown = (places[:, 1] > 0.05) & (places[:, 2] > 0.08)
    assert 0.0 < marks[crown].max() <= ALWAYS


def test_make_up_is_on_the_lids_only(texels: Texels) -> None:
    found = make_up(texels)
    assert found[texels.lid_rings > 12.0].max() == 0.0
    assert found.max() > 0.8


def test_the_brows_of_a_mask_are_high_on_its_forehead(texels: Texels) -> None:
    places, found = texels.places, mask_paint(texels)
    face = (places[:, 2] > 0.12) & (np.abs(places[:, 0]) < 0.045) & (places[:, 1] < 0.068)
    painted = places[face & (found > 0.4)]
    assert painted[:, 1].min() > 0.035
    assert abs(np.abs(painted[:, 0]).mean() - 0.029) < 0.004
