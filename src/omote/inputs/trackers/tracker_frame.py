"""What every tracker's packet becomes: one frame of a face, in our names, angles and signs."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple, TypeVar

import msgspec

from omote.inputs.rejection import PacketError
from omote.inputs.trackers.body_bones import BodyBones
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles
from omote.inputs.trackers.loose_json import load_loosely
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST

T = TypeVar("T")
LONGEST_SUBJECT = 40
"""Letters of the name that a tracker gives its performer."""
MOST_SHAPES = 1024
"""Values of one frame that are read; a model has no more that a face has."""
MOST_TURN = 1000.0
"""Radians; an angle beyond says no direction."""

ANGLES = frozenset({"head", "gaze", "leftEye", "rightEye"})
"""What is left out by its name and is no channel."""


class TrackerError(PacketError):
    """What came is no packet of this tracker, and why."""


class LeftOut(NamedTuple):
    """What of a packet is not played as it came. name: of the value, "" where it has none; reason: in words."""

    name: str
    reason: str


@dataclass(frozen=True)
class TrackerFrame:
    """A frame of a face. weights: by channel as the tracker spells it, those that it sent; what it did not send keeps
    its value. One that is no number is left out, one out of a channel's range is at its end.

    head: yaw, pitch and roll, gaze: yaw and pitch (radians, + is the performer's left, up, tilt to the left); None
    where it sent none. found: whether it sees its performer. time: seconds by its own clock. subject: its name for the
    performer, "" where there is none. left_out: what of the packet is not there as it came. bones: of its body.
    """

    weights: Mapping[str, float] = field(default_factory=dict)
    head: HeadAngles | None = None
    gaze: GazeAngles | None = None
    found: bool = True
    time: float | None = None
    subject: str = ""
    left_out: tuple[LeftOut, ...] = ()
    bones: BodyBones | None = None

    def __post_init__(self) -> None:
        """Amends what no channel, head or eye can take, value by value."""
        for value in self.weights.values():
            if not CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST:
                self._amend_weights()
                break
        for angle in (*(self.head or ()), *(self.gaze or ())):
            if not -MOST_TURN <= angle <= MOST_TURN:
                self._amend_angles()
                break

    def _amend_weights(self) -> None:
        weights: dict[str, float] = {}
        wrong: list[LeftOut] = []
        for name, value in self.weights.items():
            if CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST:
                weights[name] = value
            elif not math.isfinite(value):
                wrong.append(LeftOut(name, f"{name[:LONGEST_SUBJECT]} is no number"))
            else:
                weights[name] = min(CHANNEL_HIGHEST, max(CHANNEL_LOWEST, value))
                said = f"{name[:LONGEST_SUBJECT]} is {value:.4g}"
                wrong.append(LeftOut(name, f"{said}, so {weights[name]:g} is taken"))
        self._amend("weights", weights, wrong)

    def _amend_angles(self) -> None:
        for name, angles in (("head", self.head), ("gaze", self.gaze)):
            if not all(-MOST_TURN <= angle <= MOST_TURN for angle in angles or ()):
                self._amend(name, None, [LeftOut(name, f"an angle of the {name} is no number")])

    def _amend(self, name: str, value: object, wrong: list[LeftOut]) -> None:
        object.__setattr__(self, name, value)
        object.__setattr__(self, "left_out", (*self.left_out, *wrong))


Decode = Callable[[bytes], list[TrackerFrame]]
"""Reads a packet: the frames that it completes, newest last; TrackerError where it is none."""


def read_json(kind: type[T], data: bytes, what: str, loosely: Callable[[Any], T | None] = lambda _: None) -> T:
    """A document of a tracker: JSON, of a kind; TrackerError where it is none.

    data: as it came; what: how the sentence begins; loosely: makes the same of a document that strangers write
    otherwise, None where it is none.
    """
    try:
        return msgspec.json.decode(data, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        found = loosely(load_loosely(bytes(data)))
        if found is None:
            raise TrackerError(f"{what}: {str(error)[:200]}") from error
        return found


def read_weight(name: str, value: object) -> float:
    """The weight that a tracker sent, whatever its size; TrackerError with its name where it is none. value: as it
    came."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TrackerError(f"{name[:LONGEST_SUBJECT]} must be a number, not {value!r:.40}")
    return float(value)


def trim_subject(name: str) -> str:
    """A performer's name that can be shown and kept: printable, and not too long."""
    return "".join(letter for letter in name if letter.isprintable()).strip()[:LONGEST_SUBJECT]
