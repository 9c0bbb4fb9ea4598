"""A frame of a body as the camera page sends it: the points that a pose model found in a picture.

Layout, little endian: `OMBL`, u16 version, u16 width and u16 height of the picture (pixels), u16 count of points,
f64 time (milliseconds of the page's clock), then count times six f32: x, y, z in metres about the middle of the hips as
the model has them (x to the right of the picture, y down, z away from the camera), how visible the point is (0..1), and
x and y of the picture as fractions of its width and height.
Count is 33, or 0 where no body was found.
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Points, Values
from omote.inputs.camera.landmark_frame import LARGEST_PICTURE, LandmarkError

BODY_POINTS = 33
"""Points of MediaPipe's pose."""
NUMBERS = 6
FARTHEST = 3.0
"""Metres from the hips at which a point of a person cannot be."""
MARGIN = 0.02
"""Of the picture: a point so far outside of it is a guess."""
_SIGNATURE = b"OMBL"
_VERSION = 1
_HEADER = struct.Struct("<4sHHHHd")


@dataclass(frozen=True, eq=False)
class BodyPoints:
    """What was found of a body in one picture. The picture is as the camera gives it, not mirrored.

    values (33, 6): of each point as in the layout above; None where no body was found. A point with a number that is
    none, or that no person reaches, counts as unseen: the others stay. width, height: pixels. time: seconds of the
    camera page's clock.
    """

    values: NDArray[np.float32] | None
    width: int
    height: int
    time: float

    def __post_init__(self) -> None:
        """Rejects a picture without an area and a time that is no number; clears points that cannot be."""
        for name, size in (("width", self.width), ("height", self.height)):
            if not 1 <= size <= LARGEST_PICTURE:
                raise LandmarkError(f"the picture's {name} is {size}; expected 1 to {LARGEST_PICTURE} pixels")
        if not math.isfinite(self.time):
            raise LandmarkError(f"the time is {self.time}; expected seconds of the page's clock")
        if self.values is not None:
            object.__setattr__(self, "values", _clear_wrong(self.values))

    @property
    def found(self) -> bool:
        """Whether a body was found in the picture."""
        return self.values is not None

    @property
    def points(self) -> Points:
        """Where the points are (33, 3), metres in our axes: x to the performer's left, y up, z to the camera."""
        return np.asarray(self._values()[:, :3] * [1.0, -1.0, -1.0])

    @property
    def visible(self) -> Values:
        """How far each point is seen (33,), 0..1: none that lies outside the picture."""
        values = self._values()
        inside = np.all(np.abs(values[:, 4:] - 0.5) <= 0.5 + MARGIN, axis=1)
        return np.where(inside, values[:, 3], 0.0)

    @property
    def picture(self) -> Points:
        """Where the points are in the picture (33, 2): in its widths from its upper left corner, x to the right."""
        return np.asarray(self._values()[:, 4:] * [1.0, self.height / self.width])

    def _values(self) -> Values:
        if self.values is None:
            raise ValueError("no body was found in this frame; ask `found` first")
        return self.values.astype(np.float64)


def read_body_points(packet: bytes) -> BodyPoints:
    """Reads a binary message of the camera page.

    Parameters
    ----------
    packet : bytes
        The message, whole.

    Returns
    -------
    BodyPoints
        What it holds, checked; the time in seconds.

    Raises
    ------
    LandmarkError
        Where it is none, with what is wrong.
    """
    if len(packet) < _HEADER.size:
        raise LandmarkError(f"it has {len(packet)} bytes; a frame of a body has {_HEADER.size} at least")
    signature, version, width, height, count, milliseconds = _HEADER.unpack_from(packet)
    if signature != _SIGNATURE:
        raise LandmarkError(f"it begins with {signature!r}; expected {_SIGNATURE!r}")
    if version != _VERSION:
        raise LandmarkError(f"it has version {version}; this server reads {_VERSION}: load the camera page anew")
    if count not in (0, BODY_POINTS):
        raise LandmarkError(f"it has {count} points; expected {BODY_POINTS}, or 0 where no body was found")
    expected = _HEADER.size + 4 * NUMBERS * count
    if len(packet) != expected:
        raise LandmarkError(f"it has {len(packet)} bytes; with {count} points it has {expected}")
    values = np.frombuffer(packet, "<f4", offset=_HEADER.size).reshape(count, NUMBERS) if count else None
    return BodyPoints(values, width, height, milliseconds / 1000.0)


def write_body_points(frame: BodyPoints) -> bytes:
    """The message that reads as this frame (what the camera page does, for programs and tests)."""
    count = BODY_POINTS if frame.found else 0
    header = _HEADER.pack(_SIGNATURE, _VERSION, frame.width, frame.height, count, 1000.0 * frame.time)
    return header if frame.values is None else header + frame.values.astype("<f4").tobytes()


def holds_body(packet: bytes) -> bool:
    """Whether a binary message of the camera page is one of a body, by how it begins."""
    return packet[: len(_SIGNATURE)] == _SIGNATURE


def _clear_wrong(values: NDArray[np.float32]) -> NDArray[np.float32]:
    if values.shape != (BODY_POINTS, NUMBERS):
        raise LandmarkError(f"the points have shape {values.shape}; expected ({BODY_POINTS}, {NUMBERS})")
    checked = np.array(values, np.float32)
    wrong = ~np.isfinite(checked).all(axis=1) | (np.abs(checked[:, :3]) > FARTHEST).any(axis=1)
    checked[wrong] = 0.0
    checked[:, 3] = checked[:, 3].clip(0.0, 1.0)
    checked.setflags(write=False)
    return checked
