"""Agreement: nothing is off where the template lies on itself; what is missing is no error; what is piled up is one."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from omote.builtin import load_identity_modes
from omote.model.fitting.alignment import Alignment, Samples
from omote.model.fitting.find_head import NOT_THERE, Agreement, measure_agreement
from omote.model.fitting.head_template import make_template
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import measure_spacing, sample_surface
from omote.model.space.similarity import Similarity
from tests.model.fitting.placed_heads import CAST

MODES = load_identity_modes()
TEMPLATE = make_template(CAST.space, MODES)
SKIN = sample_surface(Scan(MODES.skin, CAST.space.skin_triangles))


def _measure(points: np.ndarray, shift: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Agreement:
    tree = cKDTree(points)
    samples = Samples(points, tree, measure_spacing(points, tree))
    return measure_agreement(TEMPLATE, samples, Alignment(Similarity(1.0, np.eye(3), np.array(shift)), np.zeros(0)))


def test_the_template_agrees_with_itself() -> None:
    found = _measure(SKIN)
    assert found.residual < 0.0005
    assert found.back < 0.001
    assert found.covered == 1.0


def test_half_a_face_agrees_and_is_half_covered() -> None:
    half = _measure(SKIN[SKIN[:, 0] > 0.0])
    assert half.residual < 0.0015
    assert 0.4 < half.covered < 0.65


def test_a_shift_is_measured_both_ways() -> None:
    found = _measure(SKIN, (0.0, 0.0, 0.003))
    assert 0.001 < found.residual < 0.0032
    assert 0.001 < found.back < 0.0035


def test_a_heap_of_points_agrees_one_way_only() -> None:
    heap = np.random.default_rng(1).uniform((-0.1, -0.15, 0.0), (0.1, 0.15, 0.2), (60_000, 3))
    found = _measure(heap)
    skin = _measure(SKIN)
    assert found.residual < 0.003
    assert found.back > 5.0 * skin.back


def test_nothing_is_as_far_as_can_be() -> None:
    found = _measure(SKIN + 10.0)
    assert np.isclose(found.residual, NOT_THERE)
    assert found.back == NOT_THERE
