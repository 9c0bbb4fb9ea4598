"""What is behind a head in a photograph is told from the head where a fit is too wide."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from omote.model.albedo import Light, decode_light
from omote.model.appearance.photograph_albedo import BAND, UNLIKE, find_background

SIDE = 240
METRE = 1500.0
"""Pixels of a picture, and that a metre takes."""
SKIN = (180, 120, 90)
WALL = (235, 235, 240)
DOWN, RIGHT = np.indices((SIDE, SIDE)) + 0.5
AWAY = np.hypot(DOWN - SIDE / 2, RIGHT - SIDE / 2)


def disk(radius: float, skin: tuple[int, int, int] = SKIN, wall: tuple[int, int, int] = WALL) -> Light:
    """A head, round, before a wall: linear light."""
    return decode_light(np.where((radius > AWAY)[..., None], skin, wall).astype(np.uint8))


def depth_of(radius: float) -> NDArray[np.float64]:
    return np.where(radius > AWAY, 0.7, np.inf)


def places_within(radius: float) -> NDArray[np.float64]:
    rows, columns = np.nonzero(radius > AWAY)
    found: NDArray[np.float64] = np.column_stack([columns, rows]).astype(np.float64) + 0.5
    return found


@given(st.floats(60.0, 80.0), st.floats(2.0, 9.0))
def test_the_rim_of_a_fit_that_is_too_wide_is_the_wall_and_no_more(true: float, wide: float) -> None:
    at = places_within(true + wide)
    found = find_background(disk(true), depth_of(true + wide), at, METRE)
    off = np.hypot(*(at - SIDE / 2).T) - true
    assert found[(off > 1.0) & (off < wide - 1.0)].all()
    assert not found[off < -1.0].any()


def test_a_fit_that_is_right_and_one_without_a_background_lose_nothing() -> None:
    assert not find_background(disk(70), depth_of(70), places_within(70), METRE).any()
    everywhere = places_within(500)
    assert not find_background(disk(70), np.full((SIDE, SIDE), 0.7), everywhere, METRE).any()
    assert not find_background(disk(70), np.full((SIDE, SIDE), np.inf), everywhere, METRE).any()


def test_a_wall_of_the_colour_of_skin_is_not_told_from_it() -> None:
    near = (184, 122, 92)
    assert UNLIKE > 3.0
    assert not find_background(disk(70, wall=near), depth_of(76), places_within(76), METRE).any()


def test_deep_in_the_head_nothing_is_background_whatever_it_looks_like() -> None:
    picture = disk(70)
    picture[AWAY < 70 - BAND * METRE - 8] = decode_light(np.full((1, 3), WALL, np.uint8))[0]
    deep = places_within(70 - BAND * METRE - 1)
    assert not find_background(picture, depth_of(70), deep, METRE).any()


@pytest.mark.parametrize("shift", [(0.0, 0.0), (90.0, 0.0), (0.0, -90.0)])
def test_a_head_that_leaves_the_picture_is_looked_at_as_far_as_it_is_there(shift: tuple[float, float]) -> None:
    away = np.hypot(DOWN - SIDE / 2 - shift[1], RIGHT - SIDE / 2 - shift[0])
    picture = decode_light(np.where((away < 70)[..., None], SKIN, WALL).astype(np.uint8))
    rows, columns = np.nonzero(away < 75)
    at = np.column_stack([columns, rows]).astype(np.float64) + 0.5
    found = find_background(picture, np.where(away < 75, 0.7, np.inf), at, METRE)
    assert not found[away[rows, columns] < 69].any()
    assert found.any()
