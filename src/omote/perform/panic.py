"""What a panic does beside the mixes: the values that hands left ease to rest, and a second press brings the home face.

A press within `SAME_PRESS` seconds of the last one is the same press: people hammer.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace

from omote.perform.easing import find_easing, is_over
from omote.perform.frame import Gaze, Head

PANIC_SECONDS = 0.25
"""From whatever shows to rest: soon enough to be at once, long enough not to be a jump."""
PANIC_EASING = "early"
"""Four fifths of the way in half of the time."""
SAME_PRESS = 0.7


@dataclass(frozen=True)
class Settling:
    """The channels, head and gaze that a panic found, `elapsed` seconds on their way to rest."""

    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    elapsed: float = 0.0


def settled_later(settling: Settling | None, dt: float) -> Settling | None:
    """The same `dt` seconds later; None once all is at rest."""
    if settling is None or is_over(settling.elapsed + dt, PANIC_SECONDS):
        return None
    return replace(settling, elapsed=settling.elapsed + dt)


def without_channels(settling: Settling | None, names: Container[str]) -> Settling | None:
    """The same without channels that a hand has taken again."""
    if settling is None:
        return None
    return replace(settling, channels={one: value for one, value in settling.channels.items() if one not in names})


def with_settling_channels(channels: Mapping[str, float], settling: Settling | None) -> Mapping[str, float]:
    """The channels on air: those that hands hold, and what is left of those that settle."""
    if settling is None or not settling.channels:
        return channels
    share = _share_left(settling)
    found = {**channels, **{name: share * value for name, value in settling.channels.items()}}
    return {name: found[name] for name in sorted(found)}


def with_settling_head(head: Head, settling: Settling | None) -> Head:
    """The head on air: as a hand holds it, or what is left of a turn that settles."""
    if settling is None or settling.head == Head():
        return head
    share, left = _share_left(settling), settling.head
    return Head(share * left.yaw, share * left.pitch, share * left.roll)


def with_settling_gaze(gaze: Gaze, settling: Settling | None) -> Gaze:
    """The gaze on air: as a hand holds it, or what is left of one that settles."""
    if settling is None or settling.gaze == Gaze():
        return gaze
    share = _share_left(settling)
    return Gaze(share * settling.gaze.yaw, share * settling.gaze.pitch)


def _share_left(settling: Settling) -> float:
    return 1.0 - find_easing(PANIC_EASING).value(settling.elapsed / PANIC_SECONDS)
