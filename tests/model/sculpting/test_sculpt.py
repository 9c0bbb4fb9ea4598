"""Sculpts: exact at their points, symmetric, the identity where nothing moves, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.model.sculpting.sculpt import (
    FARTHEST,
    KERNELS,
    MOST_ROUNDS,
    Brush,
    Kernel,
    Sculpt,
    apply_brushes,
    sculpted,
    warp,
)
from omote.model.space.eye_socket import radius_of
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from tests.synthetic import space

# Around the egg: brow, chin, crown, back, side, cheek.
POINTS = np.array(
    [
        [0.0, 0.05, 0.085], [0.0, -0.09, 0.07], [0.0, 0.125, 0.0], [0.0, 0.0, -0.078], [0.085, 0.0, 0.0],
        [0.04, -0.04, 0.07], [0.03, 0.07, 0.06],
    ]
)  # fmt: skip
MIRROR = np.array([-1.0, 1.0, 1.0])
kernels = pytest.mark.parametrize("kernel", KERNELS)


def moves(seed: int, size: float = 0.01) -> np.ndarray:
    drawn = np.random.default_rng(seed).normal(0.0, size, POINTS.shape)
    drawn[POINTS[:, 0] == 0, 0] = 0.0
    return drawn


def sculpt(**changes: Any) -> Sculpt:
    return Sculpt(**{"name": "a", "points": POINTS, "moves": moves(1), **changes})


@kernels
@given(seed=st.integers(0, 999))
def test_control_points_and_their_mirror_images_arrive_exactly(kernel: Kernel, seed: int) -> None:
    wanted = moves(seed)
    move = warp(sculpt(moves=wanted, kernel=kernel))
    assert np.allclose(move(POINTS), POINTS + wanted, atol=1e-9)
    assert np.allclose(move(POINTS * MIRROR), (POINTS + wanted) * MIRROR, atol=1e-9)


@kernels
def test_a_symmetric_sculpt_mirrors_all_of_space_and_keeps_the_midline(kernel: Kernel) -> None:
    move = warp(sculpt(kernel=kernel))
    where = np.random.default_rng(2).normal(0.0, 0.1, (50, 3))
    assert np.allclose(move(where * MIRROR), move(where) * MIRROR, atol=1e-9)
    assert np.allclose(move(where * [0, 1, 1])[:, 0], 0.0, atol=1e-9)


@kernels
def test_without_symmetry_only_the_points_themselves_count(kernel: Kernel) -> None:
    move = warp(sculpt(kernel=kernel, symmetric=False))
    assert np.allclose(move(POINTS), POINTS + moves(1), atol=1e-9)
    assert not np.allclose(move(POINTS[4:] * MIRROR), (POINTS + moves(1))[4:] * MIRROR, atol=1e-3)


@kernels
def test_an_affine_motion_of_the_points_is_that_motion_everywhere(kernel: Kernel) -> None:
    stretch = np.diag([1.2, 0.9, 1.1])
    shift = np.array([0.0, 0.01, -0.02])
    move = warp(sculpt(moves=POINTS @ stretch + shift - POINTS, kernel=kernel))
    where = np.random.default_rng(3).normal(0.0, 0.2, (50, 3))
    assert np.allclose(move(where), where @ stretch + shift, atol=1e-9)


def test_the_smooth_kernel_has_no_kink_at_its_points_and_the_lively_one_has() -> None:
    step = 1e-6 * np.eye(3)[:, None]
    kinks = {}
    for kernel in KERNELS:
        move = warp(sculpt(kernel=kernel))
        second = (
            move((POINTS + step).reshape(-1, 3))
            + move((POINTS - step).reshape(-1, 3))
            - 2 * np.tile(move(POINTS), (3, 1))
        )
        kinks[kernel] = float(np.abs(second).max() / 1e-6)
    assert kinks["triharmonic"] < 1e-2 < 0.1 < kinks["biharmonic"]


def test_no_moves_give_the_generic_face() -> None:
    face = sculpted(space(), sculpt(moves=np.zeros_like(POINTS)))
    assert np.allclose(face.positions, space().points, atol=1e-7)
    for name, part in space().parts.items():
        assert np.allclose(face.parts[name], part.points, atol=1e-7)


def test_skin_and_parts_go_where_the_map_carries_them_and_eyeballs_stay_round() -> None:
    made = sculpt()
    face = sculpted(space(), made)
    move = warp(made)
    for name, part in space().parts.items():
        there = move(part.points)
        if not part.eye:
            assert np.allclose(face.parts[name], there, atol=1e-7)
            continue
        ball = face.parts[name].astype(np.float64)
        assert np.allclose(ball.mean(axis=0), there.mean(axis=0), atol=1e-7)
        assert np.allclose(np.linalg.norm(ball - ball.mean(axis=0), axis=1), radius_of(there), atol=1e-6)
        assert np.isclose(radius_of(ball) / radius_of(part.points), fit(space(), face).sizes[name], atol=1e-5)
    eyes = [part.points.mean(axis=0) for part in space().parts.values() if part.eye]
    away = np.min([np.linalg.norm(space().points - eye, axis=1) for eye in eyes], axis=0) > 0.03
    assert np.allclose(face.positions[away], move(space().points)[away], atol=1e-7)


def test_teeth_are_scaled_about_their_middle_and_nothing_else_is() -> None:
    whole, small = (sculpted(space(), sculpt(teeth=scale)) for scale in (1.0, 0.8))
    teeth = whole.parts["teeth_lower"], small.parts["teeth_lower"]
    assert np.ptp(teeth[1], axis=0) == pytest.approx(0.8 * np.ptp(teeth[0], axis=0), abs=1e-7)
    assert teeth[1].mean(axis=0) == pytest.approx(teeth[0].mean(axis=0), abs=1e-6)
    assert np.array_equal(whole.positions, small.positions)
    assert np.array_equal(whole.parts["eye_left"], small.parts["eye_left"])


def test_a_base_adds_what_distinguishes_its_faces() -> None:
    broad = Face("broad", space().points * [1.2, 1.0, 1.0])
    still = np.zeros_like(POINTS)
    half = sculpted(space(), sculpt(moves=still, base={"broad": 0.5}), {"broad": broad})
    assert np.allclose(half.positions, space().points * [1.1, 1.0, 1.0], atol=1e-3)
    teeth = (fit(space(), broad).parts["teeth_lower"] + space().parts["teeth_lower"].points) / 2
    assert np.allclose(half.parts["teeth_lower"], teeth, atol=1e-6)
    with pytest.raises(ValueError, match="starts from a face 'narrow'; expected one of broad"):
        sculpted(space(), sculpt(base={"narrow": 1.0}), {"broad": broad})


def with_row(point: tuple[float, float, float], move: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> dict[str, Any]:
    return {"points": np.concatenate([POINTS, [point]]), "moves": np.concatenate([moves(1), [move]])}


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"name": ""}, "a sculpt is named ''"),
        ({"kernel": "gaussian"}, "the kernel of sculpt 'a' is 'gaussian'; expected one of 'biharmonic'"),
        ({"moves": moves(1)[:3]}, "has 7 points and 3 moves"),
        ({"moves": moves(1) * np.nan}, "moves of sculpt 'a'"),
        ({"points": POINTS + np.inf}, "points of sculpt 'a'"),
        (with_row((0.0, -0.02, 0.09), (0.01, 0.0, 0.0)), "control point 7 of sculpt 'a' leaves the midline by 0.01 m"),
        (with_row((0.04, -0.04, 0.07)), "two control points of sculpt 'a' lie at"),
        (with_row((0.00003, 0.0, 0.08)), "mirror images count"),
        ({"base": {"old": float("inf")}}, "starts from 'old' by inf; expected a finite weight"),
        ({"teeth": 0.2}, "teeth of sculpt 'a' is 0.2; expected a scale from 0.5 to 1.5"),
    ],
)
def test_what_contradicts_itself_is_refused(changes: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        sculpt(**changes)


def test_points_in_one_plane_are_refused() -> None:
    flat = POINTS * [1.0, 1.0, 0.0]
    with pytest.raises(ValueError, match="control points of sculpt 'a' lie in one plane"):
        warp(sculpt(points=flat, moves=np.zeros_like(flat)))
    with pytest.raises(ValueError, match="lie in one plane"):
        warp(sculpt(points=POINTS[:2], moves=np.zeros((2, 3))))


def test_points_far_from_the_head_are_refused() -> None:
    with pytest.raises(ValueError, match=rf"control point 7 of sculpt 'a' is 0.\d+ m from .*{FARTHEST} m"):
        sculpted(space(), sculpt(**with_row((0.0, 0.3, 0.0))))


def test_a_sculpt_that_leaves_the_axis_outside_is_refused() -> None:
    with pytest.raises(ValueError, match="outside the head"):
        sculpted(space(), sculpt(moves=np.tile([0.0, 0.0, 0.7], (len(POINTS), 1))))


def test_points_and_base_cannot_be_changed() -> None:
    made = sculpt(base={"old": 0.5})
    with pytest.raises(ValueError, match="read-only"):
        made.points[0] = 0.0
    with pytest.raises(TypeError):
        made.base["old"] = 1.0  # type: ignore[index]


SPACE = omote.load_cast().space
CHEEK = Brush((0.045, -0.04, 0.125), 0.025, 6)


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
