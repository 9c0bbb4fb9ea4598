"""What eyes look at, as the body sees it: its direction, how far eyes converge on it, whether they are at it now."""

from __future__ import annotations

import math
from dataclasses import dataclass

from omote.perform.frame import GazeTarget
from omote.perform.motion.head_following import AHEAD, Turn

HALF_TURN = math.pi
FULL_TURN = 2.0 * math.pi
_ARC_TERMS = tuple((-1.0) ** term / (2 * term + 1) for term in range(7))
_SINE_TERMS = (1.0, -1 / 6, 1 / 120, -1 / 5040, 1 / 362880, -1 / 39916800)
_COSINE_TERMS = (1.0, -1 / 2, 1 / 24, -1 / 720, 1 / 40320, -1 / 3628800, 1 / 479001600)


def angle_of(across: float, ahead: float) -> float:
    """The angle of a direction from straight ahead, as `math.atan2`: radians, -pi to pi; 0 for none.

    across: to the side, in any unit.
    """
    if abs(across) <= abs(ahead):
        turned = 0.0 if ahead == 0.0 else _arc_tangent(across / ahead)
        return turned if ahead >= 0.0 else turned + (HALF_TURN if across >= 0.0 else -HALF_TURN)
    quarter = HALF_TURN / 2.0 if across > 0.0 else -HALF_TURN / 2.0
    return quarter - _arc_tangent(ahead / across)


def sine_cosine(angle: float) -> tuple[float, float]:
    """Sine and cosine of an angle in radians."""
    part = wrap_angle(angle) / 4.0  # at most 45 degrees, where the series need few terms
    square = part * part
    sine = part * _polynomial(_SINE_TERMS, square)
    cosine = _polynomial(_COSINE_TERMS, square)
    for _ in range(2):
        sine, cosine = 2.0 * sine * cosine, cosine * cosine - sine * sine
    return sine, cosine


def wrap_angle(angle: float) -> float:
    """The same direction as an angle from -pi to pi."""
    return angle - FULL_TURN * math.floor(angle / FULL_TURN + 0.5)


def _arc_tangent(slope: float) -> float:
    """The arc tangent of -1 to 1: the angle is halved twice, where its series needs few terms."""
    for _ in range(2):
        slope /= 1.0 + math.sqrt(1.0 + slope * slope)
    return 4.0 * slope * _polynomial(_ARC_TERMS, slope * slope)


def _polynomial(terms: tuple[float, ...], square: float) -> float:
    total = 0.0
    for term in reversed(terms):
        total = total * square + term
    return total


Point = tuple[float, float, float]
"""Metres in the scene: to the picture's right, above the eyes of a head of size 1, before the front line."""
PUPIL_METRES = 0.033
"""Metres from the middle to each eye, of every face of the cast within 6 mm."""
NECK_METRES = 0.03
EYES_METRES = 0.108
"""Metres ahead at which a head turns, and from there to its eyes."""
NEAREST_METRES = 0.1
"""Metres; eyes converge on what is nearer as if it were there."""


@dataclass(frozen=True)
class Sight:
    """What is looked at. turn: from the body, radians; vergence: how far each eye turns in, radians; contact: whether
    the eyes are at it now, None where the character decides."""

    turn: Turn = AHEAD
    vergence: float = 0.0
    contact: bool | None = None


NOTHING = Sight()


def eyes_of(x: float, depth: float, size: float, turned: float) -> Point:
    """Where the middle of a character's eyes is: its place, and how far body and head have turned, radians.

    x: metres to the picture's right; depth: metres behind the front line; size: of the character, 1 as people are.
    """
    across, ahead = sine_cosine(turned)
    return x + size * EYES_METRES * across, 0.0, NECK_METRES - depth + size * EYES_METRES * ahead


def sight_of_point(point: Point, eyes: Point, *, body: float, size: float) -> Sight:
    """A point as a character sees it whose eyes are at `eyes` and whose body is turned by `body` radians.

    size: of the character, 1 as people are.
    """
    across, up, ahead = (wanted - own for wanted, own in zip(point, eyes, strict=True))
    flat = math.sqrt(across * across + ahead * ahead)
    far = max(math.sqrt(flat * flat + up * up), NEAREST_METRES)
    turn = Turn(wrap_angle(angle_of(across, ahead) - body), angle_of(up, flat))
    return Sight(turn, angle_of(PUPIL_METRES * size, far))


def sight_of_direction(target: GazeTarget, *, body: float) -> Sight:
    """A direction of the house, far away. target: which; body: radians by which the body is turned."""
    return Sight(Turn(wrap_angle(target.yaw - body), target.pitch))


def sight_alone(target: GazeTarget) -> Sight:
    """What a character sees that stands alone, straight and in the middle: others are nowhere."""
    if target.kind == "direction":
        return sight_of_direction(target, body=0.0)
    if target.kind == "point":
        return sight_of_point((target.x, target.y, target.z), eyes_of(0.0, 0.0, 1.0, 0.0), body=0.0, size=1.0)
    return NOTHING
