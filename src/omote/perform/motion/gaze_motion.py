"""Fixations and saccades: the eyes go between the points of what is looked at, look away for a while, and come back."""

from __future__ import annotations

import math
from dataclasses import dataclass

from omote.perform.easing import EASINGS
from omote.perform.frame import with_fields
from omote.perform.motion.counter_hash import uniform
from omote.perform.motion.head_following import AHEAD, Turn
from omote.perform.motion.quantiles import (
    AWAY_FIXATION,
    AWAY_SPELL,
    AWAY_STEP,
    CONTACT_FIXATION,
    CONTACT_SPELL,
    CONTACT_STEP,
    Quantiles,
)

_SPELL = 11
_FIXATION = 12
_STEP = 13
_DIRECTION = 14
_BLINK = 15
DEGREE = math.pi / 180.0
SACCADE_SECONDS = 0.021
SACCADE_PER_DEGREE = 0.0022
"""The main sequence: how long a saccade takes (R. H. S. Carpenter 1988, *Movements of the eyes*)."""
LIDS_LEAD = 30.0 * DEGREE
"""Shifts that are farther begin with the lids (Evinger et al. 1994, *Experimental Brain Research* 100)."""
LEAD_SECONDS = 0.04
"""Seconds that the lids are ahead then."""
OTHER_GOAL = 3.0 * DEGREE
"""What is looked at and is elsewhere at once by more is reached by a saccade; what moves slower is followed."""
FLAT = 0.55
"""How much less the eyes go up and down than sideways."""
_BALLISTIC = EASINGS["smooth"]  # the polynomial of least jerk, as saccades and reaches have it (Flash and Hogan 1985)


@dataclass(frozen=True)
class Saccade:
    """A way of the eyes: from, to (radians, beside what is looked at), when it begins and how long it takes."""

    origin: Turn = AHEAD
    goal: Turn = AHEAD
    began: float = 0.0
    seconds: float = SACCADE_SECONDS

    def at(self, now: float) -> Turn:
        """Where the eyes are at a time."""
        share = min(max((now - self.began) / self.seconds, 0.0), 1.0)
        return self.origin + (self.goal - self.origin).scale(_BALLISTIC.value(share))


@dataclass(frozen=True)
class GazeMotion:
    """The eyes of a character. count: of saccades; contact: whether they are at what is looked at; spell, fixation: the
    times at which that, and this rest, ends; seen: where that was; lids: whether the last shift asks for a blink."""

    count: int = 0
    contact: bool = True
    spell: float = 1.0
    fixation: float = 0.5
    saccade: Saccade = Saccade()
    seen: Turn = AHEAD
    lids: bool = False


def looked_at(motion: GazeMotion, now: float) -> Turn:
    """Where the eyes look at a time, from the body: yaw and pitch in radians. motion: the character's; now: seconds."""
    return motion.seen + motion.saccade.at(now)


def advance_gaze(
    motion: GazeMotion, seed: int, now: float, seen: Turn, *, reach: float, contact: bool | None = None
) -> GazeMotion:
    """The eyes at `now`. seen: the direction of what is looked at; reach: how far they go elsewhere, 1 as people do;
    contact: whether they are to be at what is looked at, None where their own spells decide.

    motion, seed: the character's.
    """
    motion = _moved_to(motion, now, seen)
    other = now >= motion.spell if contact is None else contact != motion.contact
    arrived = now >= motion.saccade.began + motion.saccade.seconds
    if now < motion.fixation and not (other and arrived and contact is not None):
        return motion
    if other:
        motion = _other_spell(motion, seed, now)
    return _shifted(motion, seed, now, reach)


def _moved_to(motion: GazeMotion, now: float, seen: Turn) -> GazeMotion:
    """What is looked at is elsewhere: a small way is gone with it, a large one is caught up by a saccade at once."""
    if seen == motion.seen and not motion.lids:
        return motion
    way = seen - motion.seen
    if abs(way.yaw) + abs(way.pitch) <= OTHER_GOAL:
        return with_fields(motion, seen=seen, lids=False)
    stays = with_fields(
        motion.saccade, origin=motion.saccade.at(now) - way, goal=motion.saccade.at(now) - way, began=now
    )
    return with_fields(motion, seen=seen, saccade=stays, contact=False, spell=now, fixation=now, lids=False)


def _other_spell(motion: GazeMotion, seed: int, now: float) -> GazeMotion:
    spell = AWAY_SPELL if motion.contact else CONTACT_SPELL
    return with_fields(motion, contact=not motion.contact, spell=now + spell.at(uniform(seed, _SPELL, motion.count)))


def _shifted(motion: GazeMotion, seed: int, now: float, reach: float) -> GazeMotion:
    """The next saccade."""
    count = motion.count + 1
    steps, rests = (CONTACT_STEP, CONTACT_FIXATION) if motion.contact else (AWAY_STEP, AWAY_FIXATION)
    goal = _somewhere(steps, seed, count, reach)
    origin = motion.saccade.at(now)
    way = goal - origin
    amplitude = math.sqrt(way.yaw * way.yaw + way.pitch * way.pitch)
    lids = uniform(seed, _BLINK, count) < blink_share(amplitude)
    began = now + (LEAD_SECONDS if lids else 0.0)
    saccade = Saccade(origin, goal, began, SACCADE_SECONDS + SACCADE_PER_DEGREE * amplitude / DEGREE)
    rest = began + saccade.seconds + rests.at(uniform(seed, _FIXATION, count))
    return with_fields(motion, count=count, saccade=saccade, fixation=rest, lids=lids)


def blink_share(amplitude: float) -> float:
    """The share of gaze shifts of an amplitude (radians) that come with a blink: all of the far ones, few of the near
    ones (Evinger et al. 1994: 17 in a hundred below 17 degrees, 67 to 33 degrees)."""
    if amplitude >= LIDS_LEAD:
        return 1.0
    return 0.05 if amplitude < LIDS_LEAD / 4.0 else 0.17 if amplitude < LIDS_LEAD / 2.0 else 0.67


def _somewhere(steps: Quantiles, seed: int, count: int, reach: float) -> Turn:
    """A point about what is looked at, any direction as likely, flatter than round."""
    far = steps.at(uniform(seed, _STEP, count)) * DEGREE * reach
    x, y = _direction(uniform(seed, _DIRECTION, count))
    return Turn(far * x, far * y * FLAT)


def _direction(share: float) -> tuple[float, float]:
    """A direction of length one by a share of the way round a square: no sine of any platform."""
    side, way = divmod(4.0 * share, 1.0)
    along = 2.0 * way - 1.0
    x, y = ((1.0, along), (-along, 1.0), (-1.0, -along), (along, -1.0))[int(side)]
    length = math.sqrt(1.0 + along * along)
    return x / length, y / length
