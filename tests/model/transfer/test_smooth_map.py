"""The smooth map: the source itself unchanged, lids closed as far as on the source, nothing folded, on every face."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.pipeline import apply_smooth_map
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map

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
        missing, size = contact.ratios * source - here, contact.here.sum()
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
