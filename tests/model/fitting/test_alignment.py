"""Alignment: a head that is turned, moved and grown a little comes back; so do the modes that shaped it."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from omote.builtin import load_identity_modes
from omote.model.fitting.alignment import Alignment, Samples, align, find_matches
from omote.model.fitting.head_template import make_template
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import sample_surface
from omote.model.space.similarity import Similarity
from tests.model.fitting.placed_heads import CAST, degrees_between

MODES = load_identity_modes()
TEMPLATE = make_template(CAST.space, MODES)
START = Alignment(Similarity(1.0, np.eye(3), np.zeros(3)), np.zeros(0))
REACHES = (0.03, 0.03, 0.025, 0.02, 0.02, 0.015, 0.015, 0.01, 0.01, 0.01, 0.01, 0.01)


def _samples(points: np.ndarray) -> Samples:
    surface = sample_surface(Scan(points, CAST.space.skin_triangles))
    return Samples(surface, cKDTree(surface), 0.0005)


def test_a_pose_comes_back() -> None:
    turn = Rotation.from_euler("xyz", (10, -8, 12), degrees=True).as_matrix()
    points = 1.1 * MODES.skin @ turn.T + [0.01, -0.005, 0.008]
    start = Alignment(Similarity(1.0, np.eye(3), MODES.skin.mean(axis=0) - points.mean(axis=0)), np.zeros(0))
    found = align(TEMPLATE, _samples(points), start, TEMPLATE.matched, TEMPLATE.weights, reaches=REACHES, modes=0)
    assert degrees_between(found.pose.rotation @ turn, np.eye(3)) < 0.3
    assert np.isclose(found.pose.scale, 1.0 / 1.1, rtol=0.005)
    assert np.linalg.norm(found.pose(points) - MODES.skin, axis=1).max() < 0.001


def test_modes_come_nearer_than_a_pose_alone() -> None:
    weights = np.zeros(len(MODES.moves))
    weights[:8] = np.random.default_rng(2).normal(size=8)
    samples = _samples(MODES.shape_skin(weights))
    away = []
    for modes in (0, 30):
        found = align(TEMPLATE, samples, START, TEMPLATE.matched, TEMPLATE.weights, reaches=REACHES, modes=modes)
        goals = TEMPLATE.shape(TEMPLATE.face, found.weights)
        off = find_matches(samples, found.pose, goals) - goals
        away.append(np.abs((off * TEMPLATE.normals[TEMPLATE.face]).sum(axis=1)).mean())
    assert away[1] < 0.5 * away[0]


def test_nothing_within_reach_leaves_the_start() -> None:
    samples = _samples(MODES.skin + 10.0)
    found = align(TEMPLATE, samples, START, TEMPLATE.front, np.ones(len(TEMPLATE.front)), reaches=REACHES, modes=0)
    assert found.pose is START.pose


def test_matches_out_of_reach_are_nowhere() -> None:
    samples = Samples(MODES.skin, cKDTree(MODES.skin), 0.001)
    points = np.concatenate([MODES.skin[:5] + 1e-6, MODES.skin[:5] + 10.0])
    for scale in (1.0, 1000.0):
        apart = Samples(MODES.skin / scale, cKDTree(MODES.skin / scale), 0.001 / scale)
        found = find_matches(apart, Similarity(scale, np.eye(3), np.zeros(3)), points, reach=0.01)
        assert np.allclose(found[:5], MODES.skin[:5], atol=1e-5)
        assert np.isinf(found[5:]).all()
    assert np.isfinite(find_matches(samples, START.pose, points)).all()
