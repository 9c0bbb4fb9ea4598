"""Numbers that move together: where they are, and the way to where they were sent.

A movement is a value; every function here returns a changed copy. A way goes along
start + (goal - start) y + velocity decay bump, as a call does (docs/method.md, "Interrupted calls"), so that a new one
begins where the old one is, at its speed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from omote.perform.easing import DECAY_SECONDS, DEFAULT_EASING, bump, bump_rate, decay_seconds, find_easing, is_over
from omote.perform.limits import FOREVER, LONGEST_CALL, SHORTEST_CALL, check_within
from omote.perform.mix import HIGHEST, LOWEST

Numbers = Mapping[str, float]
Ranges = Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class Way:
    """The way of some numbers from `start`, where they moved at `velocity` per second; `elapsed` of `seconds`. pace,
    since: as of `axis.Call`."""

    start: Numbers
    velocity: Numbers
    decay: float
    seconds: float
    elapsed: float = 0.0
    easing: str = DEFAULT_EASING
    pace: float | None = None
    since: float | None = None


@dataclass(frozen=True)
class Movement:
    """Numbers by name: at `goal`, or on their way there."""

    goal: Numbers
    way: Way | None = None


def values(movement: Movement, ranges: Ranges) -> dict[str, float]:
    """The numbers as they are now; each in its range.

    movement: the way to a goal; ranges: lowest and highest of each number.
    """
    way = movement.way
    if way is None:
        return dict(movement.goal)
    y = find_easing(way.easing).value(min(1.0, way.elapsed / way.seconds))
    carried = way.decay * bump(_since(way) / way.decay) if way.decay else 0.0
    at = {}
    for name, goal in movement.goal.items():
        low, high = ranges[name]
        value = way.start[name] + (goal - way.start[name]) * y + way.velocity[name] * carried
        at[name] = min(high, max(low, value))  # the decay is planned at some instants: between, a hair may be over
    return at


def rates(movement: Movement) -> dict[str, float]:
    """The change of the numbers per second."""
    way = movement.way
    if way is None:
        return dict.fromkeys(movement.goal, 0.0)
    rate = find_easing(way.easing).rate(min(1.0, way.elapsed / way.seconds)) / way.seconds
    carried = bump_rate(_since(way) / way.decay) if way.decay else 0.0
    rate *= 1.0 if way.pace is None else way.pace
    return {n: (goal - way.start[n]) * rate + way.velocity[n] * carried for n, goal in movement.goal.items()}


def redirect(
    movement: Movement, goal: Numbers, seconds: float, ranges: Ranges, easing: str = DEFAULT_EASING
) -> Movement:
    """The movement to `goal` in `seconds` from wherever it is, at its speed; 0 seconds cut.

    ranges: lowest and highest of each number; easing: the curve of the way.
    """
    if seconds == 0.0:
        return Movement(goal)
    start = values(movement, ranges)
    velocity = rates(movement)
    if start == goal and not any(velocity.values()):
        return Movement(goal)
    way = Way(start, velocity, 0.0, seconds, easing=easing)
    return Movement(goal, replace(way, decay=_decay(way, goal, ranges)))


def with_pace(movement: Movement, pace: float | None) -> Movement:
    """The movement with its way at a pace, as `axis.with_pace`."""
    way = movement.way
    return movement if way is None else Movement(movement.goal, replace(way, pace=pace, since=_since(way)))


def repaced(movement: Movement, pace: float) -> Movement:
    """The movement with its way at another pace, where it has one."""
    return movement if movement.way is None or movement.way.pace is None else with_pace(movement, pace)


def proceed(movement: Movement, dt: float) -> Movement:
    """The movement `dt` seconds later; at its goal once its time is over."""
    if movement.way is None:
        return movement
    pace = 1.0 if movement.way.pace is None else movement.way.pace
    since = None if movement.way.since is None else movement.way.since + dt
    way = replace(movement.way, elapsed=movement.way.elapsed + dt * pace, since=since)
    return Movement(movement.goal, None if is_over(way.elapsed, way.seconds) else way)


def check_movement(movement: Movement, ranges: Ranges, what: str) -> None:
    """Rejects a movement that was read and that none can be: ValueError that names the number.

    ranges: lowest and highest of each number; what: what messages call it.
    """
    _check_numbers(movement.goal, ranges, what)
    if movement.way is None:
        return
    way = movement.way
    _check_numbers(way.start, ranges, what)
    _check_numbers(way.velocity, dict.fromkeys(ranges, (-FOREVER, FOREVER)), f"the speed of {what}:")
    check_within(way.seconds, SHORTEST_CALL, LONGEST_CALL, f"{what}: the time of its way (seconds)")
    check_within(way.decay, 0.0, DECAY_SECONDS, f"{what}: the decay of its speed (seconds)")
    check_within(way.elapsed, 0.0, way.seconds, f"{what}: the elapsed time of its way (seconds)")
    find_easing(way.easing)
    check_within(_since(way), 0.0, FOREVER, f"{what}: the time of its speed (seconds)")
    if way.pace is not None:
        check_within(way.pace, 0.0, 1.0, f"{what}: the pace of its way")


def _check_numbers(numbers: Numbers, ranges: Ranges, what: str) -> None:
    if numbers.keys() != ranges.keys():
        raise ValueError(f"{what} has {', '.join(numbers) or 'no numbers'}; it must have {', '.join(ranges)}")
    for name, (low, high) in ranges.items():
        check_within(numbers[name], low, high, f"{what} {name}")


def _since(way: Way) -> float:
    return way.elapsed if way.since is None else way.since


def _decay(way: Way, goal: Numbers, ranges: Ranges) -> float:
    """The time in which the speed dies out, so that no number leaves its range: each is seen as a weight of a mix."""
    scale = {name: (HIGHEST - LOWEST) / (high - low) for name, (low, high) in ranges.items()}
    return decay_seconds(
        {name: LOWEST + (value - ranges[name][0]) * scale[name] for name, value in way.start.items()},
        {name: rate * scale[name] for name, rate in way.velocity.items()},
        {name: LOWEST + (value - ranges[name][0]) * scale[name] for name, value in goal.items()},
        way.seconds,
        find_easing(way.easing),
    )
