"""A suit spans the trunk and rounds off toes, and leaves hands, face and the join at the neck as they are."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.builtin import load_figures
from omote.geometry import mesh
from omote.interchange.figures.suit import LEATHER, ROLL, suit_parts, wear_suit

CAST = omote.load_cast()
FIGURES = load_figures()
SPACE = FIGURES.space
FIRST = FIGURES.bodies["generic"]
SUIT = FIGURES.garments["suit"]
PARTS = suit_parts(SPACE, FIRST, CAST.space.points, SUIT)
HAND = SUIT.cover < 0.0
HAND[SPACE.first_of_skirt :] = False


@pytest.mark.parametrize("name", ["generic", "heavy", "dog"])
def test_a_suit_smooths_the_trunk_and_keeps_its_volume_and_all_else(name: str) -> None:
    body = FIGURES.bodies[name]
    worn = wear_suit(SPACE, FIRST, body)
    moved = np.linalg.norm(worn.positions - body.positions, axis=1)
    assert not moved[HAND[SPACE.head_rows :]].any()
    assert not moved[SPACE.first_of_skirt - SPACE.head_rows :].any()
    assert not moved[SPACE.joined].any()
    assert 0.002 < moved.max() < 0.08
    inner = (SPACE.triangles >= SPACE.head_rows).all(axis=1)
    corners = SPACE.triangles[inner] - SPACE.head_rows

    def volume(points: np.ndarray) -> float:
        a, b, c = points[corners].astype(np.float64).swapaxes(0, 1)
        return float((a * np.cross(b, c)).sum() / 6.0)

    assert volume(worn.positions) == pytest.approx(volume(body.positions), rel=0.03)
    spread = [mesh.areas(points.astype(np.float64), corners).sum() for points in (body.positions, worn.positions)]
    assert spread[1] < spread[0]  # relief is spanned
    np.testing.assert_array_equal(worn.joints, body.joints)


def test_cloth_lies_on_the_body_thicker_on_shoes_and_not_on_hands() -> None:
    assert (PARTS.cloth[SUIT.cover < -0.02] == 0.0).all()
    assert PARTS.cloth.max() == pytest.approx(SUIT.thick.max() + LEATHER)
    assert (PARTS.cloth[PARTS.height > ROLL] <= 0.25 * SUIT.thick.max() + 1e-12).all()
    assert (PARTS.height[: SPACE.head_rows] > -0.02).all()
    np.testing.assert_allclose(PARTS.height[SPACE.rim_rows].mean(), 0.0, atol=1e-6)
