"""A face at rest that smiles, or has its mouth open or its eyes shut, is said to be none."""

from __future__ import annotations

import numpy as np
import pytest

from omote.inputs.camera.landmark_groups import LIDS, LIPS_APART, MOUTH_CORNERS
from omote.inputs.camera.performer_calibration import FaceInStep, PerformerCalibration
from omote.inputs.camera.rest_check import advise_on_rest
from tests.inputs.camera.heads import mean_face


def advice(face: np.ndarray) -> str:
    return advise_on_rest(PerformerCalibration(FaceInStep(face, np.zeros(6))))


def height(face: np.ndarray) -> float:
    return float(np.linalg.norm(face[10] - face[152]))


def smiling(face: np.ndarray) -> None:
    width = np.linalg.norm(face[MOUTH_CORNERS[0]] - face[MOUTH_CORNERS[1]])
    face[list(MOUTH_CORNERS), 1] += 0.15 * width


def agape(face: np.ndarray) -> None:
    face[[lower for _, lower in LIPS_APART], 1] -= 0.08 * height(face)


def asleep(face: np.ndarray) -> None:
    for upper, lower in LIDS.values():
        face[upper] = face[lower]


@pytest.mark.parametrize(
    ("does", "said"), [(smiling, "has a smile:"), (agape, "the mouth open"), (asleep, "has the eyes shut:")]
)
def test_a_face_that_does_something_is_told_what(does: object, said: str) -> None:
    assert advice(mean_face()) == "", "the mean of all who were seen at rest"
    face = mean_face()
    does(face)  # type: ignore[operator]
    assert said in advice(face)
    assert "lips together, eyes open, no smile" in advice(face)


def test_one_eye_that_winks_is_no_sleep() -> None:
    face = mean_face()
    upper, lower = LIDS["Left"]
    face[upper] = face[lower]
    assert advice(face) == ""
