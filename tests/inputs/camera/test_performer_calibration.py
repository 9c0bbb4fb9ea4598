"""Calibrations come from frames with a face, and come back from text as they were."""

import json

import numpy as np
import pytest

from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.camera.performer_calibration import (
    FEWEST,
    CalibrationError,
    FaceInStep,
    PerformerCalibration,
    average_rest,
    fit_calibration,
)
from tests.inputs.camera.heads import frame_of, mean_face

REST = [frame_of(mean_face(), (0.02 * step, 0.0, 0.0), time=step / 30) for step in range(8)]
NOBODY = LandmarkFrame(None, 640, 480, 0.0)


def wide_mouth() -> np.ndarray:
    face = mean_face()
    face[[308, 78], 0] *= 1.2
    return face


def test_the_face_at_rest_is_found_whatever_the_head_does() -> None:
    rest = average_rest(REST).face
    assert rest == pytest.approx(mean_face() - mean_face().mean(axis=0) + rest.mean(axis=0), abs=0.02)


def test_faces_of_steps_lie_on_the_face_at_rest() -> None:
    calibration = fit_calibration({"neutral": REST, "smile": [frame_of(wide_mouth())] * FEWEST})
    moved = np.linalg.norm(calibration.steps["smile"].face - calibration.rest.face, axis=1)
    assert set(np.argsort(moved)[-2:]) == {308, 78}


def test_text_holds_all_of_it() -> None:
    calibration = fit_calibration({"neutral": REST, "smile": [frame_of(wide_mouth())] * FEWEST})
    again = PerformerCalibration.from_json(calibration.to_json())
    assert again.rest.face == pytest.approx(calibration.rest.face, abs=1e-6)
    assert again.steps["smile"].face == pytest.approx(calibration.steps["smile"].face, abs=1e-6)
    assert again.to_json() == calibration.to_json()


@pytest.mark.parametrize(("steps", "reason"), [
    ({}, "0 of 0 frames of the step 'neutral'"),
    ({"neutral": [NOBODY] * 20}, "0 of 20 frames"),
    ({"neutral": REST, "smile": [NOBODY] * 9}, "step 'smile' show a face"),
    ({"neutral": REST, "grin": REST}, "no step 'grin'"),
])  # fmt: skip
def test_what_cannot_calibrate_is_rejected(steps: dict[str, list[LandmarkFrame]], reason: str) -> None:
    with pytest.raises(CalibrationError, match=reason):
        fit_calibration(steps)


@pytest.mark.parametrize(("text", "reason"), [
    ("", "no calibration"), ("[]", "no calibration"), ('{"version": 7, "faces": {}}', "version 7"),
    ('{"version": 1, "faces": {}}', "neutral"),
    ('{"version": 1, "faces": {"neutral": {"face": "!", "pose": []}}}', "no calibration"),
    ('{"version": 1, "faces": {"neutral": {"face": "", "pose": [0,0,0,0,0,0]}}}', "shape"),
])  # fmt: skip
def test_text_that_is_no_calibration_is_rejected(text: str, reason: str) -> None:
    with pytest.raises(CalibrationError, match=reason):
        PerformerCalibration.from_json(text)


def test_text_with_an_unknown_step_is_rejected() -> None:
    stored = json.loads(fit_calibration({"neutral": REST}).to_json())
    stored["faces"]["grin"] = stored["faces"]["neutral"]
    with pytest.raises(CalibrationError, match="no step 'grin'"):
        PerformerCalibration.from_json(json.dumps(stored))


def test_a_face_that_is_none_is_rejected() -> None:
    with pytest.raises(CalibrationError, match="shape"):
        FaceInStep(np.zeros((3, 3)), np.zeros(6))
    with pytest.raises(CalibrationError, match="finite"):
        FaceInStep(np.full((478, 3), np.nan), np.zeros(6))
