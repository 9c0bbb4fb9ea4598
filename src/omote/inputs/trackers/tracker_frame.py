"""What every tracker's packet becomes: one frame of a face, in our names, angles and signs."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TypeVar

import msgspec

from omote.inputs.rejection import PacketError
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_within

T = TypeVar("T")
LONGEST_SUBJECT = 40
"""Letters of the name that a tracker gives its performer."""


class TrackerError(PacketError):
    """What came is no packet of this tracker, and why."""


@dataclass(frozen=True)
class TrackerFrame:
    """A frame of a face. weights: by channel as the tracker spells it, those that it sent; what it did not send keeps
    its value.

    head: yaw, pitch and roll, gaze: yaw and pitch (radians, + is the performer's left, up, tilt to the left); None
    where it sent none. found: whether it sees its performer. time: seconds by its own clock. subject: its name for the
    performer, "" where there is none.
    """

    weights: Mapping[str, float] = field(default_factory=dict)
    head: HeadAngles | None = None
    gaze: GazeAngles | None = None
    found: bool = True
    time: float | None = None
    subject: str = ""

    def __post_init__(self) -> None:
        """Rejects weights that no channel can take, and angles that are no numbers."""
        for name, value in self.weights.items():
            if not CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST:
                check_weight(name, value)
        for angle in (*(self.head or ()), *(self.gaze or ())):
            if not math.isfinite(angle):
                raise TrackerError("an angle of the head or of the eyes is no number")


Decode = Callable[[bytes], list[TrackerFrame]]
"""Reads a packet: the frames that it completes, newest last; TrackerError where it is none."""


def read_json(kind: type[T], data: bytes, what: str) -> T:
    """A document of a tracker: JSON, of a kind. what: how the sentence begins; TrackerError where it is none; data: as
    it came."""
    try:
        return msgspec.json.decode(data, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise TrackerError(f"{what}: {str(error)[:200]}") from error


def check_weight(name: str, value: object) -> float:
    """The weight that a tracker sent; TrackerError with its name where no channel can take it. value: as it came."""
    try:
        return check_within(value, CHANNEL_LOWEST, CHANNEL_HIGHEST, name[:LONGEST_SUBJECT])
    except (TypeError, ValueError) as error:
        raise TrackerError(str(error)) from error


def trim_subject(name: str) -> str:
    """A performer's name that can be shown and kept: printable, and not too long."""
    return "".join(letter for letter in name if letter.isprintable()).strip()[:LONGEST_SUBJECT]
