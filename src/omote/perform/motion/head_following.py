"""The head follows the gaze: far shifts take it along, a little later than the eyes, which turn back as it comes."""

from __future__ import annotations

from dataclasses import dataclass

from omote.perform.layers.follower import follow_number, rate_of

EYES_ALONE = 0.30
"""Radians (17 degrees) that eyes turn without the head (Stahl 1999, *Experimental Brain Research* 126: 15 to 20)."""
EYES_ALONE_PITCH = 0.17
SHARE = 0.85
"""How much of what lies beyond the head takes over."""
FARTHEST_YAW = 1.3
FARTHEST_PITCH = 0.7
"""Radians (74 and 40 degrees) that a neck turns a head at most."""
HEAD_SECONDS = 0.45
"""In which the head has gone nine tenths of its way."""


@dataclass(frozen=True)
class Turn:
    """Two angles in radians: yaw and pitch."""

    yaw: float = 0.0
    pitch: float = 0.0

    def __add__(self, other: Turn) -> Turn:
        """Both one after the other."""
        return Turn(self.yaw + other.yaw, self.pitch + other.pitch)

    def __sub__(self, other: Turn) -> Turn:
        """What leads from the other to this."""
        return Turn(self.yaw - other.yaw, self.pitch - other.pitch)

    def scale(self, factor: float) -> Turn:
        """The same so many times."""
        return Turn(self.yaw * factor, self.pitch * factor)


AHEAD = Turn()


@dataclass(frozen=True)
class FollowingHead:
    """Where the head is, after both filters of its follower."""

    first: Turn = AHEAD
    second: Turn = AHEAD


def head_goal(looked: Turn) -> Turn:
    """Where the head comes to rest when somebody looks there."""
    yaw = _beyond(looked.yaw, EYES_ALONE)
    pitch = _beyond(looked.pitch, EYES_ALONE_PITCH)
    return Turn(min(max(yaw, -FARTHEST_YAW), FARTHEST_YAW), min(max(pitch, -FARTHEST_PITCH), FARTHEST_PITCH))


def follow_gaze(head: FollowingHead, looked: Turn, dt: float) -> FollowingHead:
    """The head `dt` seconds later, while the eyes look somewhere: two filters in a row, as in `layers.follower`.

    looked: where the eyes look.
    """
    goal = head_goal(looked)
    rate = rate_of(HEAD_SECONDS)
    yaw = follow_number(head.first.yaw, head.second.yaw, goal.yaw, rate, dt)
    pitch = follow_number(head.first.pitch, head.second.pitch, goal.pitch, rate, dt)
    return FollowingHead(Turn(yaw[0], pitch[0]), Turn(yaw[1], pitch[1]))


def _beyond(angle: float, alone: float) -> float:
    return SHARE * (max(angle - alone, 0.0) + min(angle + alone, 0.0))
