"""How far faces are apart: all moved alike are as far apart as they were moved, whatever their inner skin does; and
steps between them that are even in any distance."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.stage_data.morph_distance import EVEN, find_even_steps, measure_difference, measure_distance
from tests import synthetic


def test_a_face_that_is_moved_is_as_far_away_as_it_was_moved() -> None:
    space = synthetic.space()
    moved = space.points + np.where(space.on_sheet[:, None], [0.0, 0.003, 0.004], [1.0, 1.0, 1.0])
    assert measure_distance(space, space.points, moved) == pytest.approx(5.0)
    assert measure_distance(space, space.points, space.points) == 0.0


def test_a_colour_difference_is_the_distance_in_lab() -> None:
    """White and black are 100 apart, sRGB's red and its green 170.57 (CIE 1976, D65)."""
    black, white, red, green = (
        np.full((2, 3, 3), colour, np.uint8) for colour in ([0] * 3, [255] * 3, [255, 0, 0], [0, 255, 0])
    )
    assert measure_difference(black, white) == pytest.approx(100.0, abs=0.02)
    assert measure_difference(red, green) == pytest.approx(170.57, abs=0.05)
    half = np.where(np.arange(3)[:, None] == 0, black, white).astype(np.uint8)
    assert measure_difference(black, half) == pytest.approx(200.0 / 3.0, abs=0.02), "the mean over all pixels"


def test_what_is_transparent_in_both_pictures_does_not_count() -> None:
    one = np.zeros((2, 4, 4), np.uint8)
    other = one.copy()
    one[:, 0] = [0, 0, 0, 255]
    other[:, 0] = [255, 255, 255, 255]
    other[:, 1:, :3] = 200
    assert measure_difference(one, other) == pytest.approx(100.0, abs=0.02)
    assert measure_difference(one[:, 1:], other[:, 1:]) == 0.0
    with pytest.raises(ValueError, match="expected one size and depth"):
        measure_difference(one, other[..., :3])


@given(st.integers(2, 20), st.lists(st.floats(0.3, 3.0), min_size=2, max_size=6), st.floats(0.7, 1.05))
def test_steps_are_even_in_any_distance_along_a_path(count: int, speeds: list[float], power: float) -> None:
    """Speeds that differ tenfold along the morph, and distances that are no sum of smaller ones."""
    places = np.linspace(0.0, 1.0, len(speeds) + 1)
    length = np.concatenate([[0.0], np.cumsum(speeds)])

    def measure(shares: Sequence[float]) -> list[float]:
        return list(np.diff(np.interp(shares, places, length)) ** power)

    found = find_even_steps(count, measure)
    assert len(found.shares) == count
    assert (found.shares[0], found.shares[-1]) == (0.0, 1.0)
    assert (np.diff(found.shares) > 0).all()
    assert found.apart == pytest.approx(measure(found.shares)), "what is told is of the steps that are given"
    assert found.apart.max() <= 1.1 * found.apart.min()


@pytest.mark.parametrize("apart", [0.3, 1.0, 2.0])
def test_steps_that_are_a_distance_apart_are_as_many_as_come_nearest(apart: float) -> None:
    found = find_even_steps(2, lambda shares: list(np.diff(10.0 * np.asarray(shares) ** 2)), apart)
    assert len(found.apart) == round(10.0 / apart)
    assert found.apart == pytest.approx([10.0 / len(found.apart)] * len(found.apart), rel=EVEN - 1.0)


def test_faces_that_look_alike_and_too_many_steps_are_refused() -> None:
    with pytest.raises(ValueError, match="look alike"):
        find_even_steps(5, lambda shares: [0.0] * (len(shares) - 1))
    with pytest.raises(ValueError, match=r"steps of 0\.001 are 10001; give a distance"):
        find_even_steps(2, lambda shares: list(np.diff(10.0 * np.asarray(shares))), 0.001)


def test_a_jump_that_no_step_divides_is_told_as_it_is() -> None:
    """Hair that changes from one style to another: the most even try is kept, and says how far its steps are apart."""

    def measure(shares: Sequence[float]) -> list[float]:
        return list(np.diff([share + (3.0 if share > 0.4 else 0.0) for share in shares]))

    found = find_even_steps(6, measure)
    assert found.apart == pytest.approx(measure(found.shares))
    assert found.apart.max() > 3.0
