"""A performer's map gives nothing at their rest, and more of what was asked for at the steps of the guided minute."""

import numpy as np

from omote.inputs.camera.guided_steps import LOOKS
from omote.inputs.camera.landmark_groups import IRISES, LIDS, MOUTH_CORNERS
from omote.inputs.camera.landmark_map import UNITS, load_landmark_map
from omote.inputs.camera.performer_calibration import PerformerCalibration, fit_calibration
from omote.inputs.camera.personal_map import PersonalMap
from tests.inputs.camera.heads import frame_of, mean_face

SMILES = [UNITS.index(f"mouthSmile{side}") for side in ("Left", "Right")]
BLINKS = [UNITS.index(f"eyeBlink{side}") for side in ("Left", "Right")]


def smiling() -> np.ndarray:
    face = mean_face()
    for row in MOUTH_CORNERS:
        face[row] += [0.05 * np.sign(face[row, 0]), 0.06, 0.0]
    return face


def shut() -> np.ndarray:
    face = mean_face()
    for upper, lower in LIDS.values():
        face[upper] = face[lower] + [0.0, 0.02, 0.0]
    return face


def looking(x: float, y: float) -> np.ndarray:
    face = mean_face()
    for rows in IRISES.values():
        face[rows] += [x, y, 0.0]
    return face


def calibrate(**steps: np.ndarray) -> PerformerCalibration:
    faces = {"neutral": mean_face(), **steps}
    return fit_calibration({name: [frame_of(face)] * 6 for name, face in faces.items()})


def estimate(calibration: PerformerCalibration, step: str) -> np.ndarray:
    one = calibration.rest if step == "neutral" else calibration.steps[step]
    return PersonalMap(load_landmark_map(), calibration).estimate(one.face, one.pose)


def test_rest_is_nothing_and_looks_straight() -> None:
    found = estimate(calibrate(smile=smiling(), left=looking(0.05, 0), right=looking(-0.05, 0)), "neutral")
    assert np.abs(found[: len(UNITS)]).max() < 1e-9


def test_a_guided_step_brings_what_was_asked_for_nearer() -> None:
    plain = calibrate()
    guided = calibrate(smile=smiling())
    face = guided.steps["smile"]
    before, after = (
        PersonalMap(load_landmark_map(), one).estimate(face.face, face.pose)[SMILES] for one in (plain, guided)
    )
    assert (np.abs(after - 0.9) < np.abs(before - 0.9)).all()


def test_lids_that_are_shut_blink_whole() -> None:
    before = calibrate()
    after = calibrate(shut=shut())
    face = after.steps["shut"]
    weak, whole = (
        PersonalMap(load_landmark_map(), one).estimate(face.face, face.pose)[BLINKS] for one in (before, after)
    )
    assert (whole > weak).all()
    assert (whole > 0.7).all()


def test_eyes_come_nearer_to_where_they_were_asked_to_look() -> None:
    looks = {"left": (0.05, 0.0), "right": (-0.05, 0.0), "up": (0.0, 0.03), "down": (0.0, -0.03)}
    calibration = calibrate(**{step: looking(*move) for step, move in looks.items()})
    plain = calibrate()
    for first, second, axis in (("left", "right", 0), ("up", "down", 1)):
        spans = []
        for one in (plain, calibration):
            personal = PersonalMap(load_landmark_map(), one)
            ends = [
                personal.estimate(calibration.steps[step].face, calibration.steps[step].pose)
                for step in (first, second)
            ]
            spans.append(float(ends[0][len(UNITS) + axis] - ends[1][len(UNITS) + axis]))
        asked = LOOKS[first][axis] - LOOKS[second][axis]
        assert spans[0] > 0
        assert abs(spans[1] - asked) <= abs(spans[0] - asked)
