"""The filter holds what is still and follows what moves."""

import numpy as np
import pytest

from omote.inputs.camera.one_euro import LONGEST_GAP, OneEuroFilter, Smoothing


def test_noise_on_a_still_gets_smaller() -> None:
    draw = np.random.default_rng(0)
    one = OneEuroFilter(Smoothing())
    noise = draw.normal(0.0, 0.02, (300, 5))
    calm = np.array([one.follow(row, frame / 30) for frame, row in enumerate(noise)])
    assert (calm[30:].std(axis=0) < 0.75 * noise[30:].std(axis=0)).all()


def test_a_fast_move_arrives_within_a_frame() -> None:
    one = OneEuroFilter(Smoothing())
    moved = np.clip(np.arange(20) - 10, 0, 4) / 4.0
    seen = np.array([one.follow(np.array([value]), frame / 30)[0] for frame, value in enumerate(moved)])
    assert int(np.argmax(seen > 0.5)) - int(np.argmax(moved > 0.5)) <= 1


def test_the_first_values_come_through_as_they_are() -> None:
    assert OneEuroFilter(Smoothing()).follow(np.array([0.3, 0.7]), 5.0).tolist() == [0.3, 0.7]


@pytest.mark.parametrize("time", [1.0 + 2 * LONGEST_GAP, 0.0])
def test_a_gap_or_a_clock_that_jumps_back_begins_anew(time: float) -> None:
    one = OneEuroFilter(Smoothing())
    one.follow(np.zeros(1), 1.0)
    assert one.follow(np.ones(1), time).tolist() == [1.0]


def test_after_a_reset_nothing_is_remembered() -> None:
    one = OneEuroFilter(Smoothing())
    one.follow(np.zeros(1), 1.0)
    one.reset()
    assert one.follow(np.ones(1), 1.01).tolist() == [1.0]


def test_the_same_instant_twice_changes_nothing() -> None:
    one = OneEuroFilter(Smoothing())
    one.follow(np.zeros(1), 1.0)
    assert one.follow(np.ones(1), 1.0).tolist() == [0.0]
