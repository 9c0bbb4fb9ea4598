"""Limb fields from recipes: bumps on unrolled limbs."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.body.limb_field import LimbField, make_fields
from omote.model.body.limb_recipe import Bump, LimbRecipe
from omote.model.body.limbs import LIMB_PLACES, LimbSpace


def around(limb: str, angles: np.ndarray, way: float = 0.5) -> LimbSpace:
    """Rows around a limb."""
    count = len(angles)
    places = np.full(count, LIMB_PLACES[limb], np.int32)
    return LimbSpace(np.arange(count, dtype=np.int32), places, np.full(count, way), angles, np.ones(count))


RING = np.linspace(-np.pi, np.pi, 721)


def test_a_bump_has_no_step_where_the_angle_wraps() -> None:
    bump = Bump("upperarm", 0.5, angle=170.0, wide=60.0, out=0.3)
    (values,) = (field.values for field in make_fields(LimbRecipe("a", "A", (bump,)), around("upperarm.L", RING)))
    assert values[0, 0] == pytest.approx(values[-1, 0], abs=1e-6)
    assert np.abs(np.diff(values[:, 0])).max() < 0.3 * 0.03
    assert RING[values[:, 0].argmax()] == pytest.approx(np.radians(170.0))
    assert values[:, 0].max() == pytest.approx(0.3)


def test_a_pair_is_a_field_a_side_driven_by_its_own_hinge() -> None:
    bump = Bump("upperarm", 0.5, out=0.2)
    recipe = LimbRecipe("biceps", "Biceps", (bump,), pair=True, driver="elbow")
    left, right = make_fields(recipe, around("upperarm.L", RING))
    assert (left.name, left.label, left.driver) == ("bicepsLeft", "Biceps, left", "lowerarm01.L")
    assert (right.name, right.driver) == ("bicepsRight", "lowerarm01.R")
    assert np.allclose(left.values[:, 0], 0.2)
    assert not right.values.any()


def test_both_sides_of_the_trunk_mirror_each_other() -> None:
    bump = Bump("trunk", 0.5, angle=40.0, wide=30.0, out=0.1, round=5.0, both=True)
    (field,) = make_fields(LimbRecipe("a", "A", (bump,)), around("trunk", RING))
    np.testing.assert_allclose(field.values, field.values[::-1] * [1, -1, 1], atol=1e-6)
    assert field.values[:, 1].max() == pytest.approx(np.radians(5.0), rel=1e-3)


def test_values_of_another_shape_are_refused() -> None:
    with pytest.raises(ValueError, match="three for each row"):
        LimbField("a", "A", "", np.zeros((4, 2), np.float32))
