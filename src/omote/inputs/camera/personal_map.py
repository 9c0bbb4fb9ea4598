"""The map as one performer wears it: zero at their rest, and what is asked for at the steps of the guided minute."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.guided_steps import GUIDED, LOOKS, guided_weights
from omote.inputs.camera.landmark_map import UNITS, LandmarkMap
from omote.inputs.camera.performer_calibration import FaceInStep, PerformerCalibration

DOUBT = 3.0
"""How little the guided steps count against the map, over their own size (the ridge of the correction)."""
GAZE = slice(len(UNITS), len(UNITS) + 2)
TRUST = 0.3
"""How far the slope of the gaze goes to what the guided looks say: nobody looks just where they are asked to."""
SLOPES = (0.6, 1.8)
"""How much less or more than on average a performer's eyes may show where they look."""
BLINKS = [UNITS.index(f"eyeBlink{side}") for side in ("Left", "Right")]
WEAKEST_SHUT = 0.5
"""What the map gives at least for lids that are shut; less is no blink."""


class PersonalMap:
    """Faces of one performer to weights, gaze and head.

    The correction is a ridge regression on the network's last layer, from what the map lacks at the guided steps; the
    gaze is stretched towards where the eyes were asked to look, about where they look at rest.
    """

    def __init__(self, general: LandmarkMap, calibration: PerformerCalibration) -> None:
        self._map = general
        self._rest = calibration.rest.face
        hidden, outputs = self._read(calibration.rest)
        self._hidden = hidden
        self._outputs = outputs.copy()
        self._outputs[len(UNITS) + 2 :] = 0.0  # the head's own angles are absolute
        self._correction = self._correct(calibration)
        self._lids = self._stretch_lids(calibration)
        self._looks = np.array(
            [self._slope(calibration, 0, "left", "right"), self._slope(calibration, 1, "up", "down")]
        )

    def estimate(self, face: Values, pose: Values) -> Values:
        """Outputs of the map (weights, gaze, head) for a face (478, 3) and the row (6,) of its pose."""
        hidden, outputs = self._read(FaceInStep(face, pose))
        outputs = outputs - self._outputs
        if self._correction is not None:
            outputs[: len(UNITS)] += (hidden - self._hidden) @ self._correction
        outputs[BLINKS] *= self._lids
        outputs[GAZE] *= self._looks
        return outputs

    def _read(self, one: FaceInStep) -> tuple[Values, Values]:
        features = self._map.compression.features(one.face, self._rest, one.pose)
        return self._map.read_hidden(features), self._map.estimate(features)

    def _correct(self, calibration: PerformerCalibration) -> Values | None:
        steps = [name for name in GUIDED if name in calibration.steps]
        if not steps:
            return None
        read = [self._read(calibration.steps[name]) for name in steps]
        moved = np.array([hidden - self._hidden for hidden, _ in read])
        lacks = np.array([guided_weights(name) for name in steps])
        lacks -= np.array([outputs - self._outputs for _, outputs in read])[:, : len(UNITS)]
        kernel = moved @ moved.T
        ridge = DOUBT * np.trace(kernel) / len(kernel) * np.eye(len(kernel))
        result: Values = moved.T @ np.linalg.solve(kernel + ridge, lacks)
        return result

    def _stretch_lids(self, calibration: PerformerCalibration) -> Values:
        if "shut" not in calibration.steps:
            return np.ones(2)
        hidden, outputs = self._read(calibration.steps["shut"])
        shut = (outputs - self._outputs)[BLINKS]
        if self._correction is not None:
            shut = shut + ((hidden - self._hidden) @ self._correction)[BLINKS]
        result: Values = 1.0 / np.clip(shut, WEAKEST_SHUT, 1.2)
        return result

    def _slope(self, calibration: PerformerCalibration, axis: int, first: str, second: str) -> float:
        """What carries the map's reading of the eyes at two steps towards where they were asked to look."""
        if not {first, second} <= set(calibration.steps):
            return 1.0
        read = [self._read(calibration.steps[name])[1][GAZE.start + axis] for name in (first, second)]
        asked = LOOKS[first][axis] - LOOKS[second][axis]
        slope = float(np.clip(asked / max(float(read[0] - read[1]), 1e-3), *SLOPES))
        return 1.0 + TRUST * (slope - 1.0)
