"""What is known of the skin before anybody photographed it: where it is looked at, and how its brightness may vary."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

LIPS, BROWS, CHEEKS = range(3)
EVEN = 0.12
"""How far skin is lighter or darker than the person's skin is on the whole: a standard deviation of logarithms, and
more at the lips' border and at the brows, which nobody has where we have them."""
BORDER, BROW = 0.7, 0.5


@dataclass(frozen=True, eq=False)
class SkinSamples:
    """Points of the face's skin whose brightness is looked at: the middles of triangles.

    corners (s, 3): rows of the space's skin; areas (s,) of what each stands for, their mean being 1; layers (s, 3): how
    far it lies on lips, brows and cheeks; spread (s,): how far its brightness may be off beside that, logarithms; units
    (u, V, 3): how each expression moves the skin, metres.
    """

    corners: NDArray[np.int64]
    areas: Values
    layers: Values
    spread: Values
    units: Values

    def on(self, values: Values, /) -> Values:
        """Values (V, c) of the skin at the points, (s, c)."""
        result: Values = values[self.corners].mean(axis=1)
        return result


def sample_skin(
    space: ParameterSpace, rows: NDArray[np.int64], layers: Values, units: Values, /
) -> SkinSamples:  # fmt: skip
    """The points in the middles of triangles (s,), rows of the space's; layers and units as in `SkinSamples`."""
    corners = space.triangles[rows].astype(np.int64)
    areas = mesh.areas(space.points, corners.astype(np.int32))
    border = BORDER * layers[:, LIPS] * (1.0 - layers[:, LIPS])
    spread = np.sqrt(EVEN**2 + border**2 + (BROW * layers[:, BROWS]) ** 2)
    return SkinSamples(corners, areas / areas.mean(), layers, spread, units)
