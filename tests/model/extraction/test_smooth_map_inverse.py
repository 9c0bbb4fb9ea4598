"""The inverse of the smooth map: exact through its continuous stages, and near what is known where folds were."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.extraction.smooth_map_inverse import invert_smooth_map
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import CONTINUOUS_STAGES, apply_smooth_map
from omote.model.transfer.smooth_map import prepare_smooth_map

CAST = omote.load_cast()
SPACE = CAST.space


def displace(unit: str) -> np.ndarray:
    """What a unit does to the generic face's sheet, (V, 3)."""
    moved = displace_generic(SPACE, compile_expression(SPACE, CAST.expressions[unit]))
    result: np.ndarray = (moved * SPACE.on_sheet[:, None])[SPACE.welded]
    return result


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("kaori", "jawOpen"),
        ("dog", "mouthClose"),
        ("baby", "mouthClose"),
        ("alien", "mouthPucker"),
    ],
)
def test_where_no_fold_is_turned_back_the_displacement_itself_is_found(name: str, unit: str) -> None:
    """Found to 0.002 mm; a vertex that hangs on the sheet by one triangle, as two in the corners of the lips do, has
    two places that give that triangle's detail, a tenth of a millimetre apart on the dog."""
    face = CAST.faces[name]
    meant = displace(unit)
    goal = apply_smooth_map(SPACE, face, meant)
    assert np.abs(goal - apply_smooth_map(SPACE, face, meant, CONTINUOUS_STAGES)).max() < 1e-6  # no fold
    found = invert_smooth_map(SPACE, face, goal)
    off = np.abs(found.displacement - meant).max(axis=1)
    hanging = (np.bincount(SPACE.sheet_triangles.ravel(), minlength=SPACE.vertex_count) == 1)[SPACE.welded]
    assert hanging[SPACE.on_sheet].mean() < 0.01
    assert off[~hanging].max() < 2e-6
    assert off.max() < 2e-4
    assert found.known is None


def test_where_folds_were_turned_back_the_known_one_is_found_and_both_give_the_sheet() -> None:
    face = CAST.faces["dog"]
    meant = displace("mouth-open")
    goal = apply_smooth_map(SPACE, face, meant)
    names = ("mouth-open", "jawOpen", "mouthSmileLeft", "mouthClose", "mouthFunnel")
    found = invert_smooth_map(SPACE, face, goal, [CAST.expressions[name] for name in names])
    rows = prepare_smooth_map(SPACE, face).detail.used
    for each in (found, invert_smooth_map(SPACE, face, goal)):
        assert np.abs(apply_smooth_map(SPACE, face, each.displacement) - goal)[rows].max() < 5e-5
    assert np.abs(found.displacement - meant).max() < 2e-5


def test_on_the_generic_face_nothing_is_searched_for() -> None:
    face = CAST.faces["generic"]
    meant = displace("eyeBlinkLeft")
    found = invert_smooth_map(SPACE, face, SPACE.points + meant)
    assert np.abs(found.displacement - meant).max() < 1e-12


def test_a_sheet_that_no_expression_reaches_ends_with_a_finite_displacement() -> None:
    """Every vertex of the chin three millimetres in a direction of its own."""
    face = CAST.faces["kaori"]
    chin = np.linalg.norm(SPACE.points - [0.0, -0.09, 0.15], axis=1) < 0.03
    goal = face.positions + 0.003 * np.random.default_rng(1).normal(size=(SPACE.vertex_count, 3)) * chin[:, None]
    assert (chin & SPACE.on_sheet).sum() > 50
    assert np.isfinite(invert_smooth_map(SPACE, face, goal).displacement).all()
