"""Inner corners of eyes: their triangles come nearer to the generic head's, on the surface, and what is far stays."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import omote
from omote.builtin import load_identity_modes
from omote.model.fitting.fit_face import fit_face
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import sample_mesh
from omote.model.fitting.shape.eased_corners import FAR, ease_corners
from omote.model.fitting.shape.head_zones import head_zones
from omote.model.space.similarity import Similarity

CAST = omote.load_cast()
SPACE, MODES = CAST.space, load_identity_modes()
CORNERS = [row for name, row in find_landmarks(SPACE).items() if name.endswith("_eye_inner")]
AWAY = np.linalg.norm(SPACE.points[:, None] - SPACE.points[CORNERS], axis=2).min(axis=1)
BESIDE = SPACE.sheet_triangles[(AWAY[SPACE.sheet_triangles] < 0.008).all(axis=1)]
SEEDS = range(4)

Values = NDArray[np.float64]


def draw_person(seed: int) -> Values:
    """The skin (V, 3) of a random person of the package, metres."""
    return MODES.shape_skin(np.random.default_rng(seed).standard_normal(len(MODES.moves)))


def in_plane(points: Values) -> Values:
    """The edges of triangles (t, 3, 3) in their own planes, (t, 2, 2)."""
    one, other = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    along = one / np.linalg.norm(one, axis=1, keepdims=True)
    across = np.cross(np.cross(one, other), along)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    return np.stack([[(edge * way).sum(axis=1) for edge in (one, other)] for way in (along, across)]).transpose(2, 0, 1)


def measure_width(skin: Values) -> float:
    """How wide triangles beside corners are in their lengths, against the generic head's: the most squeezed tenth."""
    stretch = in_plane(skin[BESIDE]) @ np.linalg.inv(in_plane(SPACE.points[BESIDE]))
    values = np.linalg.svd(stretch, compute_uv=False)
    return float(np.quantile(values[:, 1] / values[:, 0], 0.1))


def test_a_fitted_person_is_less_squeezed_at_the_corners_than_its_scan() -> None:
    gained = []
    for seed in SEEDS:
        person = draw_person(seed)
        fit = fit_face(SPACE, MODES, Scan(person, SPACE.triangles), Similarity(1.0, np.eye(3), np.zeros(3)))
        gained.append(measure_width(fit.face.positions.astype(np.float64)) / measure_width(person))
    assert np.mean(gained) > 1.2  # 1.01 without easing


def test_eased_corners_are_wider_and_stay_near_the_surface() -> None:
    box = np.stack([SPACE.points.min(axis=0), SPACE.points.max(axis=0)])
    plain = head_zones(SPACE).closed & (AWAY < FAR)
    for seed in SEEDS:
        person = draw_person(seed)
        eased = ease_corners(SPACE, person)
        assert measure_width(eased) > 1.4 * measure_width(person)
        away = sample_mesh(person, SPACE.triangles, box, 0.05).measure_distance(eased)[plain]
        assert np.median(away) < 0.0004
        assert np.quantile(away, 0.95) < 0.0015


def test_what_is_far_from_corners_stays() -> None:
    person = draw_person(0)
    np.testing.assert_array_equal(ease_corners(SPACE, person)[AWAY > FAR], person[AWAY > FAR])


def test_a_head_as_the_generic_one_is_not_moved() -> None:
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    placed = 1.1 * SPACE.points @ turn + [0.1, 0.2, 0.3]
    np.testing.assert_allclose(ease_corners(SPACE, placed), placed, atol=1e-9)
