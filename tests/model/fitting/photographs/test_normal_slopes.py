"""How normals change with points."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.geometry import mesh
from omote.model.fitting.photographs.skin_evidence import slope_normals

SPACE = load_cast().space
NORMALS, CHANGE = slope_normals(SPACE.points, SPACE.triangles)


def test_normals_are_those_of_the_mesh() -> None:
    assert np.abs(NORMALS - mesh.normals(SPACE.points, SPACE.triangles)).max() < 1e-9


def test_the_change_is_that_of_differences() -> None:
    moves = 1e-7 * np.random.default_rng(3).normal(size=SPACE.points.shape)
    after, before = (slope_normals(SPACE.points + way * moves, SPACE.triangles)[0] for way in (1.0, -1.0))
    assert (CHANGE @ moves.ravel()).reshape(-1, 3) == pytest.approx(0.5 * (after - before), abs=1e-6)


def test_a_move_and_another_size_change_no_normal_and_a_turn_turns_them() -> None:
    axis = np.array([0.2, 0.9, -0.4])
    for moves in (np.tile(axis, (len(SPACE.points), 1)), SPACE.points):
        assert CHANGE @ moves.ravel() == pytest.approx(0.0, abs=1e-8)
    turned = CHANGE @ np.cross(axis, SPACE.points).ravel()
    assert turned.reshape(-1, 3) == pytest.approx(np.cross(axis, NORMALS), abs=1e-8)
