"""Angles of heads and eyes, from the conventions of trackers to ours: radians, + is left, up, tilt to the left.

Ours: x to the performer's left, y up, z out of the face, right-handed; the head is turned by yaw about y, then by
-pitch about x, then by -roll about z (Euler YXZ), as the stage turns it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from omote.inputs.rejection import PacketError
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS

HeadAngles = tuple[float, float, float]
GazeAngles = tuple[float, float]
Quaternion = tuple[float, float, float, float]
"""x, y, z, w."""


class BoneTurn(NamedTuple):
    """place: of a bone from its parent, metres, 0 where its own skeleton says that; turn: against its parent, from the
    T-pose; both along our axes."""

    place: tuple[float, float, float]
    turn: Quaternion


LEAST_LENGTH = 1e-6
"""Of a quaternion that still says a direction."""


def read_right_handed_degrees(x: float, y: float, z: float) -> HeadAngles:
    """Angles about our own axes in degrees: of iFacialMocap, Facemotion3D, VTube Studio and MeowFace.

    Their signs follow from packets of real devices: with `eyeLookOut_L` 44 and `eyeLookDown_L` 16 the eyes' y is +15
    and their x is +5 (the vendor's example), so + is left about y, and down about x.

    x, y, z: degrees about our axes.
    """
    return math.radians(y), -math.radians(x), -math.radians(z)


def read_unreal_radians(yaw: float, pitch: float, roll: float) -> HeadAngles:
    """Angles of Live Link Face: Unreal's rotator, radians.

    The face looks along -x and y is its left: + yaw is right, + pitch is down, + roll tilts to the left. The eyes of
    three real takes say so (`EyeLookInLeft` comes with a left eye's yaw above 0); heads are turned by the same code.
    """
    return -yaw, -pitch, roll


def read_unity_quaternion(rotation: Quaternion) -> HeadAngles:
    """A rotation of Unity: left-handed, y up, z out of the face, x to the performer's right (VMC)."""
    x, y, z, w = rotation
    return read_quaternion((x, -y, -z, w))


def read_quaternion(rotation: Quaternion) -> HeadAngles:
    """A rotation about our axes; PacketError where it is none."""
    x, y, z, w = normalize_quaternion(rotation)
    forward = 2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)
    upright = 1.0 - 2.0 * (x * x + z * z)
    yaw = math.atan2(forward[0], forward[2])
    pitch = math.asin(max(-1.0, min(1.0, forward[1])))
    return yaw, pitch, -math.atan2(2.0 * (x * y + w * z), upright)


def write_unity_quaternion(head: HeadAngles) -> Quaternion:
    """The rotation of Unity that `read_unity_quaternion` reads."""
    yaw, pitch, roll = head
    turn = multiply_quaternions(about("y", yaw), multiply_quaternions(about("x", -pitch), about("z", -roll)))
    return mirror_quaternion(turn)


def mirror_quaternion(turn: Quaternion) -> Quaternion:
    """A rotation about our axes as Unity has it, which counts x to the performer's right; and the other way round."""
    x, y, z, w = turn
    return x, -y, -z, w


def about(axis: str, angle: float) -> Quaternion:
    """The rotation by an angle about one of our axes, right-handed. axis: x, y or z; angle: radians."""
    sine = math.sin(0.5 * angle)
    return sine * (axis == "x"), sine * (axis == "y"), sine * (axis == "z"), math.cos(0.5 * angle)


def multiply_quaternions(first: Quaternion, second: Quaternion) -> Quaternion:
    """The rotation that turns by `second`, then by `first`."""
    (ax, ay, az, aw) = first
    (bx, by, bz, bw) = second
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotate(turn: Quaternion, place: tuple[float, float, float]) -> tuple[float, float, float]:
    """A place, or a way, turned about the origin. turn: of length one; place: x, y and z in any unit."""
    x, y, z, w = turn
    back = (-x, -y, -z, w)
    a, b, c, _ = multiply_quaternions(multiply_quaternions(turn, (*place, 0.0)), back)
    return a, b, c


def normalize_quaternion(rotation: Quaternion) -> Quaternion:
    """A rotation of length 1; PacketError where it says no direction."""
    length = math.hypot(*rotation)
    if not LEAST_LENGTH < length < math.inf:
        raise PacketError("a rotation is no quaternion: its numbers are all 0, or none")
    x, y, z, w = (component / length for component in rotation)
    return x, y, z, w


def read_direction(direction: Sequence[float]) -> GazeAngles | None:
    """The angles of a direction (x, y, z) in our axes; None where it has no length or is none."""
    x, y, z = direction
    if not LEAST_LENGTH < math.hypot(x, y, z) < math.inf:
        return None
    return math.atan2(x, z), math.atan2(y, math.hypot(x, z))


def average_eyes(eyes: Iterable[GazeAngles | None]) -> GazeAngles | None:
    """The gaze of both eyes: their mean; None where neither is known."""
    seen = [eye for eye in eyes if eye is not None]
    if not seen:
        return None
    return sum(yaw for yaw, _ in seen) / len(seen), sum(pitch for _, pitch in seen) / len(seen)


def limit_head(head: HeadAngles) -> HeadAngles:
    """The head as far as ours turns: a performer who turns away is at the end, not wrong."""
    yaw, pitch, roll = (_limit(value, most) for value, most in zip(head, HEAD_LIMITS.values(), strict=True))
    return yaw, pitch, roll


def limit_gaze(gaze: GazeAngles) -> GazeAngles:
    """The gaze as far as ours turns."""
    yaw, pitch = (_limit(value, most) for value, most in zip(gaze, GAZE_LIMITS.values(), strict=True))
    return yaw, pitch


def _limit(angle: float, most: float) -> float:
    turned = math.remainder(angle, math.tau)
    return max(-most, min(most, turned))
