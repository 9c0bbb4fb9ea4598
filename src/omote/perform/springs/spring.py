"""A damped spring that a motion drives, and its exact step; of +, -, *, / and square roots alone, so that a show
replays bit for bit on any machine."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from types import MappingProxyType
from typing import NamedTuple

from omote.model.space.expression import refuse_name
from omote.perform.limits import check_within

FASTEST = 12.0
"""Radians a second at most that a driver counts; a head reaches 7 in its fastest turns (Grossman et al. 1988)."""
CUT = 2.0 * FASTEST
"""Radians a second; what is faster has not moved but been put elsewhere, and drives nothing."""
LONGEST_STEP = 0.25
"""Seconds; over a longer one nobody knows how the driver went."""
LONGEST_FILLED_STEP = 1.0 / 24.0
"""Seconds to which a step makes up for what straight lines between ticks take from a kick."""
FORGOTTEN = 64.0
"""Seconds after which every spring is at rest."""
_TERMS = 8
_LARGEST = 0.25
_SMALL_TURN = 1e-6
_SMALL_SPEED = 1e-5
_DEAD = 0.0003
"""Of a weight: what is smaller is not played, so that a head that breathes leaves the channel alone. As much may show
at once where a swing grows: with .004 cheeks then changed their speed by 1/7 of the largest in 1/240 s."""
TURNS = ("yaw", "pitch", "roll", "x")
"""Drivers that are no channels."""
RANGES: Mapping[str, tuple[float, float]] = MappingProxyType(
    {"frequency": (0.5, 10.0), "damping": (0.05, 1.0), "gain": (-20.0, 20.0), "limit": (0.05, 1.0)}
)


@dataclass(frozen=True)
class Spring:
    """A field that a damped spring plays, driven by how a head or anything else moves.

    Parameters
    ----------
    channel : str
        The channel that it plays: a signed field, such as "ears-sway".
    frequency : float
        Hz, 0.5 to 10.
    damping : float
        The damping ratio, 0.05 to 1 (critical).
    drivers : mapping of float
        What drives it: radians by unit of each. `yaw`, `pitch`, `roll` of the head (radians; a body that turns turns
        the head), `x`, the character's place (metres), or a channel by its name (weight).
    gain : float
        Weight of the field by radian that the spring lags, -20 to 20.
    limit : float
        The largest weight, 0.05 to 1, which it approaches softly.

    Raises
    ------
    ValueError
        On numbers out of range, a name that no channel can have, and without drivers.
    TypeError
        On what is no number.
    """

    channel: str
    frequency: float
    damping: float
    drivers: Mapping[str, float]
    gain: float
    limit: float = 1.0
    turns: tuple[float, float, float, float] = field(init=False, repr=False, compare=False)
    others: tuple[tuple[str, float], ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Rejects what is no spring."""
        refuse_name(self.channel, "the channel of a spring")
        for name, (low, high) in RANGES.items():
            number = check_within(getattr(self, name), low, high, f"the {name} of the spring of {self.channel}")
            object.__setattr__(self, name, number)
        if not self.drivers:
            raise ValueError(f"the spring of {self.channel} has no driver; name one, such as yaw, with its radians")
        drivers = {
            name: check_within(value, -20.0, 20.0, f"the radians by unit of {name} that drive {self.channel}")
            for name, value in self.drivers.items()
        }
        object.__setattr__(self, "drivers", MappingProxyType(drivers))
        object.__setattr__(self, "turns", tuple(drivers.get(name, 0.0) for name in TURNS))
        others = tuple((name, radians) for name, radians in drivers.items() if name not in TURNS)
        object.__setattr__(self, "others", others)


class SpringState(NamedTuple):
    """A spring that moves. turn: radians by which it is off its driver, and speed: by which that changes, a second;
    driver: where its driver is, radians; driver_speed: radians a second, None where that is not known; first, second:
    its amount, after both filters."""

    turn: float = 0.0
    speed: float = 0.0
    driver: float | None = None
    driver_speed: float | None = None
    first: float = 0.0
    second: float = 0.0


