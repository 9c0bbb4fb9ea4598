"""Photographs of a head as they are fitted: what a landmark model found in them, and where the camera was."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from omote.arrays import Floats, Values
from omote.geometry import mesh
from omote.geometry.depth_map import draw_depth
from omote.model.fitting.photographs.landmark_table import LANDMARKS

LARGEST = 20_000
FARTHEST = 4.0
FOCALS = (8.0, 400.0)
FILM = 36.0
"""Width of the picture to which focal lengths of 35 mm film refer, millimetres."""
DEPTH_SIDE = 400
"""Pixels of a coarse depth map's longer side."""


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
        return points.astype(np.float64) @ self.rotation.T + self.shift

    def project(self, seen: Values, /) -> Values:
        """Where points (n, 3) of the camera's frame lie in the picture, (n, 2) pixels, y down."""
        plane = self.focal * seen[:, :2] / -seen[:, 2:]
        return np.stack([0.5 * self.width + plane[:, 0], 0.5 * self.height - plane[:, 1]], axis=1)

    def screen(self, points: NDArray[np.floating], /, share: float = 1.0) -> Values:
        """Points (n, 3) of the head as depth maps take them: pixels right and down in a picture of so much a side
        (share), depth in metres.

        points (n, 3): metres; share: of each side of the picture.
        """
        seen = self.view(points)
        return np.column_stack([self.project(seen) * share, -seen[:, 2]])

    def facing(self, points: NDArray[np.floating], ways: Values, /) -> Values:
        """The cosines (n,) between unit vectors, ways (n, 3), and those from points (n, 3) to the camera."""
        seen = self.view(points)
        return ((ways @ self.rotation.T) * -seen).sum(axis=1) / np.linalg.norm(seen, axis=1)

    def draw(self, skin: NDArray[np.floating], triangles: NDArray[np.integer], /, share: float = 1.0) -> Floats:
        """The depth map of a skin (V, 3), triangles (t, 3), in a picture with so much of each side (share)."""
        size = max(int(self.width * share), 1), max(int(self.height * share), 1)
        return draw_depth(self.screen(skin, share), triangles.astype(np.int32), *size)

    @property
    def coarse(self) -> float:
        """The share of the picture's sides at which a depth map has DEPTH_SIDE pixels along the longer one."""
        return DEPTH_SIDE / max(self.width, self.height)

    def move(self, turn: Values, shift: Values, growth: float, /) -> PhotographCamera:
        """The camera after the head turned (3,) radians about its middle and moved (3,) metres before it, and the
        logarithm of the focal length grew.

        turn (3,): radians; shift (3,): metres; growth: of the logarithm of the focal length.
        """
        turned = Rotation.from_rotvec(turn).as_matrix() @ self.rotation
        return replace(self, rotation=turned, shift=self.shift + shift, focal=self.focal * float(np.exp(growth)))

    @property
    def yaw(self) -> float:
        """How far the head looks past the camera, radians: positive where its left side turns away, its nose to the
        picture's right."""
        return float(np.arctan2(self.rotation[0, 2], self.rotation[2, 2]))


@dataclass(frozen=True, eq=False)
class Photograph:
    """One photograph of a head.

    Parameters
    ----------
    landmarks : array_like, (478, 2) or (478, 3)
        Points of MediaPipe's face mesh, pixels: to the right, down, and (better) the model's depth, smaller is nearer,
        which its page gives in widths of the picture.
    width, height : int
        Of the picture, pixels.
    focal : float, optional
        The lens' focal length in millimetres of 35 mm film, as a file's EXIF says; None where it is unknown.
    camera : str, optional
        Photographs with one name here were taken with one lens; None: nobody knows.
    picture : array_like of uint8, (height, width, 3), optional
        sRGB: where it is given, outlines of the face are sought in it.
    side : str, optional
        From where it was said to be taken ("front", "left", ...), for doubts.

    Raises
    ------
    ValueError
        On other shapes, numbers that are not finite, points far outside the picture, strange sizes and lenses.

    Examples
    --------
    >>> import numpy as np
    >>> omote.Photograph(np.full((478, 2), 300.0), 600, 600, focal=26.0).has_depth
    False

    References
    ----------
    K. Arai (1993), section 5.1 and [8]: faces from photographs.
    """

    landmarks: Values
    width: int
    height: int
    focal: float | None = None
    camera: str | None = None
    picture: NDArray[np.uint8] | None = None
    side: str | None = None

    def __post_init__(self) -> None:
        for name, size in (("width", self.width), ("height", self.height)):
            if not 1 <= size <= LARGEST:
                raise ValueError(f"the {name} of a photograph is {size}; expected 1 to {LARGEST} pixels")
        if self.focal is not None and not FOCALS[0] <= self.focal <= FOCALS[1]:
            raise ValueError(
                f"the focal length of a photograph is {self.focal}; expected {FOCALS[0]:g} to {FOCALS[1]:g} mm, or None"
            )
        wanted = (self.height, self.width, 3)
        picture = self.picture
        if picture is not None and (picture.shape != wanted or picture.dtype != np.uint8):
            raise ValueError(f"a picture has shape {picture.shape} of {picture.dtype}; expected {wanted} of uint8")
        object.__setattr__(self, "landmarks", _validate(self.landmarks, self.width, self.height))

    @property
    def has_depth(self) -> bool:
        """Whether the landmarks have a third coordinate."""
        return bool(self.landmarks.shape[1] == 3)


def _validate(landmarks: ArrayLike, width: int, height: int) -> Values:
    points = mesh.validate_numbers(landmarks, name="landmarks of a photograph")
    if points.shape not in ((LANDMARKS, 2), (LANDMARKS, 3)):
        raise ValueError(f"landmarks of a photograph have shape {points.shape}; expected ({LANDMARKS}, 2) or 3")
    if not np.isfinite(points).all():
        raise ValueError("landmarks of a photograph are not all finite; expected numbers of pixels")
    outside = np.abs(points[:, :2] / [width, height] - 0.5).max() - 0.5
    if outside > FARTHEST:
        raise ValueError(f"a landmark lies {outside:.3g} pictures outside; expected {FARTHEST:g} at most")
    return mesh.freeze(points)
