"""Which shapes of a stranger's head are no expressions: nothing, too much, or another head."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.shape.head_zones import head_zones
from omote.model.space.head_regions import region_weights
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

# What moves less than the first, metres, holds nothing; what moves farther than the second is no face's.
NOTHING, HUGE = 1e-4, 0.1
# An expression leaves the skull at rest: it moves there no more than this share of how far it moves the face.
SKULL = 0.25
# A vertex is the skull's by so much, and was seen by so much.
OWNED, SEEN = 0.6, 0.3


def explain_unfit(
    space: ParameterSpace, seen: Values, skin: Values, parts: Mapping[str, Values], /
) -> str:  # fmt: skip
    """Why a displacement of skin (V, 3) and parts is no expression, as the rest of a sentence about it; "" for one.

    seen (V,): how much of each vertex the scan shows.
    """
    face = np.linalg.norm(skin[head_zones(space).face], axis=1)
    most = max([float(face.max())] + [float(np.linalg.norm(moved, axis=1).max()) for moved in parts.values()])
    if most < NOTHING:
        return "moves nothing of the face"
    if most > HUGE:
        return f"moves the face by {100.0 * most:.0f} cm, more than any expression"
    skull = (region_weights(space)["skull"] > OWNED) & space.on_sheet & (seen > SEEN)
    if skull.any():
        far = float(np.median(np.linalg.norm(skin[skull], axis=1)))
        if far > max(SKULL * float(np.quantile(face, 0.95)), NOTHING):
            return "moves the skull with the face: it is another head, or a turn of it, and no expression"
    return ""
