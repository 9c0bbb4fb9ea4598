"""S, or a window of it, as a picture inside a figure."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.skin_sheet import unwrap_corners
from tools.pictures.method.svg import Box
from tools.pictures.method.view import MEMBRANE, SKIN, painted

Values = NDArray[np.float64]


class Unrolled:
    """S, or a window of it, in a box of a figure: theta to the right, h upward, one scale for both."""

    def __init__(self, space: ParameterSpace, box: Box, *, middle: tuple[float, float] | None = None,
                 width: float | None = None) -> None:  # fmt: skip
        self.space = space
        self.box = box
        self.metric = float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())
        h = space.h[space.on_sheet]
        self._middle = middle or (0.0, float(h.min() + h.max()) / 2)
        self._scale = box[2] / (width or 2 * np.pi * self.metric)

    def at(self, theta: Values | float, h: Values | float) -> Values:
        """Where points of S lie in the figure: (..., 2)."""
        x = self.box[0] + self.box[2] / 2 + (np.asarray(theta) - self._middle[0]) * self.metric * self._scale
        y = self.box[1] + self.box[3] / 2 - (np.asarray(h) - self._middle[1]) * self._scale
        return np.stack([x, y], axis=-1)

    def corners(self, triangles: NDArray[np.int32]) -> Values:
        """Triangles (t, 3) of S in the figure: (t, 3, 3), none torn at the seam."""
        flat = self.at(unwrap_corners(self.space.theta, triangles), self.space.h[triangles])
        return np.concatenate([flat, np.zeros((*flat.shape[:2], 1))], axis=2)

    def picture(self, materials: NDArray[np.integer]) -> str:
        """Sheet and membranes with the material of each triangle (l,), lit as the head's slopes lie."""
        corners = self.corners(self.space.location_triangles)
        turn = np.array([2 * np.pi * self.metric * self._scale, 0.0, 0.0])
        light = self._light()[self.space.location_triangles]
        light[len(self.space.skin_triangles) :] = 0.9
        light = np.tile(light, (3, 1))
        return painted(
            self.box, np.concatenate([corners - turn, corners, corners + turn]), light, np.tile(materials, 3)
        )

    def _light(self) -> Values:
        space = self.space
        slope = mesh.normals(space.points, space.triangles)
        away = np.stack([np.sin(space.theta), np.zeros(len(space.theta)), np.cos(space.theta)], axis=1)
        result: Values = 0.3 + 0.7 * np.clip((slope * (0.8 * away + [0.0, 0.45, 0.0])).sum(axis=1), 0.0, 1.0)
        return result


def sheet_or_membrane(space: ParameterSpace) -> NDArray[np.int64]:
    """The material of each location triangle (l,)."""
    return np.where(np.arange(len(space.location_triangles)) < len(space.skin_triangles), SKIN, MEMBRANE)
