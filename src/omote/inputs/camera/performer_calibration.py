"""What is known of one performer's face: how it rests, and how it looks at the steps of the guided minute.

Faces are kept, not what the map made of them: a better map reads the same faces.
"""

from __future__ import annotations

import base64
import binascii
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.face_features import pose_row
from omote.inputs.camera.guided_steps import NEUTRAL, STEPS
from omote.inputs.camera.head_pose import fit_pose, metric_points, normal_face
from omote.inputs.camera.landmark_frame import LANDMARKS, LandmarkFrame

FEWEST = 5
"""Frames with a face that a step is measured from."""
VERSION = 1


class CalibrationError(ValueError):
    """What was recorded cannot calibrate, or what was stored is no calibration, and why."""


@dataclass(frozen=True, eq=False)
class FaceInStep:
    """A face (478, 3), its head's turn undone, in sizes of the face, and the row (6,) of its pose (`pose_row`)."""

    face: Values
    pose: Values

    def __post_init__(self) -> None:
        """Rejects what is no face."""
        for name, shape in (("face", (LANDMARKS, 3)), ("pose", (6,))):
            values = np.array(getattr(self, name), np.float64)
            if values.shape != shape or not np.isfinite(values).all():
                raise CalibrationError(
                    f"the {name} of a step has shape {values.shape}; expected {shape} finite numbers"
                )
            values.setflags(write=False)
            object.__setattr__(self, name, values)


@dataclass(frozen=True, eq=False)
class PerformerCalibration:
    """A performer's face at rest, and at other steps of the guided minute by name."""

    rest: FaceInStep
    steps: Mapping[str, FaceInStep] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Rejects steps that nobody knows."""
        if unknown := set(self.steps) - set(STEPS):
            raise CalibrationError(f"there is no step {sorted(unknown)[0]!r}; expected {', '.join(STEPS)}")
        object.__setattr__(self, "steps", MappingProxyType(dict(self.steps)))

    def to_json(self) -> str:
        """Text that `from_json` reads."""
        faces = {NEUTRAL: self.rest, **self.steps}
        return json.dumps({"version": VERSION, "faces": {name: _encode(one) for name, one in faces.items()}})

    @classmethod
    def from_json(cls, text: str) -> PerformerCalibration:
        """The calibration in a text of `to_json`; CalibrationError where it is none of this version."""
        try:
            stored = json.loads(text)
            version = stored["version"]
            faces = stored["faces"]
            if version != VERSION:
                raise CalibrationError(f"it has version {version!r}, this version reads {VERSION}: calibrate again")
            read = {str(name): _decode(face) for name, face in faces.items()}
            return cls(read.pop(NEUTRAL), read)
        except CalibrationError:
            raise
        except (KeyError, TypeError, ValueError, AttributeError, binascii.Error) as error:
            raise CalibrationError(f"it is no calibration of a performer ({error!r}); calibrate again") from error


def average_rest(frames: Sequence[LandmarkFrame]) -> FaceInStep:
    """The face at rest in some frames; CalibrationError where too few of them show a face."""
    seen = _seen(frames, NEUTRAL)
    first = normal_face(seen[0])
    rest = normal_face(np.median([fit_pose(points, first).undo(points) for points in seen], axis=0))
    return _average(seen, rest)


def fit_calibration(steps: Mapping[str, Sequence[LandmarkFrame]]) -> PerformerCalibration:
    """The calibration by a guided minute.

    Parameters
    ----------
    steps : mapping of sequences of LandmarkFrame
        By the name of the step (STEPS); neutral must be there, others may be missing.

    Returns
    -------
    PerformerCalibration
        The median face of each step.

    Raises
    ------
    CalibrationError
        Where a step shows no face, or has a name that nobody knows.
    """
    if unknown := set(steps) - set(STEPS):
        raise CalibrationError(f"there is no step {sorted(unknown)[0]!r}; expected {', '.join(STEPS)}")
    rest = average_rest(steps.get(NEUTRAL, ()))
    others = {name: _average(_seen(frames, name), rest.face) for name, frames in steps.items() if name != NEUTRAL}
    return PerformerCalibration(rest, others)


def _seen(frames: Sequence[LandmarkFrame], step: str) -> list[Values]:
    seen = [metric_points(frame) for frame in frames if frame.found]
    if len(seen) < FEWEST:
        raise CalibrationError(
            f"{len(seen)} of {len(frames)} frames of the step {step!r} show a face; expected {FEWEST} at least: "
            "give more light, face the camera, and do it again"
        )
    return seen


def _average(seen: list[Values], rest: Values) -> FaceInStep:
    poses = [fit_pose(points, rest) for points in seen]
    faces = [pose.undo(points) for pose, points in zip(poses, seen, strict=True)]
    return FaceInStep(np.median(faces, axis=0), np.median([pose_row(pose) for pose in poses], axis=0))


def _encode(one: FaceInStep) -> dict[str, object]:
    return {"face": base64.b64encode(one.face.astype("<f4").tobytes()).decode(), "pose": one.pose.tolist()}


def _decode(stored: Mapping[str, object]) -> FaceInStep:
    face = np.frombuffer(base64.b64decode(str(stored["face"]), validate=True), "<f4")
    return FaceInStep(face.reshape(-1, 3).astype(np.float64), np.array(stored["pose"], np.float64))
