"""What a panic does beside the mixes: the values that hands and layers left ease to rest, at the speed at which they
moved, and a second press brings the home face.

A press within `SAME_PRESS` seconds of the last one is the same press: people hammer.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from omote.perform.easing import bump, decays, find_easing, is_over
from omote.perform.frame import Frame, Gaze, Head, Held, with_fields
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS
from omote.perform.mix import HIGHEST, LOWEST

PANIC_SECONDS = 0.25
"""From whatever shows to rest: soon enough to be at once, long enough not to be a jump."""
PANIC_EASING = "early"
"""Four fifths of the way in half of the time."""
SAME_PRESS = 0.7
"""Seconds within which a second panic is the same press."""
SLOWEST = 1e-6
FASTEST = 100.0
"""Per second: what is slower stands, and what is faster is a cut and counts as standing too. A lid closes at 20."""

Part = Literal["channels", "head", "gaze"]
Numbers = Mapping[str, float]


@dataclass(frozen=True)
class Carried:
    """The speed per second at which a panic found something, and the seconds in which that dies out. These are plain
    numbers, not angles: a gaze may move faster than it may stand aside."""

    speed: float
    decay: float


@dataclass(frozen=True)
class EasingToRest:
    """The channels, head and gaze that a panic found, `elapsed` seconds on their way to rest; moving: those that moved
    then, by part and name."""

    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    elapsed: float = 0.0
    moving: Mapping[Part, Mapping[str, Carried]] = field(default_factory=dict)


def at_speed(found: EasingToRest, soon: Frame, later: Frame, dt: float) -> EasingToRest:
    """The same with the speed at which all of it moved, which dies out soon enough that nothing leaves its range.

    Of the speeds in two moments the lower one is taken, and none where they point apart: so a cut between them is no
    motion.

    found: what a panic found; soon, later: what would have been on air without it dt and twice dt seconds later.
    """
    moving = dict[Part, dict[str, Carried]]()
    for part in _PARTS:
        after = _numbers(soon, part)
        last = _numbers(later, part)
        speeds = dict[str, float]()
        for name, value in _numbers(found, part).items():
            first = (after.get(name, 0.0) - value) / dt
            second = (last.get(name, 0.0) - after.get(name, 0.0)) / dt
            speed = min(first, second, key=abs) if first * second > 0.0 else 0.0
            if SLOWEST < abs(speed) < FASTEST:  # nothing that is not finite either
                speeds[name] = speed
        if speeds:
            moving[part] = _carried(part, _numbers(found, part), speeds)
    return replace(found, moving=moving)


def _carried(part: Part, found: Numbers, speeds: Numbers) -> dict[str, Carried]:
    """How some of what was found goes on: each is seen as a weight of a mix, whose range is its own."""
    ranges = np.array([_range(part, name, found[name]) for name in speeds])
    low = ranges[:, 0]
    scale = (HIGHEST - LOWEST) / (ranges[:, 1] - low)
    starts = LOWEST + (np.array([found[name] for name in speeds]) - low) * scale
    seconds = decays(
        starts, np.array([*speeds.values()]) * scale, LOWEST - low * scale, PANIC_SECONDS, find_easing(PANIC_EASING)
    )
    pairs = zip(speeds.items(), seconds.tolist(), strict=True)
    return {name: Carried(speed, decay) for (name, speed), decay in pairs if decay}


def _range(part: Part, name: str, value: float) -> tuple[float, float]:
    """Within which something stays that is found at a value, which is in its range: a weight goes little beyond 0 and 1
    where it was not."""
    if part != "channels":
        limit = _LIMITS[part][name]
        return -limit, limit
    if LOWEST <= value <= HIGHEST:
        return LOWEST, HIGHEST
    return CHANNEL_LOWEST, max(CHANNEL_HIGHEST, value)


_PARTS: tuple[Part, ...] = ("channels", "head", "gaze")
_LIMITS = {"head": HEAD_LIMITS, "gaze": GAZE_LIMITS}


def _numbers(held: Held | Frame | EasingToRest, part: Part) -> Numbers:
    return held.channels if part == "channels" else vars(getattr(held, part))


def ease_later(easing_to_rest: EasingToRest | None, dt: float) -> EasingToRest | None:
    """The same `dt` seconds later; None once all is at rest.

    easing_to_rest: what a panic left; None where all is at rest.
    """
    if easing_to_rest is None or is_over(easing_to_rest.elapsed + dt, PANIC_SECONDS):
        return None
    return replace(easing_to_rest, elapsed=easing_to_rest.elapsed + dt)


def without_channels(easing_to_rest: EasingToRest | None, names: Container[str]) -> EasingToRest | None:
    """The same without channels that a hand has taken again.

    easing_to_rest: what a panic left; None where all is at rest; names: of the channels.
    """
    if easing_to_rest is None:
        return None
    channels = {name: value for name, value in easing_to_rest.channels.items() if name not in names}
    moving = {name: each for name, each in easing_to_rest.moving.get("channels", {}).items() if name in channels}
    return replace(easing_to_rest, channels=channels, moving={**easing_to_rest.moving, "channels": moving})


def without_turn(easing_to_rest: EasingToRest | None, part: Literal["head", "gaze"]) -> EasingToRest | None:
    """The same without the head, or the gaze, that a hand has taken again.

    easing_to_rest: what a panic left; None where all is at rest; part: which.
    """
    if easing_to_rest is None:
        return None
    at_rest = {"head": Head()} if part == "head" else {"gaze": Gaze()}
    return with_fields(easing_to_rest, **at_rest, moving={**easing_to_rest.moving, part: {}})


def eased(held: Held, easing_to_rest: EasingToRest | None) -> Held:
    """What is on air of channels, head and gaze: what holds them, with as much as is left of what eases to rest.

    held: what hands hold, or layers make since; easing_to_rest: what a panic left, None where all is at rest. Where
    nothing holds, what is left alone; a clip that is called meanwhile comes without a jump. Nothing leaves its range.
    """
    if easing_to_rest is None:
        return held
    channels = held.channels
    if easing_to_rest.channels:
        combined = {**channels, **_eased(held, easing_to_rest, "channels")}
        channels = {name: combined[name] for name in sorted(combined)}
    head = Head(**_eased(held, easing_to_rest, "head")) if _turns(easing_to_rest, "head") else held.head
    gaze = Gaze(**_eased(held, easing_to_rest, "gaze")) if _turns(easing_to_rest, "gaze") else held.gaze
    return Held(channels, head, gaze)


def _turns(left: EasingToRest, part: Part) -> bool:
    return any(_numbers(left, part).values()) or bool(left.moving.get(part))


def _eased(held: Held, left: EasingToRest, part: Part) -> dict[str, float]:
    """The numbers of a part with a share of what was found, carried on by its speed."""
    share = 1.0 - find_easing(PANIC_EASING).value(left.elapsed / PANIC_SECONDS)
    gone = 1.0 - share
    holds = _numbers(held, part)
    moving = left.moving.get(part, {})
    shown = dict[str, float]()
    for name, value in _numbers(left, part).items():
        other = holds.get(name, 0.0)
        at = gone * other + share * value
        if (carried := moving.get(name)) is not None and carried.decay:
            at += carried.speed * carried.decay * bump(left.elapsed / carried.decay)
        low, high = _range(part, name, value)
        shown[name] = min(max(at, min(low, other)), max(high, other))
    return shown
