"""Blinks: when lids close, how fast and how far."""

from __future__ import annotations

from dataclasses import dataclass

from omote.perform.easing import EASINGS
from omote.perform.frame import with_fields
from omote.perform.motion.counter_hash import uniform
from omote.perform.motion.quantiles import BLINK_DEPTH, BLINK_DOWN, BLINK_PAUSE, BLINK_UP, SPEECH_BLINKS

_PAUSE = 1
_DOWN = 2
_UP = 3
_DEPTH = 4
_END = 5
SHORTEST_PAUSE = 0.08
"""Seconds that lids rest open at least: a blink that is drawn waits until the one before is over."""
PHRASE_END = 0.55
"""The share of ends of speech at which somebody blinks."""
_LID = EASINGS["smooth"]


@dataclass(frozen=True)
class Blinks:
    """The lids of a character. count: of blinks so far; began, down, up, depth: the last one, seconds and 0..1; due:
    the seconds at rest that still have to pass; speaking: as it was before."""

    count: int = 0
    began: float = -10.0
    down: float = 0.1
    up: float = 0.2
    depth: float = 0.0
    due: float = BLINK_PAUSE.mean
    speaking: bool = False


def lid_closure(blinks: Blinks, now: float) -> float:
    """How far lids are closed at a time (seconds), 0..1. blinks: the lids of a character; now: seconds."""
    since = now - blinks.began
    if since <= 0.0 or since >= blinks.down + blinks.up:
        return 0.0
    if since < blinks.down:
        return blinks.depth * _LID.value(since / blinks.down)
    return blinks.depth * (1.0 - _LID.value((since - blinks.down) / blinks.up))


def is_blinking(blinks: Blinks, now: float) -> bool:
    """Whether a blink is on its way. blinks: the lids of a character; now: seconds."""
    return now - blinks.began < blinks.down + blinks.up + SHORTEST_PAUSE


def begin_blink(blinks: Blinks, seed: int, at: float, *, whole: bool = False) -> Blinks:
    """A blink at a time; none where one is on its way. whole: lids close altogether, as with a far gaze shift.

    blinks: the lids of a character; seed: the character's.
    """
    if is_blinking(blinks, at):
        return blinks
    count = blinks.count + 1
    depth = 1.0 if whole else BLINK_DEPTH.at(uniform(seed, _DEPTH, count))
    down = BLINK_DOWN.at(uniform(seed, _DOWN, count))
    up = BLINK_UP.at(uniform(seed, _UP, count))
    pause = BLINK_PAUSE.at(uniform(seed, _PAUSE, count))
    return Blinks(count, at, down, up, depth, pause, blinks.speaking)


def advance_blinks(blinks: Blinks, seed: int, now: float, dt: float, *, rate: float, speaking: bool) -> Blinks:
    """The lids `dt` seconds later, at `now`. rate: how often, 1 as at rest; 0 never.

    blinks: the lids of a character; seed: the character's; speaking: whether the lips move, which makes blinks come
    sooner.

    The pause is counted down, not set: another rate counts from the instant at which it is set.
    """
    passed = dt * rate * (SPEECH_BLINKS if speaking else 1.0)
    ended = blinks.speaking and not speaking and rate > 0.0
    drawn = ended and uniform(seed, _END, blinks.count) < PHRASE_END
    due = blinks.due - passed
    later = with_fields(blinks, due=due, speaking=speaking)
    if not drawn and due > 0.0:
        return later
    return begin_blink(later, seed, now)
