"""Fitting modes: a head made of modes and moved is found again; a prior keeps what nothing says at rest."""

from __future__ import annotations

import numpy as np

import omote
from omote.builtin import load_identity_modes
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.mode_fit import Marks, fit_modes
from omote.model.fitting.scan_surface import sample_mesh
from omote.model.space.parts import eye_rotation
from omote.model.space.similarity import Similarity

SPACE = omote.load_cast().space
MODES = load_identity_modes()
ROWS = np.array([*find_landmarks(SPACE).values()])
BOX = np.stack([SPACE.points.min(axis=0), SPACE.points.max(axis=0)])


def test_a_head_of_modes_is_found_again_where_it_was_moved_to() -> None:
    weights = np.random.default_rng(3).normal(size=len(MODES.moves))
    pose = Similarity(1.03, eye_rotation(0.05, -0.04), np.array([0.004, -0.003, 0.005]))
    head = pose(MODES.shape_skin(weights))
    surface = sample_mesh(head, SPACE.triangles, BOX, 0.05)
    even = SPACE.on_sheet.astype(np.float64)
    found = fit_modes(SPACE, MODES, surface, Marks(ROWS, head[ROWS]), even)
    fitted = found.pose(MODES.shape_skin(found.weights))
    before = np.linalg.norm(SPACE.points - head, axis=1)[SPACE.on_sheet]
    after = np.linalg.norm(fitted - head, axis=1)[SPACE.on_sheet]
    assert np.median(after) < 0.1 * np.median(before)
    assert abs(found.pose.scale - pose.scale) < 0.01


def test_modes_of_which_nothing_is_seen_stay_at_rest() -> None:
    surface = sample_mesh(SPACE.points + 0.5, SPACE.triangles, BOX + 0.5, 0.0)
    found = fit_modes(SPACE, MODES, surface, Marks(ROWS, SPACE.points[ROWS]), SPACE.on_sheet.astype(np.float64))
    assert np.isfinite(found.weights).all()
    assert np.linalg.norm(found.pose(MODES.shape_skin(found.weights))[ROWS] - SPACE.points[ROWS], axis=1).max() < 0.003
