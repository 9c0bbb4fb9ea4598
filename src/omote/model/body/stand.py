"""The neutral stand: how the bones of a body turn from the pose it was modelled in to the stand that all poses start
from.

Bodies were modelled with arms away from the trunk and elbows bent, each a little differently. A pose belongs to no
body, so its angles count from one stand, in which the limbs of every body have the same directions: arms hang, palms to
the thighs, knees straight, feet flat. Trunk, neck and head stay as modelled: they are the body's own.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.model.body.skeleton import SIDES, Skeleton
from omote.model.body.twist import twist_about

OUT = {"L": 1.0, "R": -1.0}
"""Which way is out, along x."""
UPPER_ARM = (9.0, 2.0)
FOREARM = (5.0, 14.0)
HAND = (3.0, 16.0)
"""Degrees outward and forward of hanging straight down."""
PALM = 12.0
"""Degrees by which the hanging hand's thumb side turns inward from straight ahead."""
KNEE = 3.0
"""Degrees by which thigh and shin lean forward and back: a knee that is not quite straight bends the right way."""
TOES_OUT = 8.0
"""Degrees of each foot."""
TWIST = {"lowerarm01": 0.15, "lowerarm02": 0.70}
"""Of the turn of the hand about the forearm, how much each half of it has taken up (body.md, section 3)."""


def stand_turns(skeleton: Skeleton, joints: Points, ends: Points) -> Values:
    """The rotation (J, 3, 3) of each bone from the modelled pose to the stand, along the head's axes.

    skeleton: of the body; joints (J, 3), ends (J, 3): where its bones begin and end as modelled, metres.
    """
    turns = np.tile(np.eye(3), (len(skeleton.names), 1, 1))
    for side in SIDES:
        _hang_arm(skeleton, joints, side, turns)
        _straighten_leg(skeleton, joints, ends, side, turns)
    return turns


def hanging(outward: float, forward: float, side: str) -> Values:
    """A direction (3,) by how far it leans outward and forward of straight down, degrees. side: L or R."""
    out = math.radians(outward)
    ahead = math.radians(forward)
    way = np.array([OUT[side] * math.tan(out), -1.0, math.tan(ahead)])
    return np.asarray(way / np.linalg.norm(way))


def _hang_arm(skeleton: Skeleton, joints: Points, side: str, turns: Values) -> None:
    """Turns the bones of an arm: elbows bend about one axis on all bodies, and hands lie as all hands do."""
    at = {name: joints[skeleton.places[f"{name}.{side}"]] for name in ("upperarm01", "lowerarm01", "wrist")}
    upper = unit(at["lowerarm01"] - at["upperarm01"])
    fore = unit(at["wrist"] - at["lowerarm01"])
    down = hanging(*UPPER_ARM, side)
    arm = frame(down, [-1.0, 0.0, 0.0]) @ frame(upper, np.cross(upper, fore)).T
    forearm = shortest_turn(arm @ fore, hanging(*FOREARM, side)) @ arm
    hand = _hand_frame(skeleton, joints, side)
    inward = math.radians(PALM)
    thumb = np.array([-OUT[side] * math.sin(inward), 0.0, math.cos(inward)])
    palm = frame(hanging(*HAND, side), thumb) @ hand.T
    twist = twist_about(palm @ forearm.T, forearm @ fore)
    _set(skeleton, turns, side, ("upperarm01", "upperarm02"), arm)
    for name, share in TWIST.items():
        turned = Rotation.from_rotvec(share * twist * (forearm @ fore)).as_matrix() @ forearm
        _set(skeleton, turns, side, (name,), turned)
    fingers = [
        name[:-2] for name in skeleton.names if name.endswith(side) and name.startswith(("metacarpal", "finger"))
    ]
    _set(skeleton, turns, side, ("wrist", *fingers), palm)


def _hand_frame(skeleton: Skeleton, joints: Points, side: str) -> Values:
    """The hand as modelled: along its middle finger, and across it to the thumb's side."""
    wrist, middle, index, little = (
        joints[skeleton.places[f"{name}.{side}"]] for name in ("wrist", "finger3-1", "finger2-1", "finger5-1")
    )
    return frame(unit(middle - wrist), index - little)


def _straighten_leg(skeleton: Skeleton, joints: Points, ends: Points, side: str, turns: Values) -> None:
    """Turns the bones of a leg: thigh and shin straight below the hip, the foot flat, as it was modelled."""
    hip, knee, ankle = (joints[skeleton.places[f"{name}.{side}"]] for name in ("upperleg01", "lowerleg01", "foot"))
    thigh = shortest_turn(unit(knee - hip), hanging(0.0, KNEE, side))
    shin = shortest_turn(thigh @ unit(ankle - knee), hanging(0.0, -KNEE, side)) @ thigh
    _set(skeleton, turns, side, ("upperleg01", "upperleg02"), thigh)
    _set(skeleton, turns, side, ("lowerleg01", "lowerleg02"), shin)
    ahead = ends[skeleton.places[f"toes.{side}"]] - ankle
    yaw = OUT[side] * math.radians(TOES_OUT) - math.atan2(ahead[0], ahead[2])
    _set(skeleton, turns, side, ("foot", "toes"), Rotation.from_rotvec([0.0, yaw, 0.0]).as_matrix())


def _set(skeleton: Skeleton, turns: Values, side: str, names: tuple[str, ...], turn: Values) -> None:
    turns[[skeleton.places[f"{name}.{side}"] for name in names]] = turn


def frame(along: Values, about: Values | list[float]) -> Values:
    """A frame (3, 3): its columns are the direction along, the part of `about` that stands on it, and their product."""
    way = np.asarray(about, np.float64)
    square = unit(way - along * (way @ along))
    return np.stack([along, square, np.cross(along, square)], axis=1)


def shortest_turn(before: Values, after: Values) -> Values:
    """The rotation (3, 3) by the smallest angle that takes a direction (3,) from where it is before to where it is
    after."""
    axis = np.cross(before, after)
    sine = np.linalg.norm(axis)
    if sine < 1e-9:
        return np.eye(3)
    angle = math.atan2(sine, float(before @ after))
    return np.asarray(Rotation.from_rotvec(axis / sine * angle).as_matrix())


def unit(way: Values) -> Values:
    """A direction of length one."""
    return np.asarray(way / np.linalg.norm(way))
