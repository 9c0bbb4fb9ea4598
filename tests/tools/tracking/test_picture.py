"""Pictures show somebody: skin where the face is, another picture where they turn, the same from the same seed."""

import numpy as np

from tools.tracking.picture import SIZE, Photographer, Pose, random_setting
from tools.tracking.random_people import HUMANS, LEFT_OUT, random_person


def take(seed: int, pose: Pose | None = None, **weights: float) -> np.ndarray:
    draw = np.random.default_rng(seed)
    photographer = Photographer(random_person(draw, HUMANS), random_setting(draw))
    return photographer.take(weights, (0.0, 0.0), pose or Pose(), draw)


def test_the_same_seed_takes_the_same_picture() -> None:
    assert take(6).shape == (SIZE, SIZE, 3)
    assert np.array_equal(take(6), take(6))


def test_a_mouth_that_opens_changes_the_lower_face() -> None:
    change = np.abs(take(6).astype(int) - take(6, jawOpen=1.0)).sum(axis=2) > 60
    rows = np.flatnonzero(change.any(axis=1))
    assert change.sum() > 300
    assert np.median(rows) > SIZE / 2


def test_a_head_that_turns_to_its_left_goes_right_in_the_picture() -> None:
    draw = np.random.default_rng(6)
    photographer = Photographer(random_person(draw, HUMANS), random_setting(draw))
    nose = np.array([[0.0, -0.03, 0.16]])
    ahead, turned = (photographer.project(photographer.view(nose, Pose((yaw, 0.0, 0.0))))[0] for yaw in (0.0, 0.4))
    assert turned[0] > ahead[0]


def test_nobody_of_the_training_is_of_those_left_out() -> None:
    sources = tuple(name for name in HUMANS if name not in LEFT_OUT)
    for seed in range(20):
        person = random_person(np.random.default_rng(seed), sources)
        assert not set(person.shares) & set(LEFT_OUT)
        assert abs(sum(person.shares.values()) - 1.0) < 1e-9
