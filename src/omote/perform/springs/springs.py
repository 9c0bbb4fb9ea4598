"""The springs of a character: how much of each is wanted, how they move, and what they add to a frame."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from omote.model.space.expression import Expression
from omote.perform.channels import channels_of, highest_weight, lowest_weight
from omote.perform.easing import find_easing, is_over
from omote.perform.frame import Frame, Held, with_fields
from omote.perform.layers.follower import follow_number, rate_of
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_within
from omote.perform.panic import PANIC_EASING, PANIC_SECONDS
from omote.perform.springs.cast_springs import SPRINGS, SpringName, check_spring
from omote.perform.springs.spring import FASTEST, Spring, SpringState, advance_spring, weight_of

AMOUNT_LIMIT = 2.0
AMOUNT_SECONDS = 0.5
"""In which a spring that is switched on or off comes or goes."""
_RATE = rate_of(AMOUNT_SECONDS)
_NEAR = 1e-4
_FARTHEST = 1e3
"""Radians, and a hundred times that a second: more than any driver makes of a spring."""


@dataclass(frozen=True)
class Travel:
    """Where a body is that carries a head. x: metres to the picture's right; turn: radians to its own left."""

    x: float = 0.0
    turn: float = 0.0


AT_HOME = Travel()


@dataclass(frozen=True)
class Springs:
    """The springs of a character. amounts: as set, of those that are not 1; moving: those that move or may;
    released: seconds since a panic, None where none has stopped them."""

    amounts: Mapping[SpringName, float] = field(default_factory=dict)
    moving: Mapping[SpringName, SpringState] = field(default_factory=dict)
    released: float | None = None


AT_REST = Springs()


def check_amount(amount: object) -> float:
    """Returns the amount of a spring, 0 to 2; ValueError, TypeError for what is none."""
    return check_within(amount, 0.0, AMOUNT_LIMIT, "the amount of a spring")


def set_amount(springs: Springs, name: object, amount: object) -> Springs:
    """The springs with more or less of one. name: of it; amount: 0 (none) to 2, 1 as it is made."""
    amounts = {**springs.amounts, check_spring(name): check_amount(amount)}
    return replace(springs, amounts={each: amounts[each] for each in SPRINGS if amounts.get(each, 1.0) != 1.0})


def amount_of(springs: Springs | None, name: SpringName) -> float:
    """How much of a spring is set. springs: None where none has moved; name: of it."""
    return 1.0 if springs is None else springs.amounts.get(name, 1.0)


def release_springs(springs: Springs | None) -> Springs | None:
    """The springs on their way to rest, in the time of a panic."""
    if springs is None or not springs.moving or springs.released is not None:
        return springs
    return replace(springs, released=0.0)


def advance_springs(
    springs: Springs, known: Mapping[SpringName, Spring], frame: Frame, travel: Travel, scale: float, dt: float
) -> Springs:
    """The springs `dt` seconds later.

    Parameters
    ----------
    springs : Springs
        As they are.
    known : mapping of Spring
        Those of the cast.
    frame : Frame
        What shows now, without them.
    travel : Travel
        Where the body is now.
    scale : float
        How much of all of them is wanted, beside their amounts.
    dt : float
        Seconds, above 0.

    Returns
    -------
    Springs
        Frozen; the same steps give the same bits.
    """
    released = None if springs.released is None else springs.released + dt
    if released is not None and is_over(released, PANIC_SECONDS):
        return replace(springs, moving={}, released=None)
    moving = dict[SpringName, SpringState]()
    channels = frame.channels
    head = frame.head
    yaw = head.yaw + travel.turn
    for name, spring in known.items():
        goal = scale * springs.amounts.get(name, 1.0)
        state = springs.moving.get(name)
        if state is None:
            state = SpringState()
        if state.first != goal or state.second != goal:
            state = _with_amount(state, goal, dt)
        if not (goal or state.second):
            continue
        by_yaw, by_pitch, by_roll, by_x = spring.turns
        driver = by_yaw * yaw + by_pitch * head.pitch + by_roll * head.roll + by_x * travel.x
        for channel, radians in spring.others:
            driver += radians * channels.get(channel, 0.0)
        moving[name] = advance_spring(spring, state, driver, dt)
    return with_fields(springs, moving=moving, released=released)


def _with_amount(state: SpringState, goal: float, dt: float) -> SpringState:
    """A spring whose amount has followed its goal for `dt` seconds. state: as it is."""
    first, second = follow_number(state.first, state.second, goal, _RATE, dt)
    if abs(first - goal) + abs(second - goal) < _NEAR:
        first = second = goal
    return state._replace(first=first, second=second)


def with_springs(
    frame: Frame,
    springs: Springs,
    known: Mapping[SpringName, Spring],
    expressions: Mapping[str, Expression],
    held: Held,
) -> Frame:
    """A frame with what its springs add to channels.

    frame: what shows without them; springs: as they move; known: those of the cast; expressions: the cast's, by name;
    held: what hands hold, which is no longer what is on air.
    """
    if springs.amounts:
        frame = with_fields(frame, springs=springs.amounts)
    share = 1.0
    if springs.released is not None:
        share -= find_easing(PANIC_EASING).value(springs.released / PANIC_SECONDS)
    added = dict[str, float]()
    for name, state in springs.moving.items():
        spring = known.get(name)
        if spring is not None and (weight := share * weight_of(spring, state.turn, state.speed, state.second)):
            added[spring.channel] = added.get(spring.channel, 0.0) + weight
    if not added:
        return frame
    shown = channels_of(expressions, frame)
    for channel, weight in added.items():
        wanted = shown.get(channel, 0.0) + weight
        if not CHANNEL_LOWEST <= wanted <= CHANNEL_HIGHEST:  # hardly ever
            wanted = min(max(wanted, lowest_weight(expressions, channel)), highest_weight(expressions, channel))
        shown[channel] = wanted
    return with_fields(frame, channels=shown, held=held if frame.held is None else frame.held)


def check_springs(springs: Springs | None) -> Springs | None:
    """Returns springs that were read; ValueError, TypeError where none can be so."""
    if springs is None:
        return None
    for name, amount in springs.amounts.items():
        check_spring(name)
        check_amount(amount)
    for name, state in springs.moving.items():
        check_spring(name)
        check_within(state.turn, -_FARTHEST, _FARTHEST, f"the turn of the spring {name} (radians)")
        check_within(state.speed, -100.0 * _FARTHEST, 100.0 * _FARTHEST, f"the speed of the spring {name}")
        for amount in (state.first, state.second):
            check_within(amount, 0.0, AMOUNT_LIMIT * AMOUNT_LIMIT, f"the amount of the spring {name}")
        if state.driver is not None:
            check_within(state.driver, -_FARTHEST, _FARTHEST, f"the driver of the spring {name} (radians)")
        if state.driver_speed is not None:
            check_within(state.driver_speed, -FASTEST, FASTEST, f"the speed of the driver of the spring {name}")
    if springs.released is not None:
        check_within(springs.released, 0.0, PANIC_SECONDS, "the time since a panic stopped the springs (seconds)")
    return springs
