"""The head follows the gaze: far shifts take it along, a little later than the eyes, which turn back as it comes."""

from __future__ import annotations

from dataclasses import dataclass

from omote.perform.layers.follower import rate_of, steps_of

EYES_ALONE = 0.30
"""Radians (17 degrees) that eyes turn without the head (Stahl 1999, *Experimental Brain Research* 126: 15 to 20)."""
EYES_ALONE_PITCH = 0.17
SHARE = 0.85
"""How much of what lies beyond the head takes over."""
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
    return Turn(_beyond(looked.yaw, EYES_ALONE), _beyond(looked.pitch, EYES_ALONE_PITCH))


def follow_gaze(head: FollowingHead, looked: Turn, dt: float) -> FollowingHead:
    """The head `dt` seconds later, while the eyes look somewhere: two filters in a row, as in `layers.follower`."""
    goal = head_goal(looked)
    for step in steps_of(dt):
        z = rate_of(HEAD_SECONDS) * step
        left = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))
        ahead = head.first - goal
        second = goal + ((head.second - goal) + ahead.scale(z)).scale(left)
        head = FollowingHead(goal + ahead.scale(left), second)
    return head


def _beyond(angle: float, alone: float) -> float:
    return SHARE * (max(angle - alone, 0.0) + min(angle + alone, 0.0))
