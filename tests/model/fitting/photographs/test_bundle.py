"""Shape, cameras and expressions from landmarks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_identity_modes, load_landmark_table
from omote.model.fitting.photographs.bundle import adjust
from omote.model.fitting.photographs.landmark_table import LandmarkTable
from omote.model.fitting.photographs.photograph import FILM, Photograph, PhotographCamera
from tools.tracking.picture import turn

SPACE = load_cast().space
MODES = load_identity_modes()
TABLE = load_landmark_table()
SIDE = 600
FOCAL = 800.0
FACE = TABLE.corners.ravel()


def sure(table: LandmarkTable) -> LandmarkTable:
    """A landmark model that does not err."""
    return replace(
        table, mean=0 * table.mean, slopes=0 * table.slopes, person=0 * table.person[..., :1],
        shared=1e-10 * np.tile(np.eye(table.shared.shape[1]), (len(table.nodes), 1, 1)), alone=0 * table.alone + 1e-8,
    )  # fmt: skip


def camera_at(yaw: float) -> PhotographCamera:
    rotation = turn("x", 0.05) @ turn("y", yaw)
    return PhotographCamera(rotation, np.array([0.02, 0.01, -0.7]), FOCAL, SIDE, SIDE)


def somebody(seed: int) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=len(MODES.moves)) * np.where(
        np.arange(len(MODES.moves)) < 20, 1, 0.2
    )


def photograph(
    weights: np.ndarray, yaw: float, units: dict[str, float] | None = None, table: LandmarkTable | None = None
) -> Photograph:
    """Landmarks as a model finds them that errs as a table says on average, without one not at all."""
    places = TABLE.places(MODES.shape_skin(weights))
    places = places + sum(weight * TABLE.units[name] for name, weight in (units or {}).items())
    points = np.full((478, 2), SIDE / 2.0)
    seen = camera_at(yaw).view(places)
    if table is not None:
        law = table.error_at(yaw)
        seen[:, :2] += (law.mean + law.slopes @ weights).reshape(-1, 2)
    points[: len(places)] = camera_at(yaw).project(seen)
    return Photograph(points, SIDE, SIDE, focal=FILM * FOCAL / SIDE, camera="one")


def off(weights: np.ndarray, truth: np.ndarray) -> float:
    """Root mean square of the face's landmarks' places, of the mean head's."""
    true = TABLE.places(MODES.shape_skin(truth)) - TABLE.places(MODES.skin)
    found = TABLE.places(MODES.shape_skin(weights)) - TABLE.places(MODES.skin)
    return float(np.linalg.norm(found - true) / np.linalg.norm(true))


@pytest.mark.parametrize("seed", [1, 2])
def test_landmarks_without_errors_give_shape_and_cameras_back(seed: int) -> None:
    truth = somebody(seed)
    yaws = (0.0, 0.7, -0.6)
    found = adjust(SPACE, MODES, sure(TABLE), [photograph(truth, yaw) for yaw in yaws])
    assert off(found.weights, truth) < 0.1
    for yaw, camera in zip(yaws, found.cameras, strict=True):
        assert abs(camera.yaw - yaw) < np.radians(1.0)


@pytest.mark.slow
def test_two_views_say_more_than_one() -> None:
    truth = somebody(5)
    one, two = ([photograph(truth, yaw, table=TABLE) for yaw in yaws] for yaws in ((0.0,), (0.0, 0.7)))
    first, both = (adjust(SPACE, MODES, TABLE, each) for each in (one, two))
    assert off(both.weights, truth) < off(first.weights, truth) < 1.0
    assert (both.deviations <= first.deviations + 1e-9).mean() > 0.9


def test_a_smile_is_taken_for_a_smile_and_not_for_a_wide_mouth() -> None:
    truth = np.zeros(len(MODES.moves))
    smile = {"mouthSmileLeft": 0.5, "mouthSmileRight": 0.5}
    smiling = [photograph(truth, yaw, smile) for yaw in (0.0, 0.6)]
    found = adjust(SPACE, MODES, sure(TABLE), smiling)
    names = list(TABLE.units)
    for name, weight in smile.items():
        assert found.units[0][names.index(name)] == pytest.approx(weight, abs=0.15)
    moved = TABLE.places(MODES.shape_skin(found.weights)) - TABLE.places(MODES.skin)
    smiled = sum(weight * TABLE.units[name] for name, weight in smile.items())
    assert np.linalg.norm(moved) < 0.5 * np.linalg.norm(smiled)


@pytest.mark.slow
def test_one_wild_landmark_changes_little() -> None:
    truth = somebody(7)
    views = [photograph(truth, yaw, table=TABLE) for yaw in (0.0, 0.6)]
    wild = views[0].landmarks.copy()
    wild[1] += 150.0
    spoiled = [replace(views[0], landmarks=wild), views[1]]
    plain, odd = (adjust(SPACE, MODES, TABLE, each).weights for each in (views, spoiled))
    assert off(odd, truth) < off(plain, truth) + 0.1
