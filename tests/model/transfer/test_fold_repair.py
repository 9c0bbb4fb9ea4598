"""Fold repair: a triangle turned over comes back, what is good stays."""

from __future__ import annotations

import numpy as np
import pytest

from omote.geometry.orientation import area_shares, rest_normals
from omote.model.transfer.fold_repair import (
    LAST_ROUNDS,
    NEAR,
    ROUNDED,
    build_sheet_geometry,
    find_folds,
    nearest_rotations,
    relax_patches,
    repair,
    repair_patch,
    triangle_frames,
)

SIZE = 12


def grid() -> tuple[np.ndarray, np.ndarray]:
    row, column = np.meshgrid(np.arange(SIZE - 1), np.arange(SIZE - 1), indexing="ij")
    a = (row * SIZE + column).ravel()
    triangles = np.concatenate([np.stack([a, a + 1, a + SIZE + 1], 1), np.stack([a, a + SIZE + 1, a + SIZE], 1)])
    x, y = np.meshgrid(np.arange(SIZE, dtype=float), np.arange(SIZE, dtype=float))
    return np.stack([x.ravel(), y.ravel(), np.zeros(SIZE * SIZE)], axis=1), triangles.astype(np.int32)


def folds_of(positions: np.ndarray) -> np.ndarray:
    points, triangles = grid()
    return find_folds(build_sheet_geometry(points, points, triangles), positions, points)


def relaxed(positions: np.ndarray, held: np.ndarray) -> np.ndarray:
    points, triangles = grid()
    sheet = build_sheet_geometry(points, points, triangles)
    result = positions.copy()
    for _ in range(6):
        if not (bad := folds_of(result)).any():
            break
        relax_patches(sheet, result, points, bad, held, 2, NEAR)
    return result


def folded() -> np.ndarray:
    points, _ = grid()
    points[5 * SIZE + 5, 0] += 1.6
    return points


def test_a_vertex_pulled_over_its_neighbour_is_brought_back() -> None:
    points, _ = grid()
    assert folds_of(folded()).any()
    result = relaxed(folded(), np.zeros(len(points), np.bool_))
    assert not folds_of(result).any()
    far = np.linalg.norm(points - points[5 * SIZE + 5], axis=1) > 5
    assert np.array_equal(result[far], points[far])


def test_repair_gives_back_what_folds_nowhere_and_closes_the_lines_only_once_they_move() -> None:
    points, triangles = grid()
    sheet = build_sheet_geometry(points, points, triangles)
    closed = list[int]()
    on_line = np.zeros(len(points), np.bool_)
    assert repair(sheet, points, points, on_line, lambda sheet: closed.append(1)) is points
    on_line[:] = True  # nothing may move until the lines are free
    result = repair(sheet, folded(), points, on_line, lambda sheet: closed.append(1))
    assert closed
    assert not folds_of(result).any()


def test_a_triangle_with_next_to_no_area_gets_what_single_precision_can_keep() -> None:
    points, triangles = grid()
    sheet = build_sheet_geometry(points, points, triangles)
    worn = grid()[0]
    worn[5 * SIZE + 5, 0] += 1.0 - 1e-6  # two triangles keep a millionth
    assert not folds_of(worn).any()
    result = repair(sheet, worn, points, np.zeros(len(points), np.bool_), lambda sheet: None)
    normals, sizes = rest_normals(points, triangles)
    assert area_shares(worn, normals, sizes, triangles).min() < ROUNDED
    assert area_shares(result, normals, sizes, triangles).min() >= ROUNDED
    assert not folds_of(result.astype(np.float32).astype(np.float64)).any()


def test_folded_triangles_are_turned_upright_and_those_of_the_source_stay() -> None:
    points, triangles = grid()
    sheet = build_sheet_geometry(points, points, triangles)
    positions = folded()
    bad = find_folds(sheet, positions, points)
    for _ in range(LAST_ROUNDS):
        repair_patch(sheet, positions, points, find_folds(sheet, positions, points))
    assert bad.any()
    assert not find_folds(sheet, positions, points).any()
    far = np.linalg.norm(points - points[5 * SIZE + 5], axis=1) > 5
    assert np.array_equal(positions[far], points[far])
    same = folded()
    repair_patch(sheet, same, folded(), find_folds(sheet, folded(), folded()))
    assert np.array_equal(same, folded())


def test_held_vertices_do_not_move() -> None:
    points, _ = grid()
    held = np.zeros(len(points), np.bool_)
    held[5 * SIZE + 5] = True
    result = relaxed(folded(), held)
    assert np.array_equal(result[held], folded()[held])


def test_the_gradients_are_exact_for_linear_maps_and_the_frames_for_the_identity() -> None:
    points, triangles = grid()
    points[:, 2] = 0.3 * points[:, 0]
    sheet = build_sheet_geometry(points, points, triangles)
    linear = np.array([[1.1, 0.2, 0.0], [-0.3, 0.9, 0.4], [0.0, 0.1, 1.2]])
    slopes = np.einsum("tkd,tkc->tdc", sheet.gradients, (points @ linear.T)[triangles])
    assert np.allclose(slopes, np.einsum("ij,tjd->tdi", linear, sheet.plane))
    assert np.allclose(sheet.rotations, np.eye(3), atol=1e-9)
    assert np.allclose(triangle_frames(points, triangles) @ sheet.inverse_frames, np.eye(3), atol=1e-9)


def test_the_nearest_turn_of_a_turned_stretch_is_the_turn() -> None:
    angle = 0.7
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    stretch = np.diag([2.0, 0.5, 1.5])
    assert nearest_rotations((turn @ stretch)[None])[0] == pytest.approx(turn)
