"""Whom or what the characters of a scene look at: points, other characters, cameras of stages, as each sees them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import lru_cache

from omote.perform.frame import POINT_LIMITS, GazeTarget
from omote.perform.limits import check_known, check_within
from omote.perform.motion.counter_hash import uniform
from omote.perform.motion.quantiles import MUTUAL_SPELL
from omote.perform.motion.sight import NOTHING, Point, Sight, eyes_of, sight_of_direction, sight_of_point
from omote.perform.scene.scene_frame import Place

SLOT = 6.0
"""Seconds in which two meet each other's eyes once: 45 in a hundred of the time (Argyle and Ingham 1972: 30 to 60)."""
SHORTEST_BREAK = 0.6
"""Seconds between two spells at least."""
BOTH = 0.6
"""The share of breaks in which the other looks away too."""
AFTER = 0.4
"""Seconds by which that is later, and the other back earlier."""
_LENGTH = 31
_BEGIN = 32
_WHO = 33
_BOTH = 34


@lru_cache(maxsize=64)
def contacts(seeds: tuple[int, int], time: float) -> tuple[bool, bool]:
    """Whether each of two who look at one another is at the other's eyes.

    Parameters
    ----------
    seeds : tuple of int
        Of both, in an order that stays.
    time : float
        Of the scene, seconds.

    Returns
    -------
    tuple of bool
        Of both; all from seeds and time, so that nothing has to be kept.
    """
    seed = seeds[0] * 2654435761 + seeds[1]
    slot = int(time // SLOT)
    begin, end = _spell(seed, slot)
    if begin <= time < end:
        return True, True
    if time < begin:  # the break since the spell before, which is that slot's
        slot, end, begin = slot - 1, _spell(seed, slot - 1)[1], begin
    else:
        begin = _spell(seed, slot + 1)[0]
    other = uniform(seed, _BOTH, slot) < BOTH and end + AFTER <= time < begin - AFTER
    first_leads = uniform(seed, _WHO, slot) < 0.5
    return (False, not other) if first_leads else (not other, False)


@lru_cache(maxsize=256)
def _spell(seed: int, slot: int) -> tuple[float, float]:
    """When the spell of a slot begins and ends."""
    length = MUTUAL_SPELL.at(uniform(seed, _LENGTH, slot))
    begin = SLOT * slot + (SLOT - SHORTEST_BREAK - length) * uniform(seed, _BEGIN, slot)
    return begin, begin + length


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
    """A point of the scene; ValueError and TypeError for what is none.

    x: to the picture's right; y: above the eyes; z: before the front line, all in metres.
    """
    limited = zip((x, y, z), POINT_LIMITS.items(), strict=True)
    across, up, ahead = (
        check_within(value, low, high, f"the {name} of {what} (metres)") for value, (name, (low, high)) in limited
    )
    return across, up, ahead


def check_point_name(name: object) -> str:
    """Returns the name of a gaze point without spaces around it; ValueError for none, or one that is too long."""
    text = name.strip() if isinstance(name, str) else ""
    if not 0 < len(text) <= LONGEST_POINT_NAME:
        raise ValueError(f"the name of a gaze point is {name!r:.100}; give 1 to {LONGEST_POINT_NAME} letters")
    return text


def check_target_there(
    kind: str, name: str, characters: Collection[str], points: Collection[str], cameras: Collection[str]
) -> None:
    """Raises ValueError where there is nothing of a name to look at.

    kind: of the target; name: of it; characters, points, cameras: the names of those that there are.
    """
    if kind == "gaze_point":
        check_known(name, points, "gaze point")
    if kind == "character":
        check_known(name, characters, "character")
    if kind == "stage" and name and name not in cameras:
        there = ", ".join(repr(camera) for camera in cameras if camera) or "none with a name"
        raise ValueError(
            f"there is no stage {name[:80]!r} in this show, which has {there}; open /stage?name={name[:80]} first, "
            "or give no name for the first stage"
        )


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
    own = lookers[name]
    other = lookers.get(lookers[name].target.name)
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
    """Where the eyes of a character are. turned: radians by which its head has gone with its gaze.

    place: where it stands, its size and its turn.
    """
    return eyes_of(place.x, place.depth, place.size, place.turn + turned)
