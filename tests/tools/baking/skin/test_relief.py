"""Fine relief as slopes."""

import numpy as np

from tools.baking.skin.relief import coarseness, paint_relief, slopes
from tools.baking.skin.texels import Texels


def test_a_ramp_has_its_slope_everywhere_and_a_level_has_none(texels: Texels) -> None:
    """The rise per way: a height that grows by a tenth of x tilts the skin by a tenth where the skin faces ahead."""
    assert not slopes(texels, np.ones(len(texels.places))).any()
    found = slopes(texels, 0.1 * texels.places[:, 0])[texels.covered]
    ahead = (texels.normals[:, 2] > 0.97) & (np.abs(texels.places[:, 1] - 0.04) < 0.02)
    assert ahead.any()
    np.testing.assert_allclose(np.median(found[ahead], axis=0), [0.1, 0.0], atol=0.01)


def test_the_inside_of_the_mouth_is_level(texels: Texels) -> None:
    relief = paint_relief(texels)[texels.covered][texels.inner]
    assert (relief == 0.5).mean() > 0.95  # but for the island's border


def test_pores_are_coarse_on_the_nose_and_fine_on_the_neck() -> None:
    nose, neck = coarseness(np.array([[0.008, -0.03, 0.155], [0.03, -0.13, 0.05]]))
    assert (nose, round(neck, 3)) == (1.0, 0.3)
