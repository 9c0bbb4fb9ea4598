"""A frame of landmarks as the camera page sends it: the points that a face-landmark model found in a picture.

Layout, little endian: `OMLM`, u16 version, u16 width and u16 height of the picture (pixels), u16 count of points,
f64 time (milliseconds of the page's clock), then count times x, y, z as f32.
Count is 478, or 0 where no face was found.
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.inputs.rejection import PacketError

LANDMARKS = 478
"""Points of MediaPipe's face mesh with irises: 468 of the skin, then five of each iris."""
LARGEST_PICTURE = 8192
FARTHEST = 4.0
"""How far outside the picture a point may lie, in widths or heights of it."""
_SIGNATURE = b"OMLM"
_VERSION = 1
_HEADER = struct.Struct("<4sHHHHd")


class LandmarkError(PacketError):
    """What came is no frame of landmarks, and why."""


@dataclass(frozen=True, eq=False)
class LandmarkFrame:
    """What was found in one picture. The picture is as the camera gives it, not mirrored.

    points (478, 3): x and y as fractions of the picture's width and height (y down), z in units of its width, smaller
    is nearer; None where no face was found. width, height: pixels. time: seconds of the camera page's clock.
    """

    points: NDArray[np.float32] | None
    width: int
    height: int
    time: float

    def __post_init__(self) -> None:
        """Rejects a picture without an area, a time that is no number, and points that no model finds."""
        for name, size in (("width", self.width), ("height", self.height)):
            if not 1 <= size <= LARGEST_PICTURE:
                raise LandmarkError(f"the picture's {name} is {size}; expected 1 to {LARGEST_PICTURE} pixels")
        if not math.isfinite(self.time):
            raise LandmarkError(f"the time is {self.time}; expected seconds of the page's clock")
        if self.points is not None:
            object.__setattr__(self, "points", _check_points(self.points))

    @property
    def found(self) -> bool:
        """Whether a face was found in the picture."""
        return self.points is not None


def read_landmark_frame(packet: bytes) -> LandmarkFrame:
    """Reads a binary message of the camera page.

    Parameters
    ----------
    packet : bytes
        The message, whole.

    Returns
    -------
    LandmarkFrame
        What it holds, checked; the time in seconds.

    Raises
    ------
    LandmarkError
        Where it is none, with what is wrong.
    """
    if len(packet) < _HEADER.size:
        raise LandmarkError(f"it has {len(packet)} bytes; a frame of landmarks has {_HEADER.size} at least")
    signature, version, width, height, count, milliseconds = _HEADER.unpack_from(packet)
    if signature != _SIGNATURE:
        raise LandmarkError(f"it begins with {signature!r}; expected {_SIGNATURE!r}")
    if version != _VERSION:
        raise LandmarkError(f"it has version {version}; this server reads {_VERSION}: load the camera page anew")
    if count not in (0, LANDMARKS):
        raise LandmarkError(f"it has {count} points; expected {LANDMARKS}, or 0 where no face was found")
    expected = _HEADER.size + 12 * count
    if len(packet) != expected:
        raise LandmarkError(f"it has {len(packet)} bytes; with {count} points it has {expected}")
    points = np.frombuffer(packet, "<f4", offset=_HEADER.size).reshape(count, 3) if count else None
    return LandmarkFrame(points, width, height, milliseconds / 1000.0)


def write_landmark_frame(frame: LandmarkFrame) -> bytes:
    """The message that reads as this frame (what the camera page does, for programs and tests)."""
    count = LANDMARKS if frame.found else 0
    header = _HEADER.pack(_SIGNATURE, _VERSION, frame.width, frame.height, count, 1000.0 * frame.time)
    return header if frame.points is None else header + frame.points.astype("<f4").tobytes()


def _check_points(points: NDArray[np.float32]) -> NDArray[np.float32]:
    if points.shape != (LANDMARKS, 3):
        raise LandmarkError(f"the points have shape {points.shape}; expected ({LANDMARKS}, 3)")
    checked = np.array(points, np.float32)
    if not np.isfinite(checked).all():
        raise LandmarkError("a coordinate of a point is no number")
    farthest = float(np.abs(checked - 0.5).max()) - 0.5
    if farthest > FARTHEST:
        raise LandmarkError(f"a point lies {farthest:.3g} pictures outside; expected {FARTHEST:g} at most")
    checked.setflags(write=False)
    return checked
