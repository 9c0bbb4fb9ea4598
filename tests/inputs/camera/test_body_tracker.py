"""A tracked body: at rest first, steady, faded where an arm leaves the picture, and never a pop."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.arrays import Values
from omote.inputs.camera.body_points import BodyPoints
from omote.inputs.camera.body_tracker import REST_SECONDS, BodyReading, BodyTracker
from omote.inputs.camera.solve_body import ELBOW, WRIST, solve_body
from tests.inputs.camera.bodies import FIGURES, filmed_body, joints_of

STAND, WAVE = (joints_of(FIGURES.poses[name]) for name in ("stand", "wave"))
RATE = 30


def follow(tracker: BodyTracker, joints: object, begin: float, seconds: float, **more: object) -> list[BodyReading]:
    """Readings of a film. joints: of a pose; more: of `filmed_body`."""
    times = begin + np.arange(round(seconds * RATE)) / RATE
    return [tracker.step(filmed_body(joints, float(time), **more)) for time in times]  # type: ignore[arg-type]


@pytest.fixture
def tracker() -> BodyTracker:
    """One that knows its performer at rest, at second 2.5."""
    tracker = BodyTracker()
    assert all(not reading.shares for reading in follow(tracker, STAND, 0.0, REST_SECONDS))
    follow(tracker, STAND, REST_SECONDS, 0.5)
    assert tracker.rest is not None
    return tracker


def test_a_body_that_is_seen_is_taken_over_without_a_pop(tracker: BodyTracker) -> None:
    shares = [reading.shares["arm_left"] for reading in follow(tracker, STAND, 2.5, 2.0)]
    assert shares[-1] == pytest.approx(1.0, abs=0.01)
    assert (np.diff(shares) >= 0.0).all()


def test_an_arm_that_leaves_the_picture_fades_to_what_is_called_and_keeps_its_last_bones(tracker: BodyTracker) -> None:
    before = follow(tracker, WAVE, 2.5, 3.0)[-1]
    gone = follow(tracker, WAVE, 5.5, 2.0, hidden=(ELBOW, WRIST))
    shares = [before.shares["arm_left"], *(reading.shares.get("arm_left", 0.0) for reading in gone)]
    assert np.abs(np.diff(shares)).max() < 0.3
    assert shares[-1] == 0.0
    assert gone[-1].shares["arm_right"] == pytest.approx(1.0, abs=0.01)
    assert gone[-1].bones["leftUpperArm"] == pytest.approx(before.bones["leftUpperArm"])
    nobody = [tracker.step(BodyPoints(None, 640, 480, 7.5 + step / RATE)) for step in range(3 * RATE)]
    assert (nobody[-1].shares, nobody[-1].bones) == ({}, {})


def test_noise_at_rest_is_held_still_and_a_wave_is_followed(tracker: BodyTracker) -> None:
    still = follow(tracker, STAND, 2.5, 4.0, noise=0.01)
    assert tracker.rest is not None
    frames = (filmed_body(STAND, 10.0 + step / RATE, noise=0.01) for step in range(60))
    raw = _shaking([solve_body(frame, tracker.rest).bones["leftUpperArm"] for frame in frames])
    assert _shaking([reading.bones["leftUpperArm"] for reading in still[RATE:]]) < 0.35 * raw
    waved = follow(tracker, WAVE, 6.5, 1.0)
    arms = Rotation.from_quat([reading.bones["rightUpperArm"] for reading in waved])
    left = (arms[-1].inv() * arms).magnitude() / (arms[-1].inv() * arms[0]).magnitude()
    assert left[RATE // 3] < 0.15, "of the way, a third of a second later"


def _shaking(quaternions: list[Values]) -> float:
    """The median turn from one picture to the next, radians."""
    turns = Rotation.from_quat(quaternions)
    return float(np.median((turns[1:] * turns[:-1].inv()).magnitude()))


def test_how_a_performer_is_at_rest_can_be_measured_again(tracker: BodyTracker) -> None:
    bent = joints_of(FIGURES.poses["small_bow"])
    tracker.measure_again()
    follow(tracker, bent, 2.5, REST_SECONDS + 1.0)
    spine = Rotation.from_quat(follow(tracker, bent, 5.6, 2.0)[-1].bones["spine"])
    assert spine.magnitude() < 0.01
