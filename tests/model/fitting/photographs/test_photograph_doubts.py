"""What photographs do not say."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.model.fitting.photographs.bundle_problem import Bundle
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.photograph_fit import FOLDS, find_photograph_doubts
from tests.model.fitting.photographs.test_face_at_rest import landmarks
from tools.tracking.picture import turn


def bundle(*yaws: float) -> Bundle:
    cameras = tuple(PhotographCamera(turn("y", yaw), np.array([0, 0, -1.0]), 1000.0, 500, 500) for yaw in yaws)
    still = tuple(np.zeros(3) for _ in yaws)
    return Bundle(
        np.zeros(5), np.ones(5), np.zeros(2), cameras, still, tuple(np.zeros(8) for _ in yaws),
        np.zeros((len(yaws), 9)), np.zeros(3),
    )  # fmt: skip


def doubts(found: Bundle, *sides: str | None, residual: float = 2.0, folds: int = 0) -> tuple[str, ...]:
    views = [Photograph(landmarks(), 500, 500, side=side) for side in sides or [None] * len(found.cameras)]
    worn = [
        dict(zip(("mouthSmileLeft", "mouthSmileRight", "browInnerUp"), units, strict=True)) for units in found.units
    ]
    return find_photograph_doubts(views, found, worn, [residual] * len(views), 2.5, folds)


def test_all_sides_leave_no_doubt_and_one_photograph_tells_its_millimetres() -> None:
    assert doubts(bundle(0.0, 0.6, -0.6)) == ()
    (only,) = doubts(bundle(0.0))
    assert "2.5 mm" in only


@pytest.mark.parametrize(("yaw", "missing"), [(0.6, "left"), (-0.6, "right")])
def test_the_side_that_is_turned_away_is_named(yaw: float, missing: str) -> None:
    (only,) = doubts(bundle(0.0, yaw))
    assert f"from its {missing}" in only


def test_odd_photographs_and_heads_are_told() -> None:
    found = bundle(0.0, 0.6, -0.6)
    assert len(doubts(found, residual=40.0)) == 3
    assert len(doubts(found, folds=FOLDS)) == 0
    assert len(doubts(found, folds=FOLDS + 1)) == 1
    assert len(doubts(replace(found, weights=np.full(5, 3.0)))) == 1
    assert len(doubts(replace(found, units=(np.ones(3), *found.units[1:])))) == 1
    right = doubts(found, "front", "right", "left")
    wrong = doubts(found, "front", "left", "right")
    assert (len(right), len(wrong)) == (0, 2)


def test_a_photograph_of_a_smile_is_said_to_be_one_with_what_can_be_done() -> None:
    view = Photograph(landmarks(mouth=0.06), 500, 500)
    units = {"mouthSmileLeft": 0.5, "mouthSmileRight": 0.5}
    _, sentence = find_photograph_doubts([view], bundle(0.0), [units], [2.0], 2.5, 0)
    assert "Photograph 1 shows its mouth open and a smile." in sentence
    assert "lips together, eyes open" in sentence
