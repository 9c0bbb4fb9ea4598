"""Whom or what the characters of a scene look at: points, other characters, cameras of stages, as each sees them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from omote.perform.frame import POINT_LIMITS, GazeTarget
from omote.perform.limits import check_within
from omote.perform.motion.mutual_gaze import contacts
from omote.perform.motion.sight import NOTHING, Point, Sight, eyes_of, sight_of_direction, sight_of_point
from omote.perform.scene.scene_frame import Place

MOST_POINTS = 32
LONGEST_POINT_NAME = 40
MOST_CAMERAS = 16
CAMERA: Point = (0.0, 0.0, 1.5)
"""Where the camera of a stage is taken to be that has not said so."""


@dataclass(frozen=True)
class Looker:
    """A character as others see it. eyes: where they are; seed: of its motion; present: whether it is on the stage, or
    on its way there."""

    place: Place
    eyes: Point
    target: GazeTarget
    seed: int
    present: bool = True


def check_point(x: object, y: object, z: object, what: str) -> Point:
    """A point of the scene; ValueError and TypeError for what is none."""
    given = zip((x, y, z), POINT_LIMITS.items(), strict=True)
    across, up, ahead = (
        check_within(value, low, high, f"the {name} of {what} (metres)") for value, (name, (low, high)) in given
    )
    return across, up, ahead


def check_point_name(name: object) -> str:
    """Returns the name of a gaze point without spaces around it; ValueError for none, or one that is too long."""
    text = name.strip() if isinstance(name, str) else ""
    if not 0 < len(text) <= LONGEST_POINT_NAME:
        raise ValueError(f"the name of a gaze point is {name!r:.100}; give 1 to {LONGEST_POINT_NAME} letters")
    return text


def find_sight(
    name: str, lookers: Mapping[str, Looker], points: Mapping[str, Point], cameras: Mapping[str, Point], time: float
) -> Sight:
    """What a character sees of what it looks at; nothing where that is gone or off the stage.

    lookers: all characters by name; points, cameras: by name, metres; time: of the scene, seconds.
    """
    own = lookers[name]
    target = own.target
    if target.kind == "direction":
        return sight_of_direction(target, body=own.place.turn)
    if target.kind == "character":
        return _sight_of_other(name, lookers, time)
    point = _point_of(target, points, cameras)
    return NOTHING if point is None else _sight(own, point)


def _point_of(target: GazeTarget, points: Mapping[str, Point], cameras: Mapping[str, Point]) -> Point | None:
    if target.kind == "point":
        return target.x, target.y, target.z
    if target.kind == "stage":
        return cameras.get(target.name, CAMERA if target.name or not cameras else next(iter(cameras.values())))
    return points.get(target.name)


def _sight_of_other(name: str, lookers: Mapping[str, Looker], time: float) -> Sight:
    own, other = lookers[name], lookers.get(lookers[name].target.name)
    if other is None or not other.present:
        return NOTHING
    seen = _sight(own, other.eyes)
    back = other.target
    if back.kind != "character" or back.name != name or not own.present:
        return seen
    first = name < own.target.name
    both = contacts((own.seed, other.seed) if first else (other.seed, own.seed), time)
    return Sight(seen.turn, seen.vergence, both[0 if first else 1])


def _sight(own: Looker, point: Point) -> Sight:
    return sight_of_point(point, own.eyes, body=own.place.turn, size=own.place.size)


def eyes_at(place: Place, turned: float) -> Point:
    """Where the eyes of a character are. turned: radians by which its head has gone with its gaze."""
    return eyes_of(place.x, place.depth, place.size, place.turn + turned)
