"""One performer before a camera: frames of landmarks in, frames of a tracker out."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.face_features import pose_row
from omote.inputs.camera.head_pose import fit_pose, metric_points
from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.camera.landmark_map import UNITS, load_landmark_map
from omote.inputs.camera.one_euro import OneEuroFilter, Smoothing
from omote.inputs.camera.performer_calibration import FEWEST, PerformerCalibration, average_rest
from omote.inputs.camera.personal_map import PersonalMap
from omote.inputs.trackers.head_angles import limit_gaze, limit_head
from omote.inputs.trackers.tracker_frame import TrackerFrame

REST_SECONDS = 2.0
"""How long a face at rest is averaged where no calibration says it."""
SHUT = 0.6
"""Of both lids: behind them nobody sees where the eyes look, and the gaze stays."""
_GAZE = slice(len(UNITS), len(UNITS) + 2)
_HEAD = slice(len(UNITS) + 2, len(UNITS) + 5)


class PerformerTracker:
    """Follows one performer; without a calibration the first two seconds are taken as their face at rest."""

    def __init__(self, calibration: PerformerCalibration | None = None, smoothing: Smoothing | None = None) -> None:
        self._filter = OneEuroFilter(smoothing or Smoothing())
        self._seen: list[LandmarkFrame] = []
        self._rest: Values | None = None
        self._gaze = np.zeros(2)
        if calibration is not None:
            self._begin(calibration)

    @property
    def ready(self) -> bool:
        """Whether the face at rest is known; until then frames have no weights."""
        return self._rest is not None

    def step(self, frame: LandmarkFrame) -> TrackerFrame:
        """What a frame shows.

        Parameters
        ----------
        frame : LandmarkFrame
            The newest, later than those before.

        Returns
        -------
        TrackerFrame
            Weights of units, head and gaze (radians, in our signs) and the frame's time; found is False where the frame
            shows no face.
        """
        if not frame.found:
            self._filter.reset()
            return TrackerFrame(found=False, time=frame.time)
        if self._rest is None:
            self._wait(frame)
        if self._rest is None:
            return TrackerFrame(time=frame.time)
        points = metric_points(frame)
        pose = fit_pose(points, self._rest)
        outputs = self._map.estimate(pose.undo(points), pose_row(pose))
        return self._answer(outputs, frame.time)

    def _answer(self, outputs: Values, time: float) -> TrackerFrame:
        lids = dict(zip(UNITS, outputs[: len(UNITS)].tolist(), strict=True))
        if min(lids["eyeBlinkLeft"], lids["eyeBlinkRight"]) > SHUT:
            outputs[_GAZE] = self._gaze
        self._gaze = outputs[_GAZE].copy()
        outputs[: len(UNITS)] = np.clip(outputs[: len(UNITS)], 0.0, 1.0)
        smooth = self._filter.follow(outputs, time)
        weights = dict(zip(UNITS, np.clip(smooth[: len(UNITS)], 0.0, 1.0).tolist(), strict=True))
        yaw, pitch, roll = smooth[_HEAD].tolist()
        right, up = smooth[_GAZE].tolist()
        return TrackerFrame(weights, limit_head((yaw, pitch, roll)), limit_gaze((right, up)), time=time)

    def _wait(self, frame: LandmarkFrame) -> None:
        """Takes the first seconds as the face at rest."""
        if self._seen and frame.time < self._seen[0].time:
            self._seen.clear()
        self._seen.append(frame)
        if frame.time - self._seen[0].time >= REST_SECONDS and len(self._seen) >= FEWEST:
            self._begin(PerformerCalibration(average_rest(self._seen)))
            self._seen.clear()

    def _begin(self, calibration: PerformerCalibration) -> None:
        self._rest = calibration.rest.face
        self._map = PersonalMap(load_landmark_map(), calibration)
