"""Whether a face that was taken as at rest was at rest: what it does instead, in a sentence with what to do."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.face_features import lid_openings
from omote.inputs.camera.landmark_groups import LIPS_APART, MOUTH_CORNERS
from omote.inputs.camera.performer_calibration import PerformerCalibration
from omote.model.fitting.photographs.face_at_rest import EYES_SHUT, MOUTH_OPEN, measure_mouth

SMILES = 0.09
"""How far the corners of the mouth lie above the middle of its lips, of its width. Of heads of ours: at rest -.03 to
.034, in a whole smile .10 to .19; two that were sculpted with a smile have .084 and .104 at rest."""


def advise_on_rest(calibration: PerformerCalibration, /) -> str:
    """What a performer's face at rest does that it should not; "" where it rests."""
    face = calibration.rest.face
    does = []
    if measure_mouth(face) > MOUTH_OPEN:
        does.append("the mouth open")
    if max(float(lid_openings(face, side)[2:5].mean()) for side in ("Left", "Right")) < EYES_SHUT:
        does.append("the eyes shut")
    if _lift_of_corners(face) > SMILES:
        does.append("a smile")
    if not does:
        return ""
    return (
        f"Your face at rest has {' and '.join(does)}: only more than that counts. Do it again: lips together, eyes "
        "open, no smile. If you always look so, leave it."
    )


def _lift_of_corners(face: Values) -> float:
    left, right = MOUTH_CORNERS
    corners = 0.5 * (face[left] + face[right])
    middle = face[list(LIPS_APART[0])].mean(axis=0)
    return float((corners - middle)[1]) / max(float(np.linalg.norm(face[left] - face[right])), 1e-6)
