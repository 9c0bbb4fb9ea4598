"""Snapshots: the whole state of a performer beside its cast, and their validation when they come from a file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

from omote.model.space.expression import Expression
from omote.perform.axis import Axis, Call
from omote.perform.channels import with_channel
from omote.perform.easing import DECAY_SECONDS, Glide, find_easing
from omote.perform.frame import Gaze, Head
from omote.perform.lights import FIRST_LIGHT, LIGHTS
from omote.perform.limits import FOREVER, LONGEST_CALL, SHORTEST_CALL, check_known, check_within
from omote.perform.mix import HIGHEST, LOWEST, Weights


class Playable(Protocol):
    """What can be called: a cast, or any other faces and expressions by name."""

    @property
    def faces(self) -> Mapping[str, object]:
        """The faces, whatever stands for them."""

    @property
    def expressions(self) -> Mapping[str, Expression]:
        """The expressions: the engine itself needs their eyes."""

    @property
    def digest(self) -> str:
        """The digest of exactly these."""


ROUNDING = 1e-6
"""How far sums and ranges may be off after a long show."""


@dataclass(frozen=True)
class Snapshot:
    """The state of a performer: plain values, so msgspec writes and reads it exactly."""

    face: Axis
    expression: Axis
    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    time: float = 0.0
    light: Axis = field(default_factory=lambda: Axis(FIRST_LIGHT))  # older snapshots have no light


def check_snapshot(snapshot: Snapshot, cast: Playable) -> Snapshot:
    """Validates a snapshot and returns it; rejects one that the cast cannot play, or that no performer wrote."""
    _check_axis(snapshot.face, cast.faces, "face")
    _check_axis(snapshot.expression, cast.expressions, "expression")
    _check_axis(snapshot.light, LIGHTS, "light")
    for name, value in snapshot.channels.items():
        with_channel({}, cast.expressions, name, value)
    check_within(snapshot.time, 0.0, FOREVER, "the snapshot's time (seconds)")
    return snapshot


def names_held(snapshot: Snapshot) -> tuple[frozenset[str], frozenset[str]]:
    """The faces and the expressions (channels are expressions too) that a snapshot cannot be played without."""
    return _names_of(snapshot.face), _names_of(snapshot.expression) | frozenset(snapshot.channels)


def _names_of(axis: Axis) -> frozenset[str]:
    call = axis.call
    return frozenset((axis.on_air,) if call is None else (axis.on_air, call.target, *call.start, *call.velocity))


def _check_axis(axis: Axis, names: Mapping[str, object], what: str) -> None:
    check_known(axis.on_air, names, what)
    check_within(axis.hand, 0.0, 1.0, f"the {what} T-bar")
    if axis.call is not None:
        _check_call(axis.call, names, what)


def _check_call(call: Call, names: Mapping[str, object], what: str) -> None:
    for name in (call.target, *call.start, *call.velocity):
        check_known(name, names, what)
    find_easing(call.easing)
    for name, weight in call.start.items():
        check_within(weight, LOWEST - ROUNDING, HIGHEST + ROUNDING, f"the weight of the {what} {name}")
    _check_sum(call.start, 1.0, f"the weights of the {what}s")
    _check_sum(call.velocity, 0.0, f"the velocities of the {what}s")
    check_within(call.decay, 0.0, DECAY_SECONDS, "the decay of a call (seconds)")
    check_within(call.elapsed, 0.0, FOREVER, "the elapsed time of a call (seconds)")
    if call.seconds is not None:
        check_within(call.seconds, SHORTEST_CALL, LONGEST_CALL, "the time of a call (seconds)")
    if call.way is not None:
        _check_way(call.way)


def _check_way(way: Glide) -> None:
    check_within(way.origin, -ROUNDING, 1.0 + ROUNDING, "the origin of a T-bar's way")
    check_within(way.goal, 0.0, 1.0, "the goal of a T-bar's way")
    check_within(way.rate, -FOREVER, FOREVER, "the rate of a T-bar (per second)")
    check_within(way.seconds, 0.0, LONGEST_CALL, "the time of a T-bar's way (seconds)")
    check_within(way.elapsed, 0.0, FOREVER, "the elapsed time of a T-bar's way (seconds)")


def _check_sum(weights: Weights, expected: float, what: str) -> None:
    total = math.fsum(weights.values())
    slack = ROUNDING * (1.0 + math.fsum(abs(weight) for weight in weights.values()))
    if not abs(total - expected) <= slack:
        raise ValueError(f"{what} in the snapshot sum to {total!r}; they must sum to {expected:g}")
