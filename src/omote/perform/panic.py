"""What a panic does beside the mixes: the values that hands left ease to rest, and a second press brings the home face.

A press within `SAME_PRESS` seconds of the last one is the same press: people hammer.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeVar

from omote.perform.easing import find_easing, is_over
from omote.perform.frame import Gaze, Head, Held

Turned = TypeVar("Turned", Head, Gaze)
PANIC_SECONDS = 0.25
"""From whatever shows to rest: soon enough to be at once, long enough not to be a jump."""
PANIC_EASING = "early"
"""Four fifths of the way in half of the time."""
SAME_PRESS = 0.7
"""Seconds within which a second panic is the same press."""


@dataclass(frozen=True)
class EasingToRest:
    """The channels, head and gaze that a panic found, `elapsed` seconds on their way to rest."""

    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    elapsed: float = 0.0


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
    channels = held.channels
    if left.channels:
        eases = {name: gone * channels.get(name, 0.0) + share * value for name, value in left.channels.items()}
        combined = {**channels, **eases}
        channels = {name: combined[name] for name in sorted(combined)}
    head = _eased(held.head, left.head, share)
    gaze = _eased(held.gaze, left.gaze, share)
    return Held(channels, head, gaze)


def _eased(turned: Turned, left: Turned, share: float) -> Turned:
    """A head or a gaze with a share of what is left of another; itself where nothing was."""
    if not any(vars(left).values()):
        return turned
    angles = vars(turned)
    return type(turned)(**{name: (1.0 - share) * angles[name] + share * value for name, value in vars(left).items()})
