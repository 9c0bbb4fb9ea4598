"""Unfolding: a triangle turned over comes back, what is good stays."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.transfer.fold_repair import NEAR, frames, nearest_turns, relax, sheet_of, turned_over

SIZE = 12


def grid() -> tuple[np.ndarray, np.ndarray]:
    row, column = np.meshgrid(np.arange(SIZE - 1), np.arange(SIZE - 1), indexing="ij")
    a = (row * SIZE + column).ravel()
    triangles = np.concatenate([np.stack([a, a + 1, a + SIZE + 1], 1), np.stack([a, a + SIZE + 1, a + SIZE], 1)])
    x, y = np.meshgrid(np.arange(SIZE, dtype=float), np.arange(SIZE, dtype=float))
    return np.stack([x.ravel(), y.ravel(), np.zeros(SIZE * SIZE)], axis=1), triangles.astype(np.int32)


def relaxed(positions: np.ndarray, held: np.ndarray) -> np.ndarray:
    points, triangles = grid()
    sheet = sheet_of(points, points, triangles)
    bad = np.empty(len(triangles), np.bool_)
    result = positions.copy()
    for _ in range(6):
        if turned_over(result, triangles, sheet.normals, bad) == 0:
            break
        relax(
            result, points, bad, held, 2, NEAR, triangles, sheet.starts, sheet.fans, sheet.gradients, sheet.plane,
            sheet.turns, sheet.source,
        )  # fmt: skip
    return result


def folded() -> np.ndarray:
    points, _ = grid()
    points[5 * SIZE + 5, 0] += 1.6
    return points


def test_a_vertex_pulled_over_its_neighbour_is_brought_back() -> None:
    points, triangles = grid()
    bad = np.empty(len(triangles), np.bool_)
    assert turned_over(folded(), triangles, sheet_of(points, points, triangles).normals, bad) > 0
    result = relaxed(folded(), np.zeros(len(points), np.bool_))
    assert turned_over(result, triangles, sheet_of(points, points, triangles).normals, bad) == 0
    far = np.linalg.norm(points - points[5 * SIZE + 5], axis=1) > 5
    assert np.array_equal(result[far], points[far])


def test_held_vertices_do_not_move() -> None:
    points, _ = grid()
    held = np.zeros(len(points), np.bool_)
    held[5 * SIZE + 5] = True
    result = relaxed(folded(), held)
    assert np.array_equal(result[held], folded()[held])


def test_the_gradients_are_exact_for_linear_maps_and_the_frames_for_the_identity() -> None:
    points, triangles = grid()
    points[:, 2] = 0.3 * points[:, 0]
    sheet = sheet_of(points, points, triangles)
    linear = np.array([[1.1, 0.2, 0.0], [-0.3, 0.9, 0.4], [0.0, 0.1, 1.2]])
    slopes = np.einsum("tkd,tkc->tdc", sheet.gradients, (points @ linear.T)[triangles])
    assert np.allclose(slopes, np.einsum("ij,tjd->tdi", linear, sheet.plane))
    assert np.allclose(sheet.turns, np.eye(3), atol=1e-9)
    assert np.allclose(frames(points, triangles) @ sheet.source, np.eye(3), atol=1e-9)


def test_the_nearest_turn_of_a_turned_stretch_is_the_turn() -> None:
    angle = 0.7
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    stretch = np.diag([2.0, 0.5, 1.5])
    assert nearest_turns((turn @ stretch)[None])[0] == pytest.approx(turn)
