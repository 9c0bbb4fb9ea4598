"""Limbs unrolled: what lies ahead, outward and on the other side, and rows that fields move."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from omote.builtin import load_figures
from omote.model.body.limbs import LIMB_PLACES, LIMBS, LimbSpace, limb_axes, limb_moves, unroll_limbs
from omote.model.body.stand import stand_turns

FIGURES = load_figures()
SPACE = FIGURES.limbs
GENERIC = FIGURES.bodies["generic"]
ROWS = np.concatenate([np.zeros((FIGURES.space.head_rows, 3)), GENERIC.positions])
AXES = limb_axes(FIGURES.space.skeleton, GENERIC.joints.astype(np.float64))


@pytest.mark.parametrize("limb", LIMBS, ids=lambda limb: limb.name)
def test_angles_count_outward_from_ahead_in_the_stand(limb: tuple[str, ...]) -> None:
    stand = stand_turns(FIGURES.space.skeleton, GENERIC.joints.astype(float), GENERIC.ends.astype(float))
    name, begin = limb[:2]
    inner = (SPACE.limbs == LIMB_PLACES[name]) & (SPACE.ways > 0.2) & (SPACE.ways < 0.8)
    turned = ROWS[SPACE.rows[inner]] @ stand[FIGURES.space.skeleton.places[begin]].T
    off = turned - turned.mean(axis=0)
    angles = SPACE.angles[inner]
    ahead = off[np.abs(angles) < 0.5].mean(axis=0)
    outward = off[np.abs(angles - np.pi / 2) < 0.5].mean(axis=0) * (-1.0 if name.endswith(".R") else 1.0)
    assert ahead[2] > 0.9 * np.linalg.norm(ahead) or ahead[2] > 0.02
    assert outward[0] > 0.02


def test_both_sides_have_the_same_coordinates() -> None:
    left, right = (np.isin(SPACE.limbs, [LIMB_PLACES[limb.name] for limb in LIMBS if limb.name[-2:] == side])
                   for side in (".L", ".R"))  # fmt: skip
    away, nearest = cKDTree(ROWS[SPACE.rows[right]] * [-1, 1, 1]).query(ROWS[SPACE.rows[left]])
    same = away < 1e-4
    assert same.mean() > 0.95
    for what in (SPACE.ways, np.cos(SPACE.angles), np.sin(SPACE.angles), SPACE.shares):
        np.testing.assert_allclose(what[left][same], what[right][nearest[same]], atol=5e-3)


def test_a_field_of_ones_moves_rows_out_round_and_along() -> None:
    """Out by the radius is twice as far from the axis, round is along its cylinder, along is one limb farther."""
    count = len(SPACE.rows)
    begin = AXES.begins[SPACE.limbs]
    way = AXES.ways[SPACE.limbs]
    off = ROWS[SPACE.rows] - begin - SPACE.ways[:, None] * way
    out, turned, along = (limb_moves(SPACE, AXES, ROWS, np.tile(one, (count, 1))) for one in np.eye(3))
    np.testing.assert_allclose(out, off)
    np.testing.assert_allclose(along, way)
    np.testing.assert_allclose((turned * off).sum(axis=1), 0.0, atol=1e-9)
    np.testing.assert_allclose((turned * way).sum(axis=1), 0.0, atol=1e-9)
    np.testing.assert_allclose((off * way).sum(axis=1), 0.0, atol=1e-6)  # the generic's own ways stand on its axes


def test_round_turns_the_way_that_angles_grow() -> None:
    small = 1e-3
    moves = limb_moves(SPACE, AXES, ROWS, np.tile([0.0, small, 0.0], (len(SPACE.rows), 1)))
    rows = ROWS.copy()
    rows[SPACE.rows] += moves
    body = type(GENERIC)("turned", rows[FIGURES.space.head_rows :], GENERIC.edge, GENERIC.joints, GENERIC.ends)
    grown = unroll_limbs(FIGURES.space, body).angles - SPACE.angles
    np.testing.assert_allclose(np.median(grown), small, rtol=1e-3)
    assert (np.abs(grown - small) < 1e-4).mean() > 0.99


def test_limbs_of_other_lengths_are_refused() -> None:
    with pytest.raises(ValueError, match="ways of limbs"):
        LimbSpace(SPACE.rows, SPACE.limbs, SPACE.ways[1:], SPACE.angles, SPACE.shares)
