"""The generic head's sheet as a thin plate: what bends it, and what is left without short waves."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.extraction.smooth_map_inverse import prepare_bending

SPACE = omote.load_cast().space
PLATE = prepare_bending(SPACE)
WAVE = np.sin(200 * PLATE.positions)


def test_bending_knows_no_constant_and_grows_with_the_square() -> None:
    assert PLATE.measure(np.ones_like(WAVE)) == pytest.approx(0.0, abs=1e-9)
    assert PLATE.measure(3 * WAVE) == pytest.approx(9 * PLATE.measure(WAVE))


def test_smoothing_keeps_constants_and_long_waves_and_takes_short_ones() -> None:
    assert np.abs(PLATE.smooth(np.ones_like(WAVE), 0.002) - 1.0).max() < 1e-9
    noise = np.random.default_rng(3).normal(size=WAVE.shape)
    bent = [PLATE.measure(PLATE.smooth(noise, length)) / PLATE.measure(noise) for length in (0.002, 0.004, 0.008)]
    assert bent[2] < bent[1] / 4 < bent[0] / 16 < 0.02 / 16  # waves twice as long are bent a sixteenth as much
    assert np.sqrt(np.mean((PLATE.smooth(WAVE, 0.001) - WAVE) ** 2)) < 0.05


def test_smoothing_around_a_vertex_leaves_what_is_far_from_it() -> None:
    vertex = 100
    smooth = PLATE.smooth_around(WAVE, vertex, 0.004, 0.009)
    far = np.linalg.norm(PLATE.positions - PLATE.positions[vertex], axis=1) > 0.06
    assert np.abs(smooth - WAVE)[far].max() < 1e-12
    assert smooth[vertex] == pytest.approx(PLATE.smooth(WAVE, 0.004)[vertex])


def test_the_plate_of_a_space_is_assembled_once() -> None:
    assert prepare_bending(SPACE) is PLATE
