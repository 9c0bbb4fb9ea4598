"""How large the generic head is, which all tuned lengths are measured by (docs/method.md, "The unit of length")."""

from __future__ import annotations

import numpy as np

from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

HEAD_METRES = 0.23222
"""From under the chin to the crown of the generic head. The bake brings any head to this height, so a length in metres
anywhere in this code is a share of it: 1 mm is HEAD_METRES / 232.22."""
# The chin is sought in the profile: within this angle from straight ahead, radians, and at least so far ahead of the
# axis as this share of the foremost point.
_PROFILE = 0.35
_AHEAD = 2.0 / 3.0


@weakly_cached
def find_crown(space: ParameterSpace, /) -> int:
    """The row of the crown on a generic head of any size: what of its upper half is nearest to the axis."""
    x, y, z = space.points.T
    upper = np.flatnonzero(y > (y.min() + y.max()) / 2)
    return int(upper[np.hypot(x[upper] - space.cylinder.x, z[upper] - space.cylinder.z).argmin()])


@weakly_cached
def find_chin(space: ParameterSpace, /) -> int:
    """The row under the chin on a generic head of any size: the lowest of the profile that is not throat.

    Raises ValueError where the sheet has no vertex straight ahead.
    """
    profile = np.flatnonzero(space.on_sheet & (np.abs(space.theta) < _PROFILE))
    if not len(profile):
        raise ValueError("the space has no points straight ahead of its axis; expected a face there")
    ahead = space.points[profile, 2] - space.cylinder.z
    face = profile[ahead >= _AHEAD * ahead.max()]
    return int(face[space.points[face, 1].argmin()])


def head_height(space: ParameterSpace, /) -> float:
    """How tall a generic head is from under its chin to its crown, in the unit of its points.

    A head that is to be the generic face of tuned lengths is scaled by `HEAD_METRES / head_height(space)` before.
    """
    crown, chin = space.points[[find_crown(space), find_chin(space)], 1].tolist()
    return float(crown - chin)
