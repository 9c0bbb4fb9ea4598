"""Strands grow the same on every bake, from the scalp to their tips, and shade each other."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import cKDTree

from omote.builtin import load_cast
from omote.model.hair import LINKS
from tests import synthetic
from tools.baking.hair.groom import FINEST, STATIONS, fullness_of, roots_of, within
from tools.baking.hair.strands import find_anchors, grow_style
from tools.baking.hair.styles import GROOMS

SPACE = load_cast().space
SKIN, _ = synthetic.head()


def test_the_same_hair_grows_on_every_bake() -> None:
    name, groom = next(iter(GROOMS.items()))
    grown = grow_style(name, groom, SPACE)
    for what in ("points", "rows", "weights", "anchors", "facing", "light", "fullness"):
        assert np.array_equal(getattr(grown, what), getattr(load_cast().hair[name], what)), what


@pytest.mark.parametrize("name", GROOMS)
def test_hair_grows_above_its_hairline(name: str) -> None:
    roots = roots_of(GROOMS[name], SPACE.points, SPACE.triangles)
    assert roots.shape == (GROOMS[name].count, 3)
    assert within(GROOMS[name], roots).min() > -0.01


@pytest.mark.parametrize("name", GROOMS)
def test_hair_is_finest_at_its_edges(name: str) -> None:
    groom = GROOMS[name]
    roots = roots_of(groom, SPACE.points, SPACE.triangles)
    inside = within(groom, roots)
    fullness = fullness_of(groom, roots)
    assert fullness[inside > groom.sparse] == pytest.approx(1.0)
    assert fullness[inside <= 0.0] == pytest.approx(FINEST)
    assert (np.diff(fullness[np.argsort(inside)]) >= -1e-12).all()


@pytest.mark.parametrize("name", GROOMS)
def test_strands_are_smooth_and_lie_in_the_light(name: str) -> None:
    hair = load_cast().hair[name]
    bound = sum(one.count for one in GROOMS[name].bound)
    assert hair.points.shape == (GROOMS[name].count + bound, STATIONS, 3)
    steps = np.linalg.norm(np.diff(hair.points, axis=1), axis=2)
    assert 0.0 < steps.max() < 0.05
    assert ((hair.light > 0.0) & (hair.light <= 1.0)).all()
    assert np.linalg.norm(hair.facing, axis=-1) == pytest.approx(1.0, abs=2e-3)


def test_neighbours_of_a_lock_are_combed_alike() -> None:
    groom = replace(GROOMS["mop"], count=900)
    roots = roots_of(groom, SPACE.points, SPACE.triangles)
    _, near = cKDTree(roots).query(roots, k=2)

    def turned_away(locks: float) -> float:
        strands = grow_style("mop", replace(groom, locks=locks), SPACE).points
        ways = strands[:, -1] - strands[:, 0]
        ways /= np.linalg.norm(ways, axis=1, keepdims=True)
        return float(np.median(1.0 - (ways * ways[near[:, 1]]).sum(axis=1)))

    assert turned_away(0.8) < turned_away(0.0)


def test_only_allowed_vertices_carry_with_weights_that_sum_to_one() -> None:
    noise = np.random.default_rng(4).normal(0.0, 0.01, SKIN.shape)
    rows, weights = find_anchors(SKIN + noise, SKIN, SKIN[:, 1] > 0.0)
    assert rows.shape == weights.shape == (len(SKIN), LINKS)
    assert (SKIN[rows][..., 1] > 0.0).all()
    assert (weights >= 0.0).all()
    assert weights.sum(axis=-1) == pytest.approx(1.0)


def test_a_place_on_a_vertex_is_carried_by_it_alone() -> None:
    rows, weights = find_anchors(SKIN[3:4], SKIN, np.ones(len(SKIN), bool))
    assert rows[0, 0] == 3
    assert weights[0, 0] == pytest.approx(1.0, abs=1e-3)
