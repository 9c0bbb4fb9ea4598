"""Handles: features of the head in pairs, a basis that is the sculptor's map, and faces that stay faces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import cdist

from omote.builtin import load_cast
from omote.geometry import mesh
from omote.model.recipes.face_handles import FARTHEST_MOVE, Handle, default_handles, drag_handles, validate_rows
from omote.model.sculpting.caricature import find_folds
from omote.model.sculpting.sculpt import Sculpt, sculpted, warp
from omote.model.space.eye_socket import ball_heights, radius_of
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from tests import synthetic

CAST = load_cast()
SPACE = CAST.space
_LIPS = next(line.loop for line in SPACE.lines if line.kind == "lips")
# What closing lips and fitting the mouth bag may move.
MOUTH = ~SPACE.on_sheet | (cdist(SPACE.points, SPACE.points[_LIPS]).min(axis=1) < 0.015)
HANDLES = default_handles(SPACE)
ROWS = [handle.row for handle in HANDLES]
MIRROR = np.array([-1.0, 1.0, 1.0])
spaces = pytest.mark.parametrize("space", [SPACE, synthetic.space()], ids=["builtin", "synthetic"])
faces = pytest.mark.parametrize("name", CAST.faces)
names = st.sampled_from(sorted(CAST.faces))
seeds = st.integers(0, 9999)


def moderate(face: Face, seed: int) -> np.ndarray:
    """Moves of three handles, by a fifth of the way to the nearest other handle at most."""
    drawn = np.random.default_rng(seed)
    where = face.positions[ROWS]
    gaps = (cdist(where, where) + np.diag(np.full(len(where), np.inf))).min(axis=1)
    moves = np.zeros((len(ROWS), 3))
    for place in drawn.choice(len(ROWS), 3, replace=False):
        direction = drawn.normal(size=3)
        moves[place] = 0.2 * drawn.random() * gaps[place] * direction / np.linalg.norm(direction)
    return moves


def everything(face: Face) -> np.ndarray:
    fitted = fit(SPACE, face)
    return np.concatenate([fitted.positions, *fitted.parts.values()]).astype(np.float64)


def handle_basis(space: ParameterSpace, face: Face, rows: list[int]) -> np.ndarray:
    """How far each position follows each handle's move, (N, n): the sculptor's map around the face's own handles."""
    where = validate_rows(space, rows)
    fitted = fit(space, face)
    places = np.concatenate([fitted.positions, *(fitted.parts[name] for name in space.parts)]).astype(np.float64)
    moves = 0.001 * np.eye(len(where))[:, :, None] * [1.0, 0.0, 0.0]
    sculpts = [Sculpt("one", places[where], move, symmetric=False) for move in moves]
    return np.stack([(warp(sculpt)(places) - places)[:, 0] / 0.001 for sculpt in sculpts], axis=1)


@spaces
def test_handles_are_pairs_and_a_midline_of_the_sheet_named_as_people_do(space: ParameterSpace) -> None:
    handles = default_handles(space)
    assert len({handle.row for handle in handles}) == len({handle.label for handle in handles}) == len(handles)
    assert np.isin([handle.row for handle in handles], space.skin_triangles).all()
    for place, handle in enumerate(handles):
        image = handles[handle.mirror]
        assert image.mirror == place
        assert np.allclose(space.points[image.row], space.points[handle.row] * MIRROR, atol=1e-9)
        assert (image is handle) == (abs(space.points[handle.row, 0]) < 1e-6)
        sides = {"left": "right", "right": "left"}
        assert image.label.split() == [sides.get(word, word) for word in handle.label.split()]


def test_the_head_of_the_cast_has_sixty_of_them_and_left_is_its_own_left() -> None:
    assert len(HANDLES) == 60
    by_label = {handle.label: handle for handle in HANDLES}
    assert SPACE.points[by_label["left jaw corner"].row, 0] > 0.05
    assert SPACE.points[by_label["nose tip"].row, 2] == pytest.approx(SPACE.points[:, 2].max(), abs=1e-3)
    assert isinstance(by_label["chin"], Handle)


