"""What a face does in a photograph that shows it otherwise than at rest: its mouth open, smiling, its eyes shut."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.arrays import Values
from omote.model.fitting.photographs.photograph import Photograph

MOUTH_OPEN = 0.045
EYES_SHUT = 0.14
"""The gap of the lips, of the height of the face; of the lids, of the width of the eye. As the editor's page has them
for a turn before the camera: of heads of ours lips at rest are .03 apart at most, lids .23 at least."""
SMILES = 0.35
"""The weight of both units of a smile together, half and half."""
DIFFERENT = 0.5
"""The weight of any unit with which a face is not at rest."""
FAR = np.radians(12.0)
"""A turn of the head from which on the farther eye is not measured."""
FOREHEAD = 10
CHIN = 152
UPPER_LIP = 13
LOWER_LIP = 14
RIGHT_EYE = (33, 133, 159, 145)
LEFT_EYE = (263, 362, 386, 374)
"""Points of the face mesh: outer and inner corner, upper and lower lid."""


def describe_unrest(photograph: Photograph, yaw: float, units: Mapping[str, float], /) -> list[str]:
    """What the face of a photograph does, in words; none where it is at rest.

    photograph: with its landmarks; yaw: of the head, radians, as `PhotographCamera.yaw`; units: what the fit found it
    to do, weights by the name of an expression.
    """
    points = photograph.landmarks[:, :2]
    words = []
    if measure_mouth(points) > MOUTH_OPEN:
        words.append("its mouth open")
    if 0.5 * (units.get("mouthSmileLeft", 0.0) + units.get("mouthSmileRight", 0.0)) > SMILES:
        words.append("a smile")
    if measure_lids(points, yaw) < EYES_SHUT:
        words.append("its eyes shut")
    if not words and max(units.values(), default=0.0) > DIFFERENT:
        words.append("a face that is not at rest")
    return words


def measure_mouth(points: Values, /) -> float:
    """The gap of the lips, of the height of the face. points (478, 2 or 3): of the face mesh, in any unit."""
    return _between(points, UPPER_LIP, LOWER_LIP) / max(_between(points, FOREHEAD, CHIN), 1e-9)


def measure_lids(points: Values, yaw: float, /) -> float:
    """The gap of the lids, of the width of the eye; of two eyes that are seen the less open one.

    points (478, 2): of the face mesh, pixels; yaw: of the head, radians, positive where its left side turns away.
    """
    seen = [*([LEFT_EYE] if yaw < FAR else []), *([RIGHT_EYE] if yaw > -FAR else [])]
    return min(
        _between(points, upper, lower) / max(_between(points, outer, inner), 1e-9)
        for outer, inner, upper, lower in seen
    )


def _between(points: Values, one: int, other: int) -> float:
    return float(np.linalg.norm(points[one] - points[other]))
