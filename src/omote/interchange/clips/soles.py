"""Soles on the floor: feet of other skeletons are raised until no body of the cast stands in it.

A file has ankles, and angles of feet; how far soles and toes are below an ankle differs from body to body.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.model.body.figures import Figures
from omote.model.body.skeleton import SIDES
from omote.model.cast import Cast
from omote.perform.figures.figure import pose_figure, resting_figure, skin_figure
from omote.perform.figures.pose_mix import MixedPose

SOLE_METRES = 0.05
"""Above the floor: what of a foot that stands is its sole."""
WAYS = 16
STEEP = (-2.0, -0.5)
"""Directions along the floor, and how far down each goes beside, in which the farthest point of a sole is kept: a foot
that tilts stands on one of them."""


@dataclass(frozen=True, eq=False)
class Sole:
    """A foot that stands. heel (n, 3): the edge of what turns with the foot, from the ankle; tip (m, 3): of what turns
    with the toes, from where they begin; toes (3,): that, from the ankle; height: of the ankle above the floor; all in
    lengths of the leg of its body."""

    heel: Points
    tip: Points
    toes: Points
    height: float


def cast_soles(cast: Cast) -> list[tuple[Sole, Sole]]:
    """The left and the right sole of each body of a cast with figures, below its own face."""
    figures = cast.figures
    assert figures is not None
    first = next(iter(cast.faces))
    return [
        _soles(figures, name, cast.faces[name if name in cast.faces else first].positions.astype(np.float64))
        for name in cast.bodies
    ]


def above_floor(
    poses: Sequence[MixedPose], soles: Sequence[tuple[Sole, Sole]], toes: tuple[int, int]
) -> list[MixedPose]:
    """Poses whose feet are raised out of the floor, and hips with them where both are.

    poses: of n frames; soles: of each body; toes: the places of the left and the right toes among bones.
    """
    lifts = np.zeros((len(poses), 2))
    for foot in range(2):
        ankles = np.array([pose.feet[foot, 1] for pose in poses])
        turns = Rotation.from_rotvec(np.array([pose.feet_turns[foot] for pose in poses]))
        bent = turns * Rotation.from_rotvec(np.array([pose.turns[toes[foot]] for pose in poses]))
        for sole in (each[foot] for each in soles):
            lowest = ankles + sole.height + _lowest(sole, turns.as_matrix()[:, 1], bent.as_matrix()[:, 1])
            lifts[:, foot] = np.maximum(lifts[:, foot], -lowest)
    up = np.array([0.0, 1.0, 0.0])
    return [
        replace(pose, travel=pose.travel + lift.min() * up, feet=pose.feet + lift[:, None] * up)
        for pose, lift in zip(poses, lifts, strict=True)
    ]


def _lowest(sole: Sole, foot: Values, toes: Values) -> Values:
    """How far the lowest point is above the ankle (n,). foot, toes (n, 3): the rows of their rotations that say y."""
    heel = (foot @ sole.heel.T).min(axis=1)
    tip = foot @ sole.toes + (toes @ sole.tip.T).min(axis=1)
    return np.asarray(np.minimum(heel, tip))


def _soles(figures: Figures, name: str, head: Points) -> tuple[Sole, Sole]:
    space = figures.space
    places = space.skeleton.places
    resting = resting_figure(figures, {name: 1.0}, head)
    still = MixedPose(np.zeros((len(space.skeleton.names), 3)), np.zeros(3), np.zeros((2, 3)), np.zeros((2, 3)))
    bones = pose_figure(space, resting, still)
    rows = skin_figure(space, resting, bones).astype(np.float64)
    floor = float(rows[:, 1].min())
    low = rows[rows[:, 1] < floor + SOLE_METRES]
    made = []
    for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
        ankle, toes = (bones.joints[places[f"{bone}.{side}"]] for bone in ("foot", "toes"))
        own = low[sign * low[:, 0] > 0.0]
        ahead = own[:, 2] > toes[2]
        heel, tip = (_edge(points - at) / resting.leg for points, at in ((own[~ahead], ankle), (own[ahead], toes)))
        made.append(Sole(heel, tip, (toes - ankle) / resting.leg, float(ankle[1] - floor) / resting.leg))
    return made[0], made[1]


def _edge(points: Points) -> Points:
    """The points that are farthest in each direction along the floor, of those that are lowest."""
    angles = np.linspace(0.0, 2.0 * np.pi, WAYS, endpoint=False)
    ways = np.hstack([np.stack([np.cos(angles), np.full(WAYS, down), np.sin(angles)]) for down in STEEP])
    return np.asarray(points[np.unique((points @ ways).argmax(axis=0))])
