"""What eyes look at, as the body sees it: its direction, how far eyes converge on it, whether they are at it now."""

from __future__ import annotations

import math
from dataclasses import dataclass

from omote.perform.frame import GazeTarget
from omote.perform.motion.angles import angle_of, sine_cosine, wrap_angle
from omote.perform.motion.head_following import AHEAD, Turn

Point = tuple[float, float, float]
"""Metres in the scene: to the picture's right, above the eyes of a head of size 1, before the front line."""
PUPIL = 0.033
"""Metres from the middle to each eye, of every face of the cast within 6 mm."""
NECK, REACH = 0.03, 0.108
"""Metres ahead at which a head turns, and from there to its eyes."""
NEAREST = 0.1
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
    """Where the middle of a character's eyes is: its place, and how far body and head have turned, radians."""
    across, ahead = sine_cosine(turned)
    return x + size * REACH * across, 0.0, NECK - depth + size * REACH * ahead


def sight_of_point(point: Point, eyes: Point, *, body: float, size: float) -> Sight:
    """A point as a character sees it whose eyes are at `eyes` and whose body is turned by `body` radians."""
    across, up, ahead = (wanted - own for wanted, own in zip(point, eyes, strict=True))
    flat = math.sqrt(across * across + ahead * ahead)
    far = max(math.sqrt(flat * flat + up * up), NEAREST)
    turn = Turn(wrap_angle(angle_of(across, ahead) - body), angle_of(up, flat))
    return Sight(turn, angle_of(PUPIL * size, far))


def sight_of_direction(target: GazeTarget, *, body: float) -> Sight:
    """A direction of the house, far away."""
    return Sight(Turn(wrap_angle(target.yaw - body), target.pitch))


def sight_alone(target: GazeTarget) -> Sight:
    """What a character sees that stands alone, straight and in the middle: others are nowhere."""
    if target.kind == "direction":
        return sight_of_direction(target, body=0.0)
    if target.kind == "point":
        return sight_of_point((target.x, target.y, target.z), eyes_of(0.0, 0.0, 1.0, 0.0), body=0.0, size=1.0)
    return NOTHING