def test_every_handle_is_seen_from_somewhere_around_the_head() -> None:
    normals = mesh.normals(SPACE.points, SPACE.skin_triangles)
    around = np.radians(np.arange(0, 360, 30))
    views = np.stack([np.sin(around), np.zeros(len(around)), np.cos(around)], axis=1)
    corners = SPACE.points[SPACE.skin_triangles]
    for row, handle in zip(ROWS, HANDLES, strict=True):
        tip = SPACE.points[row] + 0.002 * normals[row]
        assert any(not _hidden(tip, view, corners) for view in views), handle.label


def _hidden(point: np.ndarray, direction: np.ndarray, corners: np.ndarray) -> bool:
    """Whether a ray meets one of the triangles (t, 3, 3) (Moeller and Trumbore 1997)."""
    a = corners[:, 0]
    edges = corners[:, 1:] - corners[:, :1]
    across = np.cross(direction, edges[:, 1])
    volume = (edges[:, 0] * across).sum(axis=1)
    volume[np.abs(volume) < 1e-15] = np.inf
    u = ((point - a) * across).sum(axis=1) / volume
    turned = np.cross(point - a, edges[:, 0])
    v = turned @ direction / volume
    far = (turned * edges[:, 1]).sum(axis=1) / volume
    return bool(((u >= 0) & (v >= 0) & (u + v <= 1) & (far > 0)).any())


@faces
def test_a_handle_carries_its_own_vertex_and_no_other_handle(name: str) -> None:
    assert np.allclose(handle_basis(SPACE, CAST.faces[name], ROWS)[ROWS], np.eye(len(ROWS)), atol=1e-8)


@faces
def test_moves_that_are_all_alike_move_everything_alike(name: str) -> None:
    assert np.allclose(handle_basis(SPACE, CAST.faces[name], ROWS).sum(axis=1), 1.0, atol=1e-8)


def test_a_coarse_head_has_a_basis_too() -> None:
    cast = synthetic.cast()
    rows = [handle.row for handle in default_handles(cast.space)]
    assert np.allclose(handle_basis(cast.space, cast.faces["broad"], rows).sum(axis=1), 1.0, atol=1e-8)


def test_an_affine_motion_of_the_handles_is_that_motion_of_everything() -> None:
    stretch = np.array([[1.1, 0.02, 0.0], [0.0, 0.9, 0.1], [0.0, 0.0, 1.05]])
    shift = np.array([0.0, 0.01, -0.02])
    face = CAST.faces["kaori"]
    handles = face.positions[ROWS].astype(float)
    places = everything(face)
    moved = places + handle_basis(SPACE, face, ROWS) @ (handles @ stretch + shift - handles)
    assert np.allclose(moved, places @ stretch + shift, atol=1e-8)


def test_mirrored_moves_give_the_mirrored_face() -> None:
    drawn = np.random.default_rng(1).normal(0.0, 0.003, (len(ROWS), 3))
    images = np.array([handle.mirror for handle in HANDLES])
    rows = np.array([np.linalg.norm(SPACE.points - point * MIRROR, axis=1).argmin() for point in SPACE.points])
    basis = handle_basis(SPACE, CAST.faces["generic"], ROWS)[: SPACE.vertex_count]
    assert np.allclose(basis @ (drawn[images] * MIRROR), (basis @ drawn)[rows] * MIRROR, atol=1e-7)


@given(seed=seeds, name=names)
@settings(max_examples=10)
def test_the_basis_is_the_displacement_before_eyes_and_mouth_are_put_in_order(seed: int, name: str) -> None:
    face = CAST.faces[name]
    drawn = moderate(face, seed)
    made = drag_handles(SPACE, face, "hers", rows=ROWS, moves=drawn)
    difference = everything(made) - everything(face) - handle_basis(SPACE, face, ROWS) @ drawn
    difference[: SPACE.vertex_count][MOUTH] = 0.0
    fitted = fit(SPACE, face)
    row = SPACE.vertex_count
    for part in SPACE.parts.values():
        rows = slice(row, row + len(part.points))
        row = rows.stop
        if part.eye:
            assert np.allclose(difference[rows].mean(axis=0), 0.0, atol=1e-7)
            around = ball_heights(fitted.positions, fitted.parts[part.name])
            difference[: SPACE.vertex_count][around < 1.6] = 0.0
            difference[rows] = 0.0
    assert np.abs(difference).max() < 1e-7


