"""The smooth map: the source itself unchanged, lids closed as far as on the source, nothing folded, on every face."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.fold_repair import SheetGeometry, build_sheet_geometry, find_folds, triangle_frames
from omote.model.transfer.pipeline import apply_smooth_map
from omote.model.transfer.smooth_map import (
    LENGTH,
    TOLERANCE,
    DetailSolver,
    SmoothMap,
    factor_detail,
    prepare_smooth_map,
    solve_detail,
)

BLINKS = {"eyeBlinkLeft": 0, "eyeBlinkRight": 1}
LIDS = [*BLINKS.items(), ("eyeWideRight", 1), ("eye-left-closure", 0), ("eye-right-closure", 1)]
UNITS = ("jawOpen", "mouthSmileLeft", "mouthFunnel", "mouthClose", "browInnerUp", "cheekPuff", *BLINKS)


@pytest.fixture(scope="module")
def maps() -> dict[str, SmoothMap]:
    cast = omote.load_cast()
    return {name: prepare_smooth_map(cast.space, face) for name, face in cast.faces.items()}


def sheet_of(name: str, moved: np.ndarray) -> np.ndarray:
    """The sheet of a face of the cast moved as the generic face is."""
    cast = omote.load_cast()
    return apply_smooth_map(cast.space, cast.faces[name], moved)


def displacement(name: str) -> np.ndarray:
    cast = omote.load_cast()
    worn = compound(cast.space, cast.faces["generic"], cast.expressions[name])
    return worn.astype(np.float64) - cast.space.points


@pytest.mark.parametrize("unit", UNITS)
def test_the_source_face_wears_its_own_expression_unchanged(maps: dict[str, SmoothMap], unit: str) -> None:
    moved = displacement(unit)
    assert np.abs(sheet_of("generic", moved) - maps["generic"].positions - moved).max() < 1e-6


@pytest.mark.parametrize("unit", UNITS)
def test_no_triangle_folds_on_any_face(maps: dict[str, SmoothMap], unit: str) -> None:
    moved = displacement(unit)
    for name, smooth_map in maps.items():
        worn = sheet_of(name, moved)
        assert find_folds(smooth_map.geometry, worn, smooth_map.generic + moved).sum() == 0, name


@pytest.mark.parametrize(("unit", "eye"), LIDS)
def test_lids_open_on_every_face_as_far_as_on_the_source(maps: dict[str, SmoothMap], unit: str, eye: int) -> None:
    """The goals of new faces: two hundredths of the opening in the mean, four along the line."""
    moved = displacement(unit)
    for name, smooth_map in maps.items():
        contact = smooth_map.contacts[eye]
        source = (contact.source * contact.line.rungs(smooth_map.generic + moved)).sum(axis=1)
        here = (contact.target * contact.line.rungs(sheet_of(name, moved))).sum(axis=1)
        missing = contact.ratios * source - here
        size = contact.here.sum()
        assert abs(missing.sum()) < 0.02 * size, name
        assert np.abs(missing).sum() < 0.04 * size, name
        assert unit not in BLINKS or (contact.ratios * source).sum() < 0.1 * size, "the source does not close"


@pytest.mark.parametrize("unit", ["mouth-open", "jawOpen"])
def test_lips_open_on_every_face_as_far_as_on_the_source(maps: dict[str, SmoothMap], unit: str) -> None:
    """Over the mouth's width, to three hundredths."""
    moved = displacement(unit)
    for name, smooth_map in maps.items():
        lips = smooth_map.contacts[2].line
        faces = ((smooth_map.generic, smooth_map.generic + moved), (smooth_map.positions, sheet_of(name, moved)))
        there, here = (
            (lips.rungs(now) - lips.rungs(rest))[:, 1].mean() / np.ptp(rest[lips.loop, 0]) for rest, now in faces
        )
        assert here == pytest.approx(there, abs=0.03), name
        assert there > 0.1, "the source does not open"


def test_a_face_at_rest_stays_at_rest(maps: dict[str, SmoothMap]) -> None:
    for name, smooth_map in maps.items():
        assert np.abs(sheet_of(name, np.zeros_like(smooth_map.generic)) - smooth_map.positions).max() < 1e-6


def test_far_from_lids_and_lips_a_displacement_is_added_as_it_is(maps: dict[str, SmoothMap]) -> None:
    moved = displacement("eyeBlinkLeft")
    for name, smooth_map in maps.items():
        worn = sheet_of(name, moved)
        width = np.ptp(smooth_map.positions[smooth_map.contacts[0].line.loop, 0])
        loop = smooth_map.positions[smooth_map.contacts[0].line.loop].mean(axis=0)
        far = np.linalg.norm(smooth_map.positions - loop, axis=1) > 4 * width
        assert np.abs(worn - smooth_map.positions - moved)[far].max() < 1e-8


DETAILED = ("jawOpen", "eyeBlinkLeft", "mouthFunnel")
ONES = np.ones(omote.load_cast().space.vertex_count)


def sheet(positions: np.ndarray) -> SheetGeometry:
    space = omote.load_cast().space
    return build_sheet_geometry(space.points, positions, space.sheet_triangles)


@pytest.fixture(scope="module")
def generic() -> DetailSolver:
    return factor_detail(sheet(omote.load_cast().space.points))


@pytest.fixture(scope="module")
def baby() -> DetailSolver:
    return factor_detail(sheet(omote.load_cast().faces["baby"].positions.astype(np.float64)))


@pytest.mark.parametrize("unit", DETAILED)
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


@pytest.mark.parametrize("unit", DETAILED)
def test_of_what_gradients_miss_beyond_the_tolerance_much_is_made_up_and_more_by_no_share_of_it(
    baby: DetailSolver, unit: str
) -> None:
    points = omote.load_cast().space.points
    moved = displacement(unit)
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
    cast = omote.load_cast()
    moved = displacement("eyeBlinkLeft")
    change = np.linalg.norm(solve_detail(baby, moved, cast.space.points + moved, ONES) - moved, axis=1)
    still = cast.space.points[np.linalg.norm(moved, axis=1) > 1e-6]
    far = np.linalg.norm(cast.space.points[:, None] - still[None, ::8], axis=2).min(axis=1) > 0.05
    assert change.max() > 1e-4
    assert change[far].max() < 1e-7
