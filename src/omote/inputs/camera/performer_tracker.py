"""One performer before a camera: frames of landmarks in, frames of a tracker out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.inputs.camera.head_pose import fit_pose, metric_points, normal_face
from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.camera.landmark_groups import CORNERS, LIDS, LIPS_APART, MOUTH_CORNERS
from omote.inputs.camera.performer_calibration import PerformerCalibration
from omote.inputs.trackers.tracker_frame import TrackerFrame

Values = NDArray[np.float64]
REST_SECONDS = 2.0
"""How long a face at rest is averaged where no calibration says it."""


class PerformerTracker:
    """Follows one performer. ready: whether the face at rest is known; until then frames have no weights."""

    def __init__(self, calibration: PerformerCalibration | None = None) -> None:
        self._rest = None if calibration is None else calibration.rest
        self._seen: list[Values] = []
        self._began: float | None = None

    @property
    def ready(self) -> bool:
        """Whether the face at rest is known."""
        return self._rest is not None

    def step(self, frame: LandmarkFrame) -> TrackerFrame:
        """What a frame shows: weights of units, head and gaze (radians, in our signs)."""
        if not frame.found:
            return TrackerFrame(found=False, time=frame.time)
        points = metric_points(frame)
        if self._rest is None:
            self._wait(points, frame.time)
        if self._rest is None:
            return TrackerFrame(time=frame.time)
        pose = fit_pose(points, self._rest)
        return TrackerFrame(_crude_weights(pose.undo(points), self._rest), pose.angles, None, time=frame.time)

    def _wait(self, points: Values, time: float) -> None:
        """Takes the first seconds as the face at rest."""
        self._began = time if self._began is None or time < self._began else self._began
        self._seen.append(normal_face(points))
        if time - self._began >= REST_SECONDS:
            self._rest = np.median(self._seen, axis=0)
            self._seen.clear()


def _crude_weights(face: Values, rest: Values) -> dict[str, float]:
    found = {}
    for side, (upper, lower) in LIDS.items():
        inner, outer = CORNERS[side]
        gap, before = (
            np.linalg.norm(one[upper[2:5]] - one[lower[2:5]], axis=1).mean() / np.linalg.norm(one[inner] - one[outer])
            for one in (face, rest)
        )
        found[f"eyeBlink{side}"] = _clip((1.0 - gap / before - 0.15) / 0.5)
    apart, closed = (np.mean([np.linalg.norm(one[a] - one[b]) for a, b in LIPS_APART]) for one in (face, rest))
    found["jawOpen"] = _clip((apart - closed) / 0.5)
    for side, row in zip(("Left", "Right"), MOUTH_CORNERS, strict=True):
        found[f"mouthSmile{side}"] = _clip((face[row, 1] - rest[row, 1]) / 0.12)
    wide, narrow = (np.linalg.norm(one[MOUTH_CORNERS[0]] - one[MOUTH_CORNERS[1]]) for one in (face, rest))
    found["mouthPucker"] = _clip((1.0 - wide / narrow) / 0.3)
    return found


def _clip(value: float) -> float:
    return float(min(1.0, max(0.0, value)))
