"""Growth: nothing at zero, a power of every stretch, and no triangle turned over."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.sculpting.extrapolation import extrapolate, find_folds, repair_folds
from tests.synthetic import FACES, cast, space

CAST = omote.load_cast()
BELL = 0.02


@pytest.mark.parametrize("name", FACES)
def test_no_growth_gives_the_face(name: str) -> None:
    face = cast().faces[name].positions.astype(np.float64)
    assert np.allclose(extrapolate(space().points, face, space().triangles, 0.0, BELL), face, atol=1e-8)


@pytest.mark.parametrize("amount", [0.5, 1.0, 2.0])
def test_a_larger_head_grows_by_the_power_of_its_size(amount: float) -> None:
    stretch = 1.2
    result = extrapolate(space().points, space().points * stretch, space().triangles, amount, BELL)
    wanted = space().points * stretch ** (1.0 + amount)
    assert np.allclose(result - result.mean(axis=0), wanted - wanted.mean(axis=0), atol=1e-7)


def test_a_head_shrunk_to_a_third_shrinks_further_and_never_turns_over() -> None:
    small = space().points * [1.0, 0.34, 1.0]
    result = extrapolate(space().points, small, space().triangles, 2.0, BELL)
    assert np.ptp(result[:, 1]) < np.ptp(small[:, 1])
    assert not find_folds(small, result, space().triangles).any()


def test_what_is_turned_over_is_pulled_back_and_the_rest_stays() -> None:
    points, triangles = CAST.space.points, CAST.space.skin_triangles
    folded = np.array(points)
    vertex = int(np.linalg.norm(points - [0.045, -0.04, 0.125], axis=1).argmin())
    folded[vertex] += 1.5 * (points[triangles[(triangles == vertex).any(axis=1)].max()] - points[vertex])
    assert find_folds(points, folded, triangles).any()
    back = repair_folds(points, folded, triangles)
    assert not find_folds(points, back, triangles).any()
    assert (back == points).all(axis=1).sum() > len(points) - 20
    assert np.array_equal(repair_folds(points, points, triangles), points)
