"""What is known of one performer's face: how it rests, and how far it goes."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.inputs.camera.head_pose import metric_points, normal_face
from omote.inputs.camera.landmark_frame import LANDMARKS, LandmarkFrame

Values = NDArray[np.float64]
STEPS = (
    "neutral", "shut", "wide", "smile", "pucker", "aa", "ee", "oo", "browsUp", "browsDown", "left", "right", "up",
    "down", "puff",
)  # fmt: skip
"""What the guided minute asks for, in this order; left, right, up and down by the eyes only."""
FEWEST = 5
"""Frames with a face that a face at rest is measured from."""
VERSION = 1


class CalibrationError(ValueError):
    """What was recorded cannot calibrate, or what was stored is no calibration, and why."""


@dataclass(frozen=True, eq=False)
class PerformerCalibration:
    """A performer's face. rest (478, 3): as `normal_face` gives it; gains: of weights, by unit."""

    rest: Values
    gains: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Rejects a face that is none."""
        rest = np.array(self.rest, np.float64)
        if rest.shape != (LANDMARKS, 3) or not np.isfinite(rest).all():
            raise CalibrationError(f"the face at rest has shape {rest.shape}; expected ({LANDMARKS}, 3) finite numbers")
        rest.setflags(write=False)
        object.__setattr__(self, "rest", rest)

    def to_json(self) -> str:
        """Text that `from_json` reads."""
        rest = np.round(self.rest, 5).tolist()
        return json.dumps({"version": VERSION, "rest": rest, "gains": dict(self.gains)})

    @classmethod
    def from_json(cls, text: str) -> PerformerCalibration:
        """The calibration in a text of `to_json`; CalibrationError where it is none of this version."""
        try:
            stored = json.loads(text)
            if stored["version"] != VERSION:
                raise CalibrationError(f"it has version {stored['version']}, this version reads {VERSION}: calibrate again")
            return cls(np.array(stored["rest"], np.float64), {str(k): float(v) for k, v in stored["gains"].items()})
        except (KeyError, TypeError, ValueError) as error:
            if isinstance(error, CalibrationError):
                raise
            raise CalibrationError(f"it is no calibration of a performer ({error!r}); calibrate again") from error


def average_rest(frames: Sequence[LandmarkFrame]) -> Values:
    """The face at rest in some frames; CalibrationError where too few of them show a face."""
    seen = [normal_face(metric_points(frame)) for frame in frames if frame.found]
    if len(seen) < FEWEST:
        raise CalibrationError(
            f"{len(seen)} of {len(frames)} frames at rest show a face; expected {FEWEST} at least: more light, face the camera"
        )
    result: Values = np.median(seen, axis=0)
    return result


def fit_calibration(steps: Mapping[str, Sequence[LandmarkFrame]]) -> PerformerCalibration:
    """The calibration by a guided minute. steps: frames by the name of the step (STEPS); neutral must be there, others
    may be missing. CalibrationError where neutral shows no face, or a step has a name that nobody knows."""
    if unknown := set(steps) - set(STEPS):
        raise CalibrationError(f"there is no step {sorted(unknown)[0]!r}; expected {', '.join(STEPS)}")
    return PerformerCalibration(average_rest(steps.get("neutral", ())))
