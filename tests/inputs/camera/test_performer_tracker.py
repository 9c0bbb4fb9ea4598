"""A performer is followed after two seconds, or at once where their face is known."""

import numpy as np
import pytest

from omote.inputs.camera import (
    LandmarkFrame,
    PerformerTracker,
    fit_calibration,
    read_landmark_frame,
    write_landmark_frame,
)
from omote.inputs.camera.landmark_groups import LIDS
from omote.inputs.camera.landmark_map import UNITS
from omote.inputs.camera.performer_tracker import REST_SECONDS
from tests.inputs.camera.heads import frame_of, mean_face

RATE = 30
CALIBRATION = fit_calibration({"neutral": [frame_of(mean_face())] * 6})
DRAW = np.random.default_rng(5)


def shaking(time: float, face: np.ndarray | None = None, noise: float = 0.0015) -> LandmarkFrame:
    """A frame whose points shake as the model's do."""
    shown = mean_face() if face is None else face
    return frame_of(shown + DRAW.normal(0.0, noise, shown.shape), time=time)


def winking() -> np.ndarray:
    face = mean_face()
    upper, lower = LIDS["Left"]
    face[upper] = face[lower] + [0.0, 0.01, 0.0]
    return face


def test_the_first_two_seconds_are_the_face_at_rest() -> None:
    tracker = PerformerTracker()
    for step in range(int(REST_SECONDS * RATE)):
        assert tracker.step(shaking(step / RATE)).weights == {}
        assert not tracker.ready
    seen = tracker.step(shaking(REST_SECONDS))
    assert tracker.ready
    assert set(seen.weights) == set(UNITS)
    assert max(seen.weights.values()) < 0.15


def test_a_known_performer_is_followed_at_once() -> None:
    tracker = PerformerTracker(CALIBRATION)
    assert tracker.ready
    seen = tracker.step(frame_of(winking(), time=3.0))
    assert seen.weights["eyeBlinkLeft"] > seen.weights["eyeBlinkRight"] + 0.2
    assert seen.time == 3.0


def test_the_head_comes_in_our_signs() -> None:
    for head in ((0.3, 0.0, 0.0), (0.0, 0.25, 0.0), (0.0, 0.0, 0.3)):
        seen = PerformerTracker(CALIBRATION).step(frame_of(mean_face(), head))
        assert seen.head is not None
        axis = int(np.argmax(head))
        assert int(np.argmax(np.abs(seen.head))) == axis
        assert seen.head[axis] > 0.05


def test_a_picture_without_a_face_is_no_face() -> None:
    tracker = PerformerTracker(CALIBRATION)
    seen = tracker.step(LandmarkFrame(None, 640, 480, 1.0))
    assert not seen.found
    assert seen.weights == {}


def test_waiting_counts_only_what_shows_a_face() -> None:
    tracker = PerformerTracker()
    for step in range(3 * RATE):
        tracker.step(LandmarkFrame(None, 640, 480, step / RATE))
    assert not tracker.ready


def test_a_clock_that_begins_anew_begins_the_rest_anew() -> None:
    tracker = PerformerTracker()
    for step in range(RATE):
        tracker.step(shaking(100.0 + step / RATE))
    tracker.step(shaking(0.0))
    tracker.step(shaking(1.0))
    assert not tracker.ready


def test_weights_on_a_still_shake_less_than_what_comes_in() -> None:
    calm = PerformerTracker(CALIBRATION)
    plain = PerformerTracker(CALIBRATION)
    rows = []
    for step in range(60):
        frame = shaking(step / RATE)
        later = LandmarkFrame(
            frame.points, frame.width, frame.height, float(step)
        )  # a second apart: nothing is filtered
        rows.append([list(each.weights.values()) for each in (calm.step(frame), plain.step(later))])
    still, raw = np.array(rows)[20:].std(axis=0)
    assert still.mean() < 0.6 * raw.mean()


def test_what_the_page_sends_plays() -> None:
    seen = PerformerTracker(CALIBRATION).step(read_landmark_frame(write_landmark_frame(frame_of(winking()))))
    assert seen.weights["eyeBlinkLeft"] == pytest.approx(
        PerformerTracker(CALIBRATION).step(frame_of(winking())).weights["eyeBlinkLeft"], abs=1e-6
    )


def test_the_same_frames_give_the_same() -> None:
    frames = [shaking(step / RATE) for step in range(5)]
    first, second = (
        [tracker.step(frame) for frame in frames]
        for tracker in (PerformerTracker(CALIBRATION), PerformerTracker(CALIBRATION))
    )
    assert first == second
