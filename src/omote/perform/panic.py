"""What a panic does beside the mixes: the values that hands left ease to rest, and a second press brings the home face.

A press within `SAME_PRESS` seconds of the last one is the same press: people hammer.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeVar

from omote.perform.easing import bump, decay_seconds, find_easing, is_over
from omote.perform.frame import Gaze, Head, Held
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.perform.mix import HIGHEST, LOWEST

Turned = TypeVar("Turned", Head, Gaze)
PANIC_SECONDS = 0.25
"""From whatever shows to rest: soon enough to be at once, long enough not to be a jump."""
PANIC_EASING = "early"
"""Four fifths of the way in half of the time."""
SAME_PRESS = 0.7
"""Seconds within which a second panic is the same press."""


@dataclass(frozen=True)
class EasingToRest:
    """The channels, head and gaze that a panic found, `elapsed` seconds on their way to rest; `speed`: at which they
    moved then, per second, which dies out in `decay` seconds."""

    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    elapsed: float = 0.0
    speed: Held = field(default_factory=Held)
    decay: float = 0.0


def at_speed(found: EasingToRest, later: Held, dt: float) -> EasingToRest:
    """The same with the speed at which all of it moved, which dies out soon enough that nothing leaves its range.

    found: what a panic found; later: what would have been on air without it dt seconds later.
    """
    channels = {name: (later.channels.get(name, 0.0) - value) / dt for name, value in found.channels.items()}
    head = Head(*((after - value) / dt for value, after in zip(*_angles(found.head, later.head), strict=True)))
    gaze = Gaze(*((after - value) / dt for value, after in zip(*_angles(found.gaze, later.gaze), strict=True)))
    speed = Held(channels, head, gaze)
    start, rates = _as_weights(Held(found.channels, found.head, found.gaze), 0.5), _as_weights(speed, 0.0)
    goal = _as_weights(Held(dict.fromkeys(channels, 0.0)), 0.5)
    decay = decay_seconds(start, rates, goal, PANIC_SECONDS, find_easing(PANIC_EASING))
    return replace(found, speed=speed, decay=decay)


def _angles(one: Turned, other: Turned) -> tuple[list[float], list[float]]:
    return [*vars(one).values()], [*vars(other).values()]


def _as_weights(held: Held, middle: float) -> dict[str, float]:
    """Channels, and angles as weights whose range is that of a mix. middle: what an angle of 0 is."""
    half = (HIGHEST - LOWEST) / 2.0
    head = {f"head/{name}": middle + half * value / HEAD_LIMITS[name] for name, value in vars(held.head).items()}
    gaze = {f"gaze/{name}": middle + half * value / GAZE_LIMITS[name] for name, value in vars(held.gaze).items()}
    return {**held.channels, **head, **gaze}


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
    return replace(
        easing_to_rest, channels={name: value for name, value in easing_to_rest.channels.items() if name not in names}
    )


def eased(held: Held, easing_to_rest: EasingToRest | None) -> Held:
    """What is on air of channels, head and gaze: what holds them, with as much as is left of what eases to rest.

    held: what hands hold, or layers make since; easing_to_rest: what a panic left, None where all is at rest. Where
    nothing holds, what is left alone; a clip that is called meanwhile comes without a jump.
    """
    if easing_to_rest is None:
        return held
    left = easing_to_rest
    share = 1.0 - find_easing(PANIC_EASING).value(left.elapsed / PANIC_SECONDS)
    gone = 1.0 - share
    carried = left.decay * bump(left.elapsed / left.decay) if left.decay else 0.0
    channels = held.channels
    if left.channels:
        speeds = left.speed.channels
        eases = {
            name: gone * channels.get(name, 0.0) + share * value + carried * speeds.get(name, 0.0)
            for name, value in left.channels.items()
        }
        combined = {**channels, **eases}
        channels = {name: combined[name] for name in sorted(combined)}
    head = _eased(held.head, left.head, share, left.speed.head, carried)
    gaze = _eased(held.gaze, left.gaze, share, left.speed.gaze, carried)
    return Held(channels, head, gaze)


def _eased(turned: Turned, left: Turned, share: float, speed: Turned, carried: float) -> Turned:
    """A head or a gaze with a share of what is left of another, carried on by its speed; itself where nothing was."""
    if not any(vars(left).values()):
        return turned
    angles = vars(turned)
    speeds = vars(speed)
    return type(turned)(
        **{
            name: (1.0 - share) * angles[name] + share * value + carried * speeds[name]
            for name, value in vars(left).items()
        }
    )
