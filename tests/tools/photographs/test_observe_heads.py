"""What is photographed to learn from, and how landmarks find their places again."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from omote.inputs.camera.landmark_map import UNITS
from omote.model.fitting.photographs.landmark_table import ON_SKIN
from tools.photographs.observations import read_observations
from tools.photographs.observe_heads import SIDE, WIDEST, random_expression, random_gaze, random_views, write_part
from tools.photographs.sculpted_people import random_sculpted


class Stubborn:
    """A landmark model that sees the same points in every picture."""

    def __init__(self) -> None:
        self.answer: np.ndarray | None = None

    def look(self, _: np.ndarray) -> np.ndarray | None:
        """The same points in every picture."""
        return self.answer

    def close(self) -> None:
        """Nothing is open."""


def test_views_are_within_reach_and_many_are_from_the_front() -> None:
    views = np.array(random_views(np.random.default_rng(2), 2000))
    assert np.abs(views[:, 0]).max() <= WIDEST
    assert (np.abs(views[:, 0]) < np.radians(12.0)).mean() > 0.3
    assert (np.abs(views[:, 0]) > np.radians(60.0)).mean() > 0.1


def test_expressions_are_of_units_and_often_none() -> None:
    draw = np.random.default_rng(3)
    worn = [random_expression(draw) for _ in range(200)]
    assert 0.25 < np.mean([not each for each in worn]) < 0.6
    for each in worn:
        assert set(each) <= set(UNITS)
        assert all(0.0 <= weight <= 1.0 for weight in each.values())


def test_eyes_stay_within_what_eyes_can() -> None:
    draw = np.random.default_rng(4)
    gazes = np.array([random_gaze(draw, float(draw.uniform(-1.4, 1.4))) for _ in range(300)])
    assert (np.abs(gazes).max(axis=0) <= [0.5, 0.3]).all()


def test_a_part_comes_back_with_the_truth_beside_it(tmp_path: Path) -> None:
    finder = Stubborn()
    points = np.full((478, 3), 0.5, np.float32)
    points[:, :2] += np.random.default_rng(1).normal(0.0, 0.04, (478, 2))
    finder.answer = points
    write_part(tmp_path, 5, range(0, 2), 3, finder)
    found = list(read_observations(tmp_path))
    assert {each.whose for each in found} <= {(5, 0), (5, 1)}
    assert found
    for each in found:
        person = random_sculpted(np.random.default_rng(list(each.whose)))
        assert each.camera.width == SIDE
        assert np.array_equal(each.points, points)
        worn = {name: float(weight) for name, weight in zip(UNITS, each.units, strict=True) if weight}
        assert np.abs(each.skin - person.wear(worn, (0.0, 0.0))[0]).max() < 1e-6
        on_skin = np.isfinite(each.lifted[:ON_SKIN]).all(axis=1)
        assert on_skin.mean() > 0.3
