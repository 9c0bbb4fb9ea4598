"""The chest follows the head, whoever turns it: eyes first, then head, then trunk."""

from __future__ import annotations

from omote.perform.layers.follower import follow_number, rate_of

HEAD_ALONE = 0.26
"""Radians (15 degrees) that a head turns without its chest."""
SHARE = 0.4
"""How much of what lies beyond the chest takes over; the neck keeps the rest."""
FARTHEST = 0.52
"""Radians (30 degrees), of the pose `chest_left`."""
CHEST_SECONDS = 0.9
"""In which the chest has gone nine tenths of its way: twice the head's, since trunks start last and are slowest (Land
2004, *Experimental Brain Research* 159: eyes, head and trunk in large turns)."""
NEAR = 1e-5
"""Of the pose: what is nearer to its goal is there, so that a stage need not draw on."""
AT_HOME = (0.0, 0.0)
"""A chest that looks ahead, after each filter of its follower."""

Chest = tuple[float, float]


def chest_goal(yaw: float) -> float:
    """How much of the pose `chest_left` a figure comes to whose head is turned; below 0: to its right.

    yaw: of the head, radians, + to its left.
    """
    beyond = max(yaw - HEAD_ALONE, 0.0) + min(yaw + HEAD_ALONE, 0.0)
    return min(max(SHARE * beyond / FARTHEST, -1.0), 1.0)


def follow_head(chest: Chest, yaw: float, dt: float) -> Chest:
    """The chest `dt` seconds later. chest: after both filters; yaw: of the head, radians."""
    goal = chest_goal(yaw)
    first, second = follow_number(*chest, goal, rate_of(CHEST_SECONDS), dt)
    return (goal, goal) if max(abs(first - goal), abs(second - goal)) < NEAR else (first, second)
