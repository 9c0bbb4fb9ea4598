"""What a shape folds on the generic head is turned back: lids and lips stay where they were, nobody wears a fold."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.extraction.extract import extract
from omote.model.extraction.extracted_expression import ExtractedExpression
from omote.model.fitting.take_expressions import closes_open_jaw, repair_field
from omote.model.space.face import Face
from omote.model.space.face_fit import generic_face
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.smooth_map import prepare_smooth_map

CAST = omote.load_cast()
SPACE = CAST.space
GENERIC = generic_face(CAST.space)
READY = prepare_smooth_map(SPACE, GENERIC)


def worn_by(face: Face, expression: omote.Expression) -> NDArray[np.float64]:
    """The sheet of a face with an expression."""
    return omote.compound(SPACE, face, expression).astype(np.float64)


def folds_on(face: Face, expression: omote.Expression) -> int:
    """How many triangles of a face's sheet an expression turns over."""
    rest = face.positions.astype(np.float64)
    return int(find_folds(prepare_smooth_map(SPACE, face).geometry, worn_by(face, expression), rest).sum())


def crumple(name: str, seed: int) -> ExtractedExpression:
    """A unit of the cast with noise beside the nose, as it is read off a rough scan: it folds the generic head."""
    moved = worn_by(GENERIC, CAST.expressions[name]) - GENERIC.positions
    draw = np.random.default_rng(seed)
    middle = np.flatnonzero(SPACE.on_sheet)[GENERIC.positions[SPACE.on_sheet][:, 2].argmax()]
    apart = np.linalg.norm(GENERIC.positions - GENERIC.positions[middle], axis=1)
    near: NDArray[np.float64] = np.exp(-((apart / 0.012) ** 2))
    noise = np.array(draw.normal(size=moved.shape))[SPACE.welded]
    rough = moved + 0.003 * near[:, None] * noise
    return extract(SPACE, GENERIC, rough)


@pytest.mark.parametrize(("name", "seed"), [("mouthPucker", 1), ("jawOpen", 2), ("noseSneerLeft", 3)])
def test_nobody_wears_a_fold(name: str, seed: int) -> None:
    rough = crumple(name, seed)
    assert folds_on(GENERIC, rough) > 0
    repaired = repair_field(SPACE, rough, {})
    assert [folds_on(face, repaired) for face in (GENERIC, CAST.faces["kaori"], CAST.faces["dog"])] == [0, 0, 0]


def test_lids_and_lips_stay_as_far_apart() -> None:
    rough = crumple("jawOpen", 4)
    repaired = repair_field(SPACE, rough, {})
    before, after = (worn_by(GENERIC, each) for each in (rough, repaired))
    for contact in READY.contacts:
        off = contact.bins @ (contact.source * (contact.line.rungs(after) - contact.line.rungs(before))).sum(axis=1)
        assert np.abs(off).max() < 1e-6


def test_what_folds_nothing_stays_itself() -> None:
    moved = worn_by(GENERIC, CAST.expressions["smile"]) - GENERIC.positions
    smile = extract(SPACE, GENERIC, moved)
    assert repair_field(SPACE, smile, {}) is smile


def test_lips_that_close_an_open_jaw_may_lie_over_each_other() -> None:
    assert closes_open_jaw(READY, worn_by(GENERIC, CAST.expressions["mouthClose"]))
    pressed = ("mouthPressLeft", "mouthRollLower", "mouthRollUpper", "mouthShrugLower", "mouthShrugUpper")
    for name in pressed:
        assert not closes_open_jaw(READY, worn_by(GENERIC, CAST.expressions[name]))
    close = extract(SPACE, GENERIC, worn_by(GENERIC, CAST.expressions["mouthClose"]) - GENERIC.positions)
    assert repair_field(SPACE, close, {}) is close


def test_the_paper_s_map_is_left_alone() -> None:
    paper = replace(SPACE, transfer="paper")
    rough = extract(paper, GENERIC, 0.01 * np.random.default_rng(5).normal(size=(SPACE.vertex_count, 3)))
    assert repair_field(paper, rough, {}) is rough
