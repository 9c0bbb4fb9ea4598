"""Where the camera of a photograph was: a pinhole without distortion, its middle in the middle of the picture."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PhotographCamera:
    """A camera, relative to a head.

    Attributes
    ----------
    rotation : ndarray, (3, 3)
        From the head's frame to the camera's: x to the right in the picture, y up, z towards the photographer.
    shift : ndarray, (3,)
        Where the head's origin lies in the camera's frame, metres; z is negative.
    focal : float
        Focal length, pixels.
    width, height : int
        Of the picture, pixels.
    """

    rotation: Values
    shift: Values
    focal: float
    width: int
    height: int

    def view(self, points: NDArray[np.floating], /) -> Values:
        """Points (n, 3) of the head in the camera's frame, metres."""
        result: Values = points.astype(np.float64) @ self.rotation.T + self.shift
        return result

    def project(self, seen: Values, /) -> Values:
        """Where points (n, 3) of the camera's frame lie in the picture, (n, 2) pixels, y down."""
        plane = self.focal * seen[:, :2] / -seen[:, 2:]
        return np.stack([0.5 * self.width + plane[:, 0], 0.5 * self.height - plane[:, 1]], axis=1)

    def move(self, turn: Values, shift: Values, growth: float, /) -> PhotographCamera:
        """The camera after the head turned (3,) radians about its middle and moved (3,) metres before it, and the
        logarithm of the focal length grew."""
        turned = Rotation.from_rotvec(turn).as_matrix() @ self.rotation
        return replace(
            self, rotation=turned, shift=self.shift + shift, focal=self.focal * float(np.exp(growth))
        )  # fmt: skip

    @property
    def yaw(self) -> float:
        """How far the head looks past the camera, radians: positive where its left side turns away, its nose to the
        picture's right."""
        return float(np.arctan2(self.rotation[0, 2], self.rotation[2, 2]))
