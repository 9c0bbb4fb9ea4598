"""Cylindrical coordinates (theta, h, r) about a vertical axis, and back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Values


def wrap(angle: Values, /) -> Values:
    """Wraps angles into [-pi, pi)."""
    return (angle + np.pi) % (2 * np.pi) - np.pi


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A vertical axis through (x, z), metres; theta = atan2(dx, dz), 0 straight ahead
    (docs/method.md, "The cylinder")."""

    x: float
    z: float

    def __post_init__(self) -> None:
        if not (np.isfinite(self.x) and np.isfinite(self.z)):
            raise ValueError(f"the axis is at x = {self.x}, z = {self.z}; expected finite metres")

    def unroll(self, points: Values, /) -> tuple[Values, Values, Values]:
        """(theta, h, r) of points (..., 3): radians in [-pi, pi), metres, metres."""
        dx, dz = points[..., 0] - self.x, points[..., 2] - self.z
        return wrap(np.arctan2(dx, dz)), points[..., 1], np.hypot(dx, dz)

    def outward(self, points: Values, /) -> Values:
        """The level unit vectors (n, 3) from the axis to points (n, 3)."""
        away = points - [self.x, 0.0, self.z]
        away[:, 1] = 0.0
        away /= np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-9)
        return away

    def roll(self, theta: Values, h: Values, r: Values, /) -> Values:
        """Points (..., 3) in metres at (theta, h, r), the inverse of `unroll`."""
        return np.stack(
            [self.x + r * np.sin(theta), np.broadcast_to(h, np.shape(theta)), self.z + r * np.cos(theta)], axis=-1
        )
