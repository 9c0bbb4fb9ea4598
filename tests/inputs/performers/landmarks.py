"""Frames of landmarks for tests: a face as MediaPipe's generic one, its mouth open as told."""

from __future__ import annotations

import numpy as np

from omote.inputs.camera.landmark_frame import LANDMARKS, LandmarkFrame, write_landmark_frame
from omote.inputs.trackers.tracker_frame import TrackerFrame

_ROWS = np.arange(LANDMARKS)
_RING = np.stack(
    [0.5 + 0.1 * np.cos(_ROWS), 0.5 + 0.15 * np.sin(_ROWS * 1.7), 0.02 * np.cos(_ROWS * 2.3)], axis=1
).astype(np.float32)


def landmarks(time: float, *, found: bool = True, jaw: float = 0.0) -> LandmarkFrame:
    """A frame; jaw: how far the lower lip's points go down, of the picture's height."""
    points = _RING.copy()
    points[[14, 17, 87, 317, 178, 402, 152], 1] += jaw
    return LandmarkFrame(points if found else None, 640, 480, time)


def packet(time: float, *, found: bool = True, jaw: float = 0.0) -> bytes:
    """The same as a page sends it."""
    return write_landmark_frame(landmarks(time, found=found, jaw=jaw))


class PlainTracker:
    """In place of the tracker: a jaw as open as `jaw` was, ten times; what is tested here is not how faces are read."""

    def __init__(self, calibration: object) -> None:
        assert calibration is not None

    def step(self, frame: LandmarkFrame) -> TrackerFrame:
        if frame.points is None:
            return TrackerFrame(found=False, time=frame.time)
        return TrackerFrame({"jawOpen": float(10.0 * (frame.points[14, 1] - _RING[14, 1]))}, time=frame.time)
