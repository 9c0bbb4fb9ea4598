"""Regions: weights sum to one over the whole head, each owns its feature, nothing jumps."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.space.head_regions import REGIONS, check_region, region_mask, region_weights

CAST = omote.load_cast()


def test_the_regions_share_every_point_and_sum_to_one() -> None:
    for points in (None, np.random.default_rng(1).normal(0.0, 0.3, (500, 3))):
        weights = np.stack(list(region_weights(CAST.space, points).values()))
        assert (weights >= 0).all()
        assert np.allclose(weights.sum(axis=0), 1.0)


def test_every_region_owns_its_feature_and_both_sides_alike() -> None:
    features = {
        "brows": (0.03, 0.026, 0.145), "eyes": (0.031, 0.004, 0.141), "nose": (0.0, -0.036, 0.168),
        "cheeks": (0.045, -0.04, 0.125), "mouth": (0.0, -0.066, 0.155), "jaw": (0.0, -0.1, 0.148),
        "ears": (0.085, -0.004, 0.035), "skull": (0.0, 0.1, 0.0),
    }  # fmt: skip
    for name, point in features.items():
        both = np.array([point, np.multiply(point, [-1, 1, 1])])
        weights = {str(region): row for region, row in region_weights(CAST.space, both).items()}
        assert weights[name][0] > 0.5, name
        assert max(weights, key=lambda region: float(weights[region][0])) == name
        for row in weights.values():
            assert np.isclose(row[0], row[1], atol=1e-3)


def test_weights_change_smoothly_over_the_skin() -> None:
    a, b = CAST.space.triangles[:, :2].T
    length = np.linalg.norm(CAST.space.points[a] - CAST.space.points[b], axis=1)
    for region, row in region_weights(CAST.space).items():
        assert (np.abs(row[a] - row[b]) <= length / 0.004).all(), region  # the steepest border is 4 mm wide


def test_a_mask_holds_parts_by_where_they_lie_and_eyeballs_with_the_eyes_alone() -> None:
    for region in REGIONS:
        mask = region_mask(CAST.space, region)
        assert region_mask(CAST.space, region) is mask
        eyes = 1.0 if region == "eyes" else 0.0
        assert (mask.eyes == eyes).all()
        assert (mask.parts["eye_left"] == eyes).all()
    assert region_mask(CAST.space, "mouth").parts["teeth_upper"].mean() > 0.4


def test_a_region_that_is_none_is_rejected() -> None:
    assert check_region("ears") == "ears"
    with pytest.raises(ValueError, match="there is no region 'tail'; expected some of brows"):
        check_region("tail")