def test_on_the_generic_face_it_is_the_sculpt_of_the_same_points() -> None:
    face = CAST.faces["generic"]
    drawn = moderate(face, 5)
    ours = drag_handles(SPACE, face, "a", rows=ROWS, moves=drawn)
    theirs = sculpted(SPACE, Sculpt("a", SPACE.points[ROWS], drawn, symmetric=False))
    assert np.allclose(everything(ours), everything(theirs), atol=1e-6)


@faces
def test_handles_at_rest_leave_a_face_as_it_is(name: str) -> None:
    face = CAST.faces[name]
    made = drag_handles(SPACE, face, "a", rows=ROWS, moves=np.zeros((len(ROWS), 3)))
    assert np.array_equal(everything(made), everything(face))


@given(seed=seeds, name=names)
@settings(max_examples=25)
def test_handles_off_the_lids_arrive_where_they_are_put_and_moderate_moves_fold_nothing(seed: int, name: str) -> None:
    face = CAST.faces[name]
    drawn = moderate(face, seed)
    made = drag_handles(SPACE, face, "hers", rows=ROWS, moves=drawn)
    assert made.name == "hers"
    free = [place for place, handle in enumerate(HANDLES) if "lid" not in handle.label and "eye" not in handle.label]
    assert np.allclose((made.positions - face.positions)[ROWS][free], drawn[free], atol=5e-5)
    assert not find_folds(face.positions.astype(float), made.positions.astype(float), SPACE.skin_triangles).any()


def test_eyes_stay_round_and_lids_stay_on_them() -> None:
    face = CAST.faces["dog"]
    made = drag_handles(SPACE, face, "hers", rows=ROWS, moves=moderate(face, 3))
    for part in (part for part in SPACE.parts.values() if part.eye):
        before, after = (fit(SPACE, one).parts[part.name].astype(float) for one in (face, made))
        assert similar(before, after)
        rest = ball_heights(face.positions, before)
        assert np.allclose(ball_heights(made.positions, after)[rest < 1.12], rest[rest < 1.12], atol=1e-3)


def similar(before: np.ndarray, after: np.ndarray) -> bool:
    """Whether one is the other, shifted and scaled."""
    before, after = ((ball - ball.mean(axis=0)) / radius_of(ball) for ball in (before, after))
    return bool(np.allclose(before, after, atol=1e-4))


@pytest.mark.parametrize(
    ("rows", "far", "sentence"),
    [
        ([], [], "expected a list of rows"),
        ([0.5], [[0, 0, 0]], "expected a list of rows"),
        ([[1]], [[0, 0, 0]], "expected a list of rows"),
        ([ROWS[0], 999999], [[0, 0, 0]] * 2, "stands on row 999999"),
        ([ROWS[0], -1], [[0, 0, 0]] * 2, "stands on row -1"),
        ([ROWS[0], ROWS[0]], [[0, 0, 0]] * 2, f"two handles stand on row {ROWS[0]}"),
        (ROWS, [[0, 0, 0]], "60 handles and 1 moves"),
        (ROWS[:2], [[0, 0, 0], [0, 2 * FARTHEST_MOVE, 0]], "handle 1 is moved by 0.2 m"),
        (ROWS[:2], [[0, 0, 0], [0, np.nan, 0]], "expected finite numbers"),
        (ROWS[:3], [[0, 0, 0.001]] * 3, "lie in one plane"),
    ],
)
def test_what_cannot_be_dragged_is_refused_with_a_sentence(rows: Any, far: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        drag_handles(SPACE, CAST.faces["generic"], "a", rows=rows, moves=far)
