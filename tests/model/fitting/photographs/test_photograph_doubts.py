"""What photographs do not say."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.model.fitting.photographs.bundle_problem import Bundle
from omote.model.fitting.photographs.face_at_rest import (
    CHIN,
    FOREHEAD,
    LEFT_EYE,
    LOWER_LIP,
    RIGHT_EYE,
    UPPER_LIP,
    describe_unrest,
)
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.photograph_fit import FOLDS, find_photograph_doubts
from tools.tracking.picture import turn


def bundle(*yaws: float) -> Bundle:
    cameras = tuple(PhotographCamera(turn("y", yaw), np.array([0, 0, -1.0]), 1000.0, 500, 500) for yaw in yaws)
    still = tuple(np.zeros(3) for _ in yaws)
    return Bundle(
        np.zeros(5), np.ones(5), np.zeros(2), cameras, still, tuple(np.zeros(8) for _ in yaws),
        np.zeros((len(yaws), 9)), np.zeros(3),
    )  # fmt: skip


def landmarks(mouth: float = 0.01, lids: float = 0.3) -> np.ndarray:
    """A face 100 pixels tall with eyes 20 wide; mouth, lids: their gaps, of that."""
    points = np.full((478, 2), 50.0)
    points[FOREHEAD, 1], points[CHIN, 1] = 0.0, 100.0
    points[LOWER_LIP, 1] = points[UPPER_LIP, 1] + 100.0 * mouth
    for outer, inner, upper, lower in (RIGHT_EYE, LEFT_EYE):
        points[outer, 0], points[inner, 0] = 20.0, 40.0
        points[lower, 1] = points[upper, 1] + 20.0 * lids
    return points


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


@pytest.mark.parametrize(
    ("mouth", "lids", "smile", "said"),
    [
        (0.02, 0.25, 0.2, []),
        (0.06, 0.25, 0.2, ["its mouth open"]),
        (0.02, 0.1, 0.2, ["its eyes shut"]),
        (0.02, 0.25, 0.5, ["a smile"]),
        (0.06, 0.1, 0.5, ["its mouth open", "a smile", "its eyes shut"]),
    ],
)
def test_a_photograph_that_is_not_at_rest_is_said_to_be_what_it_is(
    mouth: float, lids: float, smile: float, said: list[str]
) -> None:
    view = Photograph(landmarks(mouth, lids), 500, 500)
    assert describe_unrest(view, 0.0, {"mouthSmileLeft": smile, "mouthSmileRight": smile}) == said
    units = {"mouthSmileLeft": smile, "mouthSmileRight": smile}
    sentences = find_photograph_doubts([view], bundle(0.0), [units], [2.0], 2.5, 0)[1:]
    assert len(sentences) == bool(said)
    assert all(f"{' and '.join(said)}. That was taken out" in sentence for sentence in sentences)


def test_the_farther_eye_of_a_turned_head_is_not_taken_for_shut() -> None:
    points = landmarks()
    points[LEFT_EYE[3]] = points[LEFT_EYE[2]]
    assert describe_unrest(Photograph(points, 500, 500), 0.5, {}) == []
    assert describe_unrest(Photograph(points, 500, 500), 0.0, {}) == ["its eyes shut"]
    assert describe_unrest(Photograph(points, 500, 500), -0.5, {}) == ["its eyes shut"]


def test_any_other_face_that_is_not_at_rest_is_told_too() -> None:
    view = Photograph(landmarks(), 500, 500)
    assert describe_unrest(view, 0.0, {"browInnerUp": 0.8}) == ["a face that is not at rest"]
