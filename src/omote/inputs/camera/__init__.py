"""The performer's face from a camera: landmarks in, weights, head and gaze out."""

from omote.inputs.camera.landmark_frame import LandmarkError, LandmarkFrame, read_landmark_frame, write_landmark_frame
from omote.inputs.camera.performer_calibration import CalibrationError, PerformerCalibration, fit_calibration
from omote.inputs.camera.performer_tracker import PerformerTracker

__all__ = [
    "CalibrationError",
    "LandmarkError",
    "LandmarkFrame",
    "PerformerCalibration",
    "PerformerTracker",
    "fit_calibration",
    "read_landmark_frame",
    "write_landmark_frame",
]
