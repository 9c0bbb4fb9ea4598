"""How clips of other programs name and turn what ours have."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.arrays import Values
from omote.model.space.expression import Expression
from omote.perform.channels import GAZE_UNITS, gaze_channels
from omote.perform.frame import Gaze


def gaze_weights(expressions: Mapping[str, Expression], gaze: Values) -> dict[str, Values]:
    """The weights of the units that turn the eyes by a gaze, (n,) each.

    expressions: of the cast, by name; gaze: (n, 2) radians.
    """
    turned = [gaze_channels(expressions, Gaze(yaw, pitch)) for yaw, pitch in gaze.tolist()]
    return {
        name: np.array([weights.get(name, 0.0) for weights in turned])
        for name in GAZE_UNITS
        if any(name in weights for weights in turned)
    }


def quaternions_of(turns: Values) -> Values:
    """Rotations (n, 4: x, y, z, w) of heads or eyes that are turned by yaw about y, then by -pitch about x, then by
    -roll about z, as the stage turns them. turns: (n, 3), or (n, 2) without roll; radians."""
    half = 0.5 * np.column_stack([turns, np.zeros((len(turns), 3 - turns.shape[1]))]) * [1.0, -1.0, -1.0]
    cy, cp, cr = np.cos(half).T
    sy, sp, sr = np.sin(half).T
    return np.column_stack(
        [
            cy * sp * cr + sy * cp * sr,
            sy * cp * cr - cy * sp * sr,
            cy * cp * sr - sy * sp * cr,
            cy * cp * cr + sy * sp * sr,
        ]
    )
