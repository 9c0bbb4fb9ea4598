"""Detail: nothing changes on the source, elsewhere the gradients come nearer to its own, far away nothing moves."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.detail_transfer import LENGTH, TOLERANCE, DetailSolver, factor_detail, solve_detail
from omote.model.transfer.fold_repair import SheetGeometry, build_sheet_geometry, triangle_frames

UNITS = ("jawOpen", "eyeBlinkLeft", "mouthFunnel")
ONES = np.ones(omote.load_cast().space.vertex_count)


def sheet(positions: np.ndarray) -> SheetGeometry:
    space = omote.load_cast().space
    return build_sheet_geometry(space.points, positions, space.sheet_triangles)


def displacement(name: str) -> np.ndarray:
    cast = omote.load_cast()
    return compound(cast.space, cast.faces["generic"], cast.expressions[name]).astype(np.float64) - cast.space.points


@pytest.fixture(scope="module")
def generic() -> DetailSolver:
    return factor_detail(sheet(omote.load_cast().space.points))


@pytest.fixture(scope="module")
def baby() -> DetailSolver:
    return factor_detail(sheet(omote.load_cast().faces["baby"].positions.astype(np.float64)))


@pytest.mark.parametrize("unit", UNITS)
def test_on_the_source_itself_nothing_changes(generic: DetailSolver, unit: str) -> None:
    moved = displacement(unit)
    assert np.abs(solve_detail(generic, moved, omote.load_cast().space.points + moved, ONES) - moved).max() < 1e-9


def test_a_shift_of_the_whole_face_stays_a_shift(baby: DetailSolver) -> None:
    points = omote.load_cast().space.points
    shift = np.broadcast_to([0.01, -0.02, 0.005], points.shape)
    assert np.abs(solve_detail(baby, shift, points + shift, ONES) - shift).max() < 1e-9


def test_a_larger_displacement_has_larger_detail(generic: DetailSolver) -> None:
    moved = displacement("jawOpen")
    worn = solve_detail(generic, moved, omote.load_cast().space.points + moved, 1.5 * ONES)
    assert np.abs(worn - 1.5 * moved).max() < 1e-9


@pytest.mark.parametrize("unit", UNITS)
def test_of_what_gradients_miss_beyond_the_tolerance_much_is_made_up_and_more_by_no_share_of_it(
    baby: DetailSolver, unit: str
) -> None:
    points, moved = omote.load_cast().space.points, displacement(unit)
    worn = solve_detail(baby, moved, points + moved, ONES)
    wanted = triangle_frames(points + moved, baby.geometry.triangles) @ baby.geometry.inverse_frames - np.eye(3)
    wanted = (wanted @ baby.geometry.plane).transpose(2, 0, 1).reshape(-1, 3)

    def excess(displacement: np.ndarray) -> float:
        missing = (wanted - baby.slopes @ displacement[baby.used]).reshape(2, -1, 3)
        beyond = np.maximum(np.sqrt((missing**2).sum(axis=(0, 2))) - TOLERANCE, 0.0)
        return float(baby.areas[: len(beyond)] @ beyond**2)

    assert excess(worn) < 0.6 * excess(moved)

    def energy(change: np.ndarray) -> float:
        """What the screened Poisson equation makes least: gradients missed, and the change itself beyond LENGTH."""
        missing = (wanted - baby.slopes @ moved[baby.used]).reshape(2, -1, 3)
        size = np.sqrt((missing**2).sum(axis=(0, 2)))
        asked = missing * np.maximum(1.0 - TOLERANCE / np.maximum(size, 1e-12), 0.0)[:, None]
        off = (asked.reshape(-1, 3) - baby.slopes @ change[baby.used]) ** 2
        corners = np.repeat(baby.areas[: len(size)] / 3.0, 3)
        mass = np.bincount(baby.geometry.triangles.ravel(), corners, minlength=len(change))
        return float((baby.areas @ off).sum() + (mass @ change**2).sum() / LENGTH**2)

    least = energy(worn - moved)
    assert all(least < energy(share * (worn - moved)) for share in (0.0, 0.5, 0.9, 1.1))


def test_the_change_dies_out_within_centimetres(baby: DetailSolver) -> None:
    cast, moved = omote.load_cast(), displacement("eyeBlinkLeft")
    change = np.linalg.norm(solve_detail(baby, moved, cast.space.points + moved, ONES) - moved, axis=1)
    still = cast.space.points[np.linalg.norm(moved, axis=1) > 1e-6]
    far = np.linalg.norm(cast.space.points[:, None] - still[None, ::8], axis=2).min(axis=1) > 0.05
    assert change.max() > 1e-4
    assert change[far].max() < 1e-7
