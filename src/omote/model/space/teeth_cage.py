"""The columns of a row of teeth: a strip of 17 along the arch, four vertices each, found by their places alone."""

from __future__ import annotations

import numpy as np

from omote.arrays import Indices, Points

COLUMN_ROWS = 4
COLUMNS = 17
ARCH = 0.034
"""From the front teeth back to the middle of the dental arch, metres."""


def cage_columns(points: Points, *, upper: bool) -> Indices | None:
    """The columns (17, 4) of a row of teeth at points (n, 3), from the right end to the left: gum, middle, edge,
    behind; None where it is no such strip.

    Those behind lie nearest to the arch's middle, the others in threes at one angle. upper: whether it is the
    upper one.
    """
    if len(points) != COLUMNS * COLUMN_ROWS:
        return None
    across, up, ahead = points.T
    back = ahead - (ahead.max() - ARCH)
    angle = np.arctan2(across, back)
    outwards = np.argsort(np.hypot(across, back), kind="stable")
    behind, outer = (part[np.argsort(angle[part], kind="stable")] for part in np.split(outwards, [COLUMNS]))
    threes = outer.reshape(COLUMNS, 3)
    order = np.argsort((-1.0 if upper else 1.0) * up[threes], axis=1, kind="stable")
    columns: Indices = np.column_stack([np.take_along_axis(threes, order, axis=1), behind]).astype(np.int32)
    return columns
