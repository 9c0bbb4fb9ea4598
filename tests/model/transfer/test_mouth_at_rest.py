"""The mouth of a new face at rest: put in order once, and then it stays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.recipes.face_handles import default_handles, drag_handles
from omote.model.sculpting.caricature import caricature
from omote.model.sculpting.regions import regional
from omote.model.sculpting.sculpt import Sculpt, sculpted
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.transfer.gum_line import find_gum_line, measure_gums
from omote.model.transfer.mouth_at_rest import (
    FLOATING,
    LIP_SKIN_METRES,
    PITCHES,
    SHALLOW,
    _find_lips,
    _look_through,
    close_lips,
    fit_mouth_at_rest,
    mend_mouth,
)
from omote.model.transfer.mouth_bag import find_mouth_bag
from omote.model.transfer.mouth_bag_fit import measure_shallow
from tests.synthetic import space

CAST = omote.load_cast()


def measure_slits(positions: NDArray[np.floating]) -> NDArray[np.float64]:
    """How far one can look through between lips, metres, at places along the mouth."""
    lips = _find_lips(CAST.space)
    assert lips is not None
    return _look_through(lips, positions.astype(np.float64), PITCHES)[1]


@pytest.mark.parametrize("name", ["kaori", "man", "count"])
def test_only_lips_and_bag_of_a_face_change_and_hardly_any_more_once_they_are_in_order(name: str) -> None:
    face = CAST.faces[name]
    bag = find_mouth_bag(CAST.space)
    assert bag is not None
    again = fit_mouth_at_rest(CAST.space, face.positions, face.parts)
    outside = ~np.isin(CAST.space.welded, bag.vertices)
    assert np.abs(again - face.positions)[outside].max() < 1e-7
    assert np.quantile(np.abs(again - face.positions).max(axis=1)[~outside], 0.9) < 0.002


def test_a_head_without_a_mouth_stays() -> None:
    positions = space().points.astype(np.float32)
    assert np.array_equal(fit_mouth_at_rest(space(), positions, {}), positions)


def made_at_run_time() -> list[Face]:
    """A caricature, a face with another's mouth, a dragged one and a sculpt."""
    faces = CAST.faces
    space = CAST.space
    lips = next(line.loop for line in space.lines if line.kind == "lips")
    rows = [handle.row for handle in default_handles(space)]
    moves = np.zeros((len(rows), 3))
    moves[np.linalg.norm(space.points[rows] - space.points[lips].mean(axis=0), axis=1) < 0.03, 1] = -0.012
    points = np.array([[0, -0.1, 0.148], [0.08, 0, 0.04], [0, 0.12, 0.04], [0, -0.13, -0.02], [0, -0.035, 0.168]])
    moved = np.array([[0, -0.02, 0.01], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]])
    sculpt = Sculpt("long", points, moved)
    return [
        caricature(space, faces["dog"], 1.5),
        regional(space, "hers", {"mouth": faces["dog"], "jaw": faces["dog"]}, rest=faces["kaori"]),
        drag_handles(space, faces["kaori"], "dragged", rows=rows, moves=moves),
        sculpted(space, sculpt),
    ]


def test_the_mouth_of_a_face_made_at_run_time_is_in_order() -> None:
    """Lips meet, gums end at the bag, crowns are in the mouth and the bag behind the skin, as on the cast."""
    line = find_gum_line(CAST.space)
    assert line is not None
    for face in made_at_run_time():
        edges, crowns = measure_gums(line, face.positions.astype(np.float64), fit(CAST.space, face).parts)
        assert measure_slits(face.positions).max() == 0.0, face.name
        assert np.quantile(edges, 0.9) < FLOATING, face.name
        assert crowns.min() > -0.0005, face.name
        assert measure_shallow(CAST.space, face.positions) < SHALLOW, face.name


@pytest.mark.parametrize("name", CAST.faces)
def test_a_face_whose_mouth_is_in_order_comes_back_itself(name: str) -> None:
    assert mend_mouth(CAST.space, CAST.faces[name]) is CAST.faces[name]


LIPS = next(line.loop for line in CAST.space.lines if line.kind == "lips")


@pytest.mark.parametrize("name", CAST.faces)
def test_nobody_of_the_cast_shows_what_is_behind_closed_lips(name: str) -> None:
    assert measure_slits(CAST.faces[name].positions).max() == 0.0


def test_lips_that_were_drawn_apart_meet_again_and_only_the_mouth_moves() -> None:
    face = CAST.faces["kaori"].positions.astype(np.float64)
    near = np.linalg.norm(face[:, None] - face[LIPS], axis=2).min(axis=1)
    lips = _find_lips(CAST.space)
    assert lips is not None
    side = lips.side
    apart = face + 0.001 * np.outer(side, [0.0, 1.0, 0.0])
    assert measure_slits(apart).max() > 0.0005
    closed = close_lips(CAST.space, apart)
    assert measure_slits(closed).max() == 0.0
    moved = np.abs(closed - apart).max(axis=1)
    assert moved.max() < 0.0025
    assert (near[moved > 0] < 1.5 * LIP_SKIN_METRES).all()


def test_no_lip_is_pushed_behind_the_other_and_the_generic_faces_sheet_stays() -> None:
    """Lips that cross would cover each other on S, and the line of the lips would not be where they meet."""
    line = next(line for line in CAST.space.lines if line.kind == "lips")
    for name in ("kaori", "old", "noh"):
        apart = CAST.faces[name].positions.astype(np.float64)
        lips = _find_lips(CAST.space)
        assert lips is not None
        apart += 0.001 * np.outer(lips.side, [0.0, 1.0, 0.0])
        before, after = (line.rungs(points)[:, 1] for points in (apart, close_lips(CAST.space, apart)))
        assert (after >= np.minimum(before, -1e-5))[2:-2].all(), name  # at the corners lips run into each other
    open_ = CAST.space.points.copy()
    inner = ~CAST.space.on_sheet
    open_[inner & (CAST.space.points[:, 1] < CAST.space.points[LIPS, 1].mean()), 1] -= 0.002
    rest = replace(CAST.space, points=open_)
    assert np.array_equal(close_lips(rest, open_)[CAST.space.on_sheet], open_[CAST.space.on_sheet])
    assert np.abs(close_lips(rest, open_) - open_).max() > 0.0005


def test_closed_lips_stay_as_they_are_and_so_does_a_head_without_lips() -> None:
    face = CAST.faces["kaori"].positions.astype(np.float64)
    assert np.array_equal(close_lips(CAST.space, face), face)
    assert np.array_equal(close_lips(space(), space().points), space().points)
