"""Brushes: detail goes, form stays, nothing beyond the reach moves, both sides alike."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import omote
from omote.model.sculpting.smoothing_brush import MOST_ROUNDS, Brush, apply_brushes

SPACE = omote.load_cast().space
CHEEK = Brush((0.045, -0.04, 0.125), 0.025, 6)
MIRROR = np.array([-1.0, 1.0, 1.0])


def noisy() -> np.ndarray:
    return SPACE.points + np.random.default_rng(1).normal(0.0, 0.0003, SPACE.points.shape)


def test_nothing_moves_without_a_brush_or_beyond_its_reach() -> None:
    assert np.array_equal(apply_brushes(SPACE, noisy(), ()), noisy())
    reached = CHEEK.strength(SPACE.points) + CHEEK.strength(SPACE.points * MIRROR) > 0
    moved = (apply_brushes(SPACE, noisy(), (CHEEK,)) != noisy()).any(axis=1)
    assert not moved[~reached].any()
    sheet = np.isin(np.arange(len(moved)), SPACE.skin_triangles)
    assert moved[reached & sheet].mean() > 0.9


def test_a_brush_takes_detail_and_leaves_the_form() -> None:
    vertex = int(np.linalg.norm(SPACE.points - CHEEK.at, axis=1).argmin())
    bumped = np.array(SPACE.points)
    bumped[vertex] += [0.0, 0.0, 0.002]
    left = apply_brushes(SPACE, bumped, (CHEEK,)) - apply_brushes(SPACE, SPACE.points, (CHEEK,))
    assert np.abs(left).max() < 0.3 * 0.002
    assert np.linalg.norm(apply_brushes(SPACE, SPACE.points, (CHEEK,)) - SPACE.points, axis=1).max() < 0.2 * CHEEK.reach


def test_a_symmetric_brush_works_on_both_sides_and_another_on_one() -> None:
    other = np.abs(SPACE.points * MIRROR - CHEEK.at).max(axis=1) < 0.01
    assert (apply_brushes(SPACE, noisy(), (CHEEK,)) != noisy())[other].any()
    assert np.array_equal(apply_brushes(SPACE, noisy(), (CHEEK,), symmetric=False)[other], noisy()[other])


def test_its_strength_falls_softly_from_the_middle_to_the_rim() -> None:
    ray = np.array(CHEEK.at) + np.linspace(0.0, 1.2, 200)[:, None] * [CHEEK.reach, 0.0, 0.0]
    strength = CHEEK.strength(ray)
    assert strength[0] == 1.0
    assert strength[-1] == 0.0
    assert (np.diff(strength) <= 0).all()
    assert np.diff(strength).min() > -0.03


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"at": (0.0, float("nan"), 0.0)}, "expected three finite numbers"),
        ({"reach": 0.0}, r"a brush reaches 0.0 m; expected a distance above zero"),
        ({"rounds": 0}, "a brush goes 0 rounds"),
        ({"rounds": 2.5}, "a brush goes 2.5 rounds"),
        ({"rounds": MOST_ROUNDS + 1}, f"from 1 to {MOST_ROUNDS}"),
    ],
)
def test_what_is_no_brush_is_refused(changes: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        Brush(**{"at": CHEEK.at, "reach": CHEEK.reach, "rounds": CHEEK.rounds, **changes})
