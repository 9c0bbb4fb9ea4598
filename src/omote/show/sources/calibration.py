"""The measure of a performer: from what a source sends to weights of channels, in one place behind all sources."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.perform.frame import Gaze, Head
from omote.perform.layers.source_frame import BodyFrame, check_smoothing
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_within
from omote.show.sources.mirrored_body import mirrored_body

LEAST_RANGE = 0.2
"""A performer who moved a channel less than this has not shown its range: it counts as the whole."""
SHUTTING = ("eyeBlink", "eyeSquint")
"""Channels of lids: at rest they are quite open, and at 1 quite shut where nobody has shown another end."""
MOST_LID_REST = 0.5
"""More of a lid at rest does not count as open: the rest was measured in a blink, and the eye would not shut."""
_SIDES = {"Left": "Right", "Right": "Left"}


@dataclass(frozen=True)
class Calibration:
    """A performer's measure. neutral: what a source sends of the face at rest; highest: of the largest moves, by
    channel. mirror: left and right are swapped. dead_zone: less is nothing. curve: above 0 small moves grow. gain: of
    all channels; lids: beside it, of those that shut the eyes. smoothing: seconds in which a step is followed, 0 as the
    source asks or its layer is."""

    neutral: Mapping[str, float] = field(default_factory=dict)
    highest: Mapping[str, float] = field(default_factory=dict)
    mirror: bool = False
    dead_zone: float = 0.0
    curve: float = 0.0
    gain: float = 1.0
    smoothing: float = 0.0
    lids: float = 1.0

    def __post_init__(self) -> None:
        """Rejects what is out of range."""
        for what, values in (("face at rest", self.neutral), ("largest move", self.highest)):
            for name, value in values.items():
                check_within(value, CHANNEL_LOWEST, CHANNEL_HIGHEST, f"{name} in the {what} of a performer")
        check_within(self.dead_zone, 0.0, 0.5, "the dead zone of a source")
        check_within(self.curve, -1.0, 1.0, "the curve of a source")
        check_within(self.gain, 0.0, 4.0, "the gain of a source")
        check_within(self.lids, 0.0, 4.0, "the gain of the lids of a source")
        check_smoothing(self.smoothing)


AS_IT_IS = Calibration()


@dataclass(frozen=True, eq=False)
class Measure:
    """A calibration for the channels of one source: of each the zero, the scale, the gain, the lowest weight, and the
    place that it is read from."""

    calibration: Calibration
    zero: Values
    scale: Values
    gain: Values
    lowest: Values
    places: NDArray[np.intp]

    def weights(self, sent: Values, low: float, high: float) -> Values:
        """The weights of the channels, low..high; what goes beyond the performer's range stays at its end. sent: one
        value for each channel."""
        if self.calibration == AS_IT_IS and (low, high) == (CHANNEL_LOWEST, CHANNEL_HIGHEST):
            return sent
        moved = (sent[self.places] - self.zero) * self.scale
        size = np.abs(moved)
        dead = self.calibration.dead_zone
        if dead:
            size = np.where(size > dead, (size - dead) / (1.0 - dead), 0.0)
        if self.calibration.curve:
            size = np.where(size < 1.0, size + self.calibration.curve * size * (1.0 - size), size)
        shaped = np.where(moved < 0.0, -size, size) * self.gain
        shaped = np.where(shaped > high, high, shaped)
        return np.maximum(shaped, np.maximum(low, self.lowest))

    def mirror_body(self, body: BodyFrame | None) -> BodyFrame | None:
        """A body, mirrored where the source is."""
        return mirrored_body(body) if self.calibration.mirror and body is not None else body

    def turn(self, head: Head | None, gaze: Gaze | None) -> tuple[Head | None, Gaze | None]:
        """A head and a gaze (radians), mirrored where the source is."""
        if self.calibration.mirror and head is not None:
            head = Head(-head.yaw, head.pitch, -head.roll)
        if self.calibration.mirror and gaze is not None:
            gaze = Gaze(-gaze.yaw, gaze.pitch)
        return head, gaze


def measure_of(calibration: Calibration, names: tuple[str, ...]) -> Measure:
    """The measure of a performer for channels of these names. calibration: how the performer is read."""
    read = [_mirrored(name, names) if calibration.mirror else name for name in names]
    zero = [_rest(calibration, name) for name in read]
    spans = [_span(calibration, name, start) for name, start in zip(read, zero, strict=True)]
    places = np.array([names.index(name) for name in read], np.intp)
    lids = [calibration.lids if name.startswith(SHUTTING) else 1.0 for name in read]
    gain = calibration.gain * np.array(lids)
    # an eye that is opened wider than at rest is not less shut than open
    shown = [name.startswith(SHUTTING) and name in calibration.neutral for name in read]
    lowest = np.where(shown, 0.0, CHANNEL_LOWEST)
    return Measure(calibration, np.array(zero), 1.0 / np.array(spans), gain, lowest, places)


def _rest(calibration: Calibration, name: str) -> float:
    """What a source sends of a channel at rest, as far as that counts."""
    rest = calibration.neutral.get(name, 0.0)
    if not name.startswith(SHUTTING) or 0.0 <= rest <= MOST_LID_REST:
        return rest
    return 0.0 if rest < 0.0 else MOST_LID_REST


def _span(calibration: Calibration, name: str, start: float) -> float:
    """How far a channel goes from its rest; as far as a whole one where nobody has shown it."""
    whole = 1.0 - start if name.startswith(SHUTTING) else 1.0
    span = calibration.highest.get(name, start + whole) - start
    return span if span >= LEAST_RANGE else whole


def _mirrored(name: str, names: Iterable[str]) -> str:
    """The channel of the other side, or itself where it has none."""
    for side, other in _SIDES.items():
        if name.endswith(side) and (twin := name.removesuffix(side) + other) in names:
            return twin
    return name
