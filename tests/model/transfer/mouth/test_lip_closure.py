"""Lips of a face at rest meet, by the least motion, and only they move."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.model.transfer.mouth.lip_closure import REACH, _find_lips, close_lips, measure_slits
from tests.synthetic import space

CAST = omote.load_cast()
LIPS = next(line.loop for line in CAST.space.lines if line.kind == "lips")


@pytest.mark.parametrize("name", CAST.faces)
def test_nobody_of_the_cast_shows_what_is_behind_closed_lips(name: str) -> None:
    assert measure_slits(CAST.space, CAST.faces[name].positions).max() == 0.0


def test_lips_that_were_drawn_apart_meet_again_and_only_the_mouth_moves() -> None:
    face = CAST.faces["kaori"].positions.astype(np.float64)
    near = np.linalg.norm(face[:, None] - face[LIPS], axis=2).min(axis=1)
    lips = _find_lips(CAST.space)
    assert lips is not None
    side = lips.side
    apart = face + 0.001 * np.outer(side, [0.0, 1.0, 0.0])
    assert measure_slits(CAST.space, apart).max() > 0.0005
    closed = close_lips(CAST.space, apart)
    assert measure_slits(CAST.space, closed).max() == 0.0
    moved = np.abs(closed - apart).max(axis=1)
    assert moved.max() < 0.0025
    assert (near[moved > 0] < 1.5 * REACH).all()


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
