"""Photographs of a head as they are fitted: what a landmark model found in them, and what is known of the camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh
from omote.model.fitting.photographs.landmark_table import LANDMARKS

LARGEST, FARTHEST = 20_000, 4.0
FOCALS = (8.0, 400.0)
FILM = 36.0
"""Width of the picture to which focal lengths of 35 mm film refer, millimetres."""


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

    landmarks: NDArray[np.float64]
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
        wanted, picture = (self.height, self.width, 3), self.picture
        if picture is not None and (picture.shape != wanted or picture.dtype != np.uint8):
            raise ValueError(f"a picture has shape {picture.shape} of {picture.dtype}; expected {wanted} of uint8")
        object.__setattr__(self, "landmarks", _validate(self.landmarks, self.width, self.height))

    @property
    def has_depth(self) -> bool:
        """Whether the landmarks have a third coordinate."""
        return bool(self.landmarks.shape[1] == 3)


def _validate(landmarks: ArrayLike, width: int, height: int) -> NDArray[np.float64]:
    points = mesh.validate_numbers(landmarks, name="landmarks of a photograph")
    if points.shape not in ((LANDMARKS, 2), (LANDMARKS, 3)):
        raise ValueError(f"landmarks of a photograph have shape {points.shape}; expected ({LANDMARKS}, 2) or 3")
    if not np.isfinite(points).all():
        raise ValueError("landmarks of a photograph are not all finite; expected numbers of pixels")
    outside = np.abs(points[:, :2] / [width, height] - 0.5).max() - 0.5
    if outside > FARTHEST:
        raise ValueError(f"a landmark lies {outside:.3g} pictures outside; expected {FARTHEST:g} at most")
    result = np.array(points, np.float64)
    result.setflags(write=False)
    return result
