"""One performer before one page: at rest first, then frames of a tracker; what is wrong is said."""

import numpy as np
import pytest

from omote.inputs.camera.landmark_frame import LandmarkError
from omote.inputs.camera.landmark_groups import LIPS_APART
from omote.inputs.camera.performer_calibration import FaceInStep, PerformerCalibration
from omote.inputs.performers.calibration_steps import CALIBRATION_STEPS
from omote.inputs.performers.camera_performer import MOST_WAITING, CameraPerformer
from tests.inputs.camera.heads import mean_face
from tests.inputs.performers.landmarks import packet

FRAME = 1.0 / 30.0


def show(performer: CameraPerformer, seconds: float, now: float = 0.0, *, jaw: float = 0.0) -> float:
    for _ in range(round(seconds / FRAME)):
        now += FRAME
        performer.receive(packet(now, jaw=jaw))
        performer.read(now)
    return now


@pytest.fixture
def performer() -> CameraPerformer:
    made = CameraPerformer("Ada")
    made.use(None, "no")
    return made


def test_nothing_moves_until_two_seconds_at_rest_were_seen(performer: CameraPerformer) -> None:
    now = show(performer, 1.9)
    assert performer.take_fit() is None
    show(performer, 0.3, now)
    fit = performer.take_fit()
    assert fit is not None
    assert performer.take_fit() is None
    assert (fit.performer, fit.guided, performer.fitting, performer.weights) == ("Ada", False, True, {})
    performer.use(fit.fit(), "rest")
    assert performer.guide is None
    performer.receive(packet(9.0, jaw=0.05))
    (frame,) = performer.read(9.0)
    assert (frame.subject, frame.found) == ("Ada", True)
    assert performer.weights == dict(frame.weights)
    assert performer.weights


def test_a_face_that_is_lost_is_said_and_the_weights_stay(performer: CameraPerformer) -> None:
    now = show(performer, 2.2)
    fit = performer.take_fit()
    assert fit is not None
    performer.use(fit.fit(), "rest")
    show(performer, 0.1, now, jaw=0.05)
    before = performer.weights
    performer.receive(packet(now + 1.0, found=False))
    (frame,) = performer.read(now + 1.0)
    assert not frame.found
    assert not performer.found
    assert performer.weights == before


def test_a_guide_that_is_cancelled_leaves_what_was(performer: CameraPerformer) -> None:
    performer.begin_guide(rest=False)
    performer.cancel_guide()
    step = performer.guide.step() if performer.guide else None
    assert step is not None
    assert (step.step, step.of) == ("neutral", 1)  # nothing is known of the face: it is looked at, at rest
    show(performer, 2.2)
    fit = performer.take_fit()
    assert fit is not None
    performer.use(fit.fit(), "rest")
    performer.begin_guide(rest=False)
    performer.cancel_guide()
    assert performer.guide is None


def test_the_guided_minute_is_shown_and_a_step_made_again(performer: CameraPerformer) -> None:
    with pytest.raises(ValueError, match="begin the guided minute"):
        performer.redo("aa")
    performer.begin_guide(rest=False)
    now = show(performer, 70.0)
    fit = performer.take_fit()
    assert fit is not None
    assert fit.guided
    assert list(fit.frames) == list(CALIBRATION_STEPS) == performer.redoable
    performer.redo("aa")
    step = performer.guide.step() if performer.guide else None
    assert step is not None
    assert (step.step, step.phase, step.number, step.of) == ("aa", "ready", len(CALIBRATION_STEPS), 15)
    show(performer, 5.0, now)
    again = performer.take_fit()
    assert again is not None
    assert again.frames["aa"] != fit.frames["aa"]
    assert again.frames["ee"] == fit.frames["ee"]


def test_a_guided_minute_that_is_ended_keeps_its_faces_and_goes_on(performer: CameraPerformer) -> None:
    performer.begin_guide(rest=False)
    assert (performer.redoable, performer.missing, performer.unused) == ([], [], False)
    now = show(performer, 12.0)
    made = performer.redoable
    assert 0 < len(made) < len(CALIBRATION_STEPS)
    performer.cancel_guide()
    assert (performer.redoable, performer.unused) == (made, True)
    assert [*made, *performer.missing] == list(CALIBRATION_STEPS)
    performer.continue_guide()
    step = performer.guide.step() if performer.guide else None
    assert step is not None
    assert (step.step, step.number, step.done) == (performer.missing[0], len(made) + 1, made)
    show(performer, 70.0, now)
    fit = performer.take_fit()
    assert fit is not None
    assert list(fit.frames) == list(CALIBRATION_STEPS)
    assert (performer.missing, performer.unused) == ([], False)
    with pytest.raises(ValueError, match="all faces are made"):
        performer.continue_guide()


def test_a_guided_minute_is_used_only_when_it_is_whole_or_asked_for(performer: CameraPerformer) -> None:
    with pytest.raises(ValueError, match="begin the guided minute"):
        performer.use_faces()
    performer.begin_guide(rest=False)
    with pytest.raises(ValueError, match="no face is made yet"):
        performer.use_faces()
    show(performer, 12.0)
    made = performer.redoable
    performer.cancel_guide()
    assert performer.take_fit() is None
    performer.use_faces()
    fit = performer.take_fit()
    assert fit is not None
    assert (fit.guided, list(fit.frames), performer.unused) == (True, made, False)


def test_a_step_that_is_made_again_and_given_up_stays_as_it_was(performer: CameraPerformer) -> None:
    performer.begin_guide(rest=False)
    show(performer, 70.0)
    assert performer.take_fit() is not None
    performer.redo("aa")
    performer.cancel_guide()
    assert performer.redoable == list(CALIBRATION_STEPS)
    assert not performer.unused


def test_what_is_no_frame_is_said(performer: CameraPerformer) -> None:
    performer.receive(b"OMLM but no more")
    with pytest.raises(LandmarkError):
        performer.read(0.0)


def test_frames_that_nobody_reads_push_the_oldest_out(performer: CameraPerformer) -> None:
    for count in range(3 * MOST_WAITING):
        performer.receive(packet(count * FRAME))
    performer.read(0.0)
    assert performer.heard == 3 * MOST_WAITING


def test_a_rest_that_is_none_is_said_until_another_is_taken() -> None:
    performer = CameraPerformer("Ada")
    agape = mean_face()
    agape[[lower for _, lower in LIPS_APART], 1] -= 0.3
    performer.use(PerformerCalibration(FaceInStep(agape, np.zeros(6))), "rest")
    assert "the mouth open" in performer.unrest
    performer.use(PerformerCalibration(FaceInStep(mean_face(), np.zeros(6))), "rest")
    assert performer.unrest == ""
    performer.use(None, "no")
    assert performer.unrest == ""
