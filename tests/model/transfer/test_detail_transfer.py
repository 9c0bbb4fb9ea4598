"""Detail: nothing changes on the source, elsewhere the gradients come nearer to its own, far away nothing moves."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.detail_transfer import Detail, detail_of, detailed
from omote.model.transfer.fold_repair import Sheet, frames, sheet_of

UNITS = ("jawOpen", "eyeBlinkLeft", "mouthFunnel")
ONES = np.ones(omote.load_cast().space.vertex_count)


def sheet(positions: np.ndarray) -> Sheet:
    space = omote.load_cast().space
    return sheet_of(space.points, positions, space.sheet_triangles)


def displacement(name: str) -> np.ndarray:
    cast = omote.load_cast()
    return compound(cast.space, cast.faces["generic"], cast.expressions[name]).astype(np.float64) - cast.space.points


@pytest.fixture(scope="module")
def generic() -> Detail:
    return detail_of(sheet(omote.load_cast().space.points))


@pytest.fixture(scope="module")
def baby() -> Detail:
    return detail_of(sheet(omote.load_cast().faces["baby"].positions.astype(np.float64)))


@pytest.mark.parametrize("unit", UNITS)
def test_on_the_source_itself_nothing_changes(generic: Detail, unit: str) -> None:
    moved = displacement(unit)
    assert np.abs(detailed(generic, moved, omote.load_cast().space.points + moved, ONES) - moved).max() < 1e-9


def test_a_shift_of_the_whole_face_stays_a_shift(baby: Detail) -> None:
    points = omote.load_cast().space.points
    shift = np.broadcast_to([0.01, -0.02, 0.005], points.shape)
    assert np.abs(detailed(baby, shift, points + shift, ONES) - shift).max() < 1e-9


def test_a_larger_displacement_has_larger_detail(generic: Detail) -> None:
    moved = displacement("jawOpen")
    worn = detailed(generic, moved, omote.load_cast().space.points + moved, 1.5 * ONES)
    assert np.abs(worn - 1.5 * moved).max() < 1e-9


@pytest.mark.parametrize("unit", UNITS)
def test_gradients_come_nearer_to_the_sources(baby: Detail, unit: str) -> None:
    points, moved = omote.load_cast().space.points, displacement(unit)
    worn = detailed(baby, moved, points + moved, ONES)
    wanted = frames(points + moved, baby.sheet.triangles) @ baby.sheet.source - np.eye(3)
    wanted = (wanted @ baby.sheet.plane).transpose(2, 0, 1).reshape(-1, 3)

    def lack(displacement: np.ndarray) -> float:
        off = wanted - baby.slopes @ displacement[baby.used]
        return float((baby.areas[:, None] * off**2).sum())

    assert lack(worn) < 0.8 * lack(moved)


def test_the_change_dies_out_within_centimetres(baby: Detail) -> None:
    cast, moved = omote.load_cast(), displacement("eyeBlinkLeft")
    change = np.linalg.norm(detailed(baby, moved, cast.space.points + moved, ONES) - moved, axis=1)
    still = cast.space.points[np.linalg.norm(moved, axis=1) > 1e-6]
    far = np.linalg.norm(cast.space.points[:, None] - still[None, ::8], axis=2).min(axis=1) > 0.05
    assert change.max() > 1e-4
    assert change[far].max() < 1e-7