class Decay(NamedTuple):
    """What a step makes of a spring: turn by turn and by speed, speed by turn and by speed; kick: by how much more a
    change of the driver's speed counts than it would at endlessly many ticks."""

    turn_turn: float
    turn_speed: float
    speed_turn: float
    speed_speed: float
    kick: float


@lru_cache(maxsize=512)
def decay_of(frequency: float, damping: float, dt: float) -> Decay:
    """The exact decay of a spring in a step: exp(A dt) with A = [[0, 1], [-w^2, -2 damping w]].

    Eight terms of its series at a halved step, squared again; every power of A is p 1 + q A (Cayley and Hamilton).

    Parameters
    ----------
    frequency : float
        Hz.
    damping : float
        The damping ratio.
    dt : float
        Seconds, above 0; beyond 64 all has decayed.

    Returns
    -------
    Decay
        Within 1e-11 of exp, cos and sin, but for the kick.
    """
    rate = 2.0 * math.pi * frequency
    stiffness = rate * rate
    friction = 2.0 * damping * rate
    step = min(dt, FORGOTTEN)
    halvings = 0
    while step * rate > _LARGEST:
        step *= 0.5
        halvings += 1
    one = power_one = 1.0  # the series so far is one 1 + times A
    times = power_times = 0.0
    for term in range(1, _TERMS + 1):
        share = step / term
        power_one, power_times = -stiffness * power_times * share, (power_one - friction * power_times) * share
        one += power_one
        times += power_times
    for _ in range(halvings):
        one, times = (
            one * one - stiffness * times * times,
            2.0 * one * times - friction * times * times,
        )
    return Decay(one, times, -stiffness * times, one - friction * times, _fill(frequency, dt))


def _fill(frequency: float, dt: float) -> float:
    """What straight lines between ticks leave of a sine of the spring's own frequency, sinc squared, turned round:
    (x / sin x)^2 as a series."""
    x = math.pi * frequency * min(dt, LONGEST_FILLED_STEP)
    square = x * x
    return 1.0 + square * (1.0 / 3.0 + square * (1.0 / 15.0 + square * (2.0 / 189.0 + square / 675.0)))


def advance_spring(spring: Spring, state: SpringState, driver: float, dt: float) -> SpringState:
    """A spring `dt` seconds later, its amount as it is.

    spring: which; state: as it is; driver: where its driver is now, radians; dt: above 0. A driver that was put
    elsewhere, or that nobody saw for long, does not kick.
    """
    turn, speed, before, speed_before, first, second = state
    driven: float | None = None
    if before is not None and dt <= LONGEST_STEP:
        driven = (driver - before) / dt
        if driven > FASTEST:
            driven = FASTEST if driven <= CUT else None
        elif driven < -FASTEST:
            driven = -FASTEST if driven >= -CUT else None
    turn_turn, turn_speed, speed_turn, speed_speed, kick = decay_of(spring.frequency, spring.damping, dt)
    if driven is not None and speed_before is not None:
        speed -= (driven - speed_before) * kick
    turn, speed = turn_turn * turn + turn_speed * speed, speed_turn * turn + speed_speed * speed
    if -_SMALL_TURN < turn < _SMALL_TURN and -_SMALL_SPEED < speed < _SMALL_SPEED:
        turn = speed = 0.0
    return tuple.__new__(SpringState, (turn, speed, driver, driven, first, second))  # a call takes as long again


def weight_of(spring: Spring, turn: float, speed: float, amount: float) -> float:
    """The weight that a spring plays of its field, within its limit; none where its swing is too small to be seen.

    spring: which; turn: radians; speed: radians a second; amount: 1 as it is. How far it swings, not where it is, says
    what is too small: else it would stop and start again each time that it goes through the middle.
    """
    wanted = amount * spring.gain * turn
    share = wanted / spring.limit
    weight = wanted / math.sqrt(1.0 + share * share)
    sideways = amount * spring.gain * speed / (2.0 * math.pi * spring.frequency)
    swing = weight * weight + sideways * sideways
    return weight * (1.0 - _DEAD * _DEAD / swing) if swing > _DEAD * _DEAD else 0.0
