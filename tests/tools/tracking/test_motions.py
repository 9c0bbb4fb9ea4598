"""What people of the training do can be worn."""

import numpy as np

from omote.inputs.camera.landmark_map import UNITS
from tools.tracking.films import RATE, film
from tools.tracking.motions import OPPOSED, PAIRS, SINGLES, random_moment, random_rest, row_of


def test_groups_are_all_units_once() -> None:
    units = [group + side for group in PAIRS for side in ("Left", "Right")]
    assert sorted([*units, *SINGLES]) == sorted(UNITS)
    assert set(PAIRS) >= OPPOSED


def test_weights_are_of_units_and_within_a_face() -> None:
    draw = np.random.default_rng(4)
    for _ in range(300):
        moment = random_moment(draw)
        assert set(moment.weights) <= set(UNITS)
        assert all(0.0 <= weight <= 1.0 for weight in moment.weights.values())
        assert abs(moment.pose.head[0]) <= np.radians(32.0)


def test_the_same_seed_does_the_same() -> None:
    first, second = (random_moment(np.random.default_rng(9)) for _ in range(2))
    assert first == second


def test_a_row_holds_what_was_done() -> None:
    draw = np.random.default_rng(1)
    moment = random_moment(draw)
    row = row_of(moment)
    assert len(row) == len(UNITS) + 8
    assert not row_of(random_rest(draw))[: len(UNITS)].any()
    assert row[UNITS.index(next(iter(moment.weights)))] == np.float32(next(iter(moment.weights.values())))


def test_a_film_has_every_scene_and_blinks_that_close() -> None:
    scenes = film(np.random.default_rng(0), None, take_frames=4 * RATE)
    names = {name for name, _ in scenes}
    assert names >= {"neutral", "shut", "left", "take", "mixtures", "still", "blinks"}
    lids = [moment.weights.get("eyeBlinkLeft", 0.0) for name, moment in scenes if name == "blinks"]
    assert max(lids) == 1.0
    assert min(lids) < 0.1
