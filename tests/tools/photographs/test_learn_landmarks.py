"""What is learned of a landmark model whose errors are made up, and so known."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_identity_modes, load_landmark_table
from omote.model.fitting.photographs.photograph import PhotographCamera
from tools.photographs.learn_landmarks import NODES, Sample, barycentric, find_errors, hats, learn_errors
from tools.photographs.observations import Observation
from tools.tracking.picture import turn


def test_hats_sum_to_one_and_are_one_at_their_nodes() -> None:
    yaws = np.linspace(-2.0, 2.0, 101)
    assert hats(yaws).sum(axis=1) == pytest.approx(1.0)
    assert np.array_equal(hats(NODES), np.eye(len(NODES)))


def test_shares_give_the_points_back_and_are_never_negative() -> None:
    draw = np.random.default_rng(2)
    corners = draw.standard_normal((60, 3, 3))
    shares = draw.dirichlet(np.ones(3), 60)
    points = np.einsum("pk,pkc->pc", shares, corners)
    assert barycentric(corners, points) == pytest.approx(shares)
    outside = barycentric(corners, points + draw.normal(0.0, 3.0, points.shape))
    assert outside.min() >= 0.0
    assert outside.sum(axis=1) == pytest.approx(1.0)


def test_landmarks_where_the_camera_projects_them_have_no_error() -> None:
    table = load_landmark_table()
    modes = load_identity_modes()
    camera = PhotographCamera(np.eye(3), np.array([0.0, 0.0, -0.7]), 500.0, 400, 400)
    places = table.places(modes.skin)
    points = np.zeros((478, 3), np.float32)
    points[: len(places), :2] = camera.project(camera.view(places)) / 400
    nothing = np.zeros(0, np.float32)
    seen = Observation(points, camera, nothing, modes.skin.astype(np.float32), np.zeros(0), points, (1, 1))
    assert np.abs(find_errors([seen], table.corners, table.shares)).max() < 1e-6


def shown_at(moves: np.ndarray, yaw: float) -> np.ndarray:
    """How modes (m, p, 3) show in a picture of a head turned so far, (m, 2 p)."""
    return (moves @ turn("y", yaw).T)[..., :2].reshape(len(moves), -1)


def made_up(people: int, views: int) -> tuple[Sample, np.ndarray]:
    """Errors of three points: a mean, half of what modes show, and what is alike in all photographs of a person."""
    draw = np.random.default_rng(6)
    whose = np.repeat(np.arange(people), views)
    modes = draw.standard_normal((people, 2))[whose]
    moves = 0.003 * draw.standard_normal((2, 3, 3))
    yaws = draw.uniform(NODES[0], NODES[-1], len(whose))
    shown = sum(near[:, None] * (modes @ shown_at(moves, yaw)) for near, yaw in zip(hats(yaws).T, NODES, strict=True))
    mean = 0.002 * np.arange(6)
    alike = 0.003 * draw.standard_normal((people, 6))[whose]
    alone = 0.001 * draw.standard_normal((len(whose), 6))
    return Sample(mean - 0.5 * shown + alike + alone, modes, yaws, whose, moves), mean


def test_a_law_that_was_made_up_is_found() -> None:
    sample, mean = made_up(800, 10)
    law = learn_errors(sample)
    basis = law["basis"].astype(np.float64)
    for node, yaw in enumerate(NODES):
        assert basis @ law["mean"][node] == pytest.approx(mean, abs=8e-4)
        slope = basis @ law["slopes"][node].astype(np.float64)
        assert slope == pytest.approx(-0.5 * shown_at(sample.moves, yaw).T, abs=8e-4)
        person = basis @ law["person"][node]
        assert np.diag(person @ person.T) == pytest.approx(np.full(6, 0.003**2), rel=0.3)
        rest = np.diag(basis @ law["shared"][node] @ basis.T) + law["alone"][node]
        assert (rest > 0.5 * 0.001**2).all()
        assert rest.mean() < 0.25 * 0.003**2  # what is alike is told from what is not
