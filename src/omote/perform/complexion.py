"""Blood, tears and sweat of a character: what its expressions bring, followed as skin follows it, in seconds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Literal, get_args

from omote.model.space.complexion import MOST, PALE, PARTS, REGIONS, WATER, Complexion
from omote.model.space.expression import Expression
from omote.perform.easing import find_easing, is_over
from omote.perform.frame import Frame, with_fields
from omote.perform.layers.follower import REST_SECONDS, follow_number, rate_of
from omote.perform.limits import CHANNEL_HIGHEST, FOREVER, check_known, check_within
from omote.perform.panic import PANIC_EASING, PANIC_SECONDS

SkinFader = Literal["folds", "blood"]
SKIN_FADERS: tuple[SkinFader, ...] = get_args(SkinFader)
"""How much of the skin's folds shows, and of the blood that expressions bring; water has none."""
SKIN_LIMIT = 1.5
FADER_SECONDS = 0.5
"""In which a fader of the skin that is set is followed."""
RISES: Complexion = Complexion(2.5, 2.5, 2.5, 2.5, 2.0, 5.0, 18.0)
FALLS: Complexion = Complexion(6.0, 6.0, 6.0, 8.0, 5.0, 12.0, 45.0)
"""Seconds in which blood goes nine tenths of its way into the skin, or out of it, and tears and sweat well up and dry.
A blush is at its height after some 15 s in people (Drummond 1997); a stage has less time."""
_RATES = tuple(zip(map(rate_of, RISES), map(rate_of, FALLS), strict=True))
_FADER_RATE = rate_of(FADER_SECONDS)
DROP_SPEEDS = (0.009, 0.004)
"""Metres a second that drops of tears and of sweat run where there are as many as there can be."""
_NEAR = 1e-4
_LONGEST_GAP = 150.0
"""Seconds after which all is where it goes."""
RANGES = tuple((0.0, 1.0) if part in WATER else (-0.8, 1.4) for part in PARTS)
"""What the sum of all that shows is held in, by part: skin has no more blood and no less, and water covers it."""


@dataclass(frozen=True)
class Skin:
    """The skin of a character. faders: as set, of those that are not 1; first, second: the complexion after the first
    and after both filters that follow it; folds: the fader, followed alike; drops: the metres that water has run since
    it began; left: what a panic found, which is on its way out; released: seconds since, None where none did."""

    faders: Mapping[SkinFader, float] = field(default_factory=dict)
    first: Complexion = PALE
    second: Complexion = PALE
    folds: tuple[float, float] = (1.0, 1.0)
    drops: float = 0.0
    left: Complexion = PALE
    released: float | None = None


AS_IT_IS = Skin()
_NO_FADERS: Mapping[SkinFader, float] = MappingProxyType({})


def check_skin_fader(name: object) -> SkinFader:
    """The fader of the skin of this name; ValueError with those that there are where there is none."""
    return check_known(name, SKIN_FADERS, "fader of the skin")


def set_skin(skin: Skin | None, name: object, amount: object) -> Skin:
    """The skin with more or less of what a fader is for. skin: None as it is at first; name: of the fader; amount: 0
    (none) to 1.5, 1 at first."""
    before = AS_IT_IS if skin is None else skin
    value = check_within(amount, 0.0, SKIN_LIMIT, "the amount of a fader of the skin")
    amounts = {**before.faders, check_skin_fader(name): value}
    return replace(before, faders={each: amounts[each] for each in SKIN_FADERS if amounts.get(each, 1.0) != 1.0})


def fader_at(skin: Skin | None, name: SkinFader) -> float:
    """Where a fader of the skin stands. skin: None as it is at first; name: of the fader."""
    return 1.0 if skin is None else skin.faders.get(name, 1.0)


def calm_skin(skin: Skin | None) -> Skin | None:
    """The skin from a panic on: what shows of blood and water is gone in its time. skin: None as it is at first."""
    if skin is None:
        return None
    return replace(skin, first=PALE, second=PALE, left=_shown(skin), released=0.0)


def _shown(skin: Skin) -> Complexion:
    """The complexion as it shows."""
    if skin.released is None:
        return skin.second
    share = 1.0 - find_easing(PANIC_EASING).value(skin.released / PANIC_SECONDS)
    return _add(skin.second, skin.left, share)


def complexion_of(expressions: Mapping[str, Expression], frame: Frame) -> Complexion:
    """What the expressions on air bring of blood and water, by their weights; channels are expressions too.

    expressions: those of the cast, by name; frame: its mixes and channels.
    """
    worn = _brought(expressions, frame.expressions)
    if frame.regions:
        by_region = {region: _brought(expressions, mix) for region, mix in frame.regions.items()}
        where = (None if region is None else by_region.get(region) for region in (REGIONS[part] for part in PARTS))
        worn = Complexion(*((own or worn)[at] for at, own in enumerate(where)))
    return _held(_add(worn, _brought(expressions, frame.channels)))


def _brought(expressions: Mapping[str, Expression], weights: Mapping[str, float]) -> Complexion:
    total = PALE
    for name, weight in weights.items():
        expression = expressions.get(name)
        if expression is not None and expression.complexion is not PALE:
            total = _add(total, expression.complexion, weight)
    return total


def _add(one: Complexion, other: Complexion, weight: float = 1.0) -> Complexion:
    if other is PALE:
        return one
    a, b, c, d, e, f, g = one
    t, u, v, w, x, y, z = other
    return Complexion(
        a + weight * t, b + weight * u, c + weight * v, d + weight * w, e + weight * x, f + weight * y, g + weight * z
    )  # fmt: skip


def _held(sum_of_all: Complexion) -> Complexion:
    """A complexion within what skin can do."""
    if sum_of_all is PALE:
        return PALE
    return Complexion(*[min(max(value, low), high) for value, (low, high) in zip(sum_of_all, RANGES, strict=True)])


def advance_skin(skin: Skin, goal: Complexion, dt: float) -> Skin:
    """The skin `dt` seconds later.

    Blood comes faster than it goes, and so does water: each number goes by its own two times, by whether its goal is
    farther from rest than it is. The same steps give the same bits.

    skin: as it is; goal: what the expressions bring; dt: seconds, above 0.
    """
    if skin.released is not None:
        return _calmed(skin, skin.released + dt)
    blood = skin.faders.get("blood", 1.0)
    goals = tuple(value if part in WATER else blood * value for part, value in zip(PARTS, goal, strict=True))
    wanted = skin.faders.get("folds", 1.0)
    if skin.second == goals and skin.first == goals and skin.folds == (wanted, wanted):
        return with_fields(skin, drops=_run(skin, skin.second, dt)) if any(_water_of(goal)) else skin
    if dt >= _LONGEST_GAP:
        there = Complexion(*goals)
        return with_fields(skin, first=there, second=there, folds=(wanted, wanted), drops=_run(skin, there, dt))
    firsts = list[float]()
    seconds = list[float]()
    for value, first, second, (rises, falls) in zip(goals, skin.first, skin.second, _RATES, strict=True):
        near, nearer = _followed(first, second, value, rises if abs(value) >= abs(second) else falls, dt)
        firsts.append(near)
        seconds.append(nearer)
    folds = _followed(*skin.folds, wanted, _FADER_RATE, dt)
    later = Complexion(*seconds)
    return with_fields(skin, first=Complexion(*firsts), second=later, folds=folds, drops=_run(skin, later, dt))


def _calmed(skin: Skin, released: float) -> Skin:
    """The skin so many seconds after a panic: what comes on air meanwhile brings nothing yet."""
    folds = skin.faders.get("folds", 1.0)
    if is_over(released, PANIC_SECONDS):
        return with_fields(skin, left=PALE, released=None, folds=(folds, folds), drops=0.0)
    return with_fields(skin, released=released)


def _run(skin: Skin, shown: Complexion, dt: float) -> float:
    """How far water has run, metres: each drop begins where it wells up, so that those of dry skin are forgotten."""
    speed = max(amount * most for amount, most in zip(_water_of(shown), DROP_SPEEDS, strict=True))
    return skin.drops + speed * dt if speed else 0.0


def _water_of(complexion: Complexion) -> tuple[float, float]:
    return complexion.tears, complexion.sweat


def _followed(first: float, second: float, goal: float, rate: float, dt: float) -> tuple[float, float]:
    left = dt
    while left > 0.0 and (first != goal or second != goal):
        step = min(left, REST_SECONDS)
        first, second = follow_number(first, second, goal, rate, step)
        if abs(first - goal) + abs(second - goal) < _NEAR:
            return goal, goal
        left -= step
    return first, second


def is_at_rest(skin: Skin) -> bool:
    """Whether nothing is set of a skin and nothing shows."""
    still = skin.released is None and skin.folds == (1.0, 1.0)
    return still and not (skin.faders or any(skin.first) or any(skin.second))


def with_skin(frame: Frame, skin: Skin) -> Frame:
    """A frame with what shows of blood, water and folds. frame: all else; skin: as it is now."""
    return with_fields(
        frame, complexion=_shown(skin), drops=skin.drops, folds=skin.folds[1], skin=skin.faders or _NO_FADERS
    )


def check_skin(skin: Skin | None) -> Skin | None:
    """Returns a skin that was read; ValueError, TypeError where none can be so."""
    if skin is None:
        return None
    for name, amount in skin.faders.items():
        check_skin_fader(name)
        check_within(amount, 0.0, SKIN_LIMIT, "the amount of a fader of the skin")
    most = SKIN_LIMIT * MOST * CHANNEL_HIGHEST
    for values in (skin.first, skin.second, skin.left):
        for part, value in zip(PARTS, values, strict=True):
            check_within(value, -most, most, f"{part} of a complexion")
    if skin.released is not None:
        check_within(skin.released, 0.0, PANIC_SECONDS, "the time since a panic calmed the skin (seconds)")
    check_within(skin.drops, 0.0, FOREVER, "how far tears and sweat have run (metres)")
    for amount in skin.folds:
        check_within(amount, 0.0, SKIN_LIMIT, "the amount of a fader of the skin")
    return skin
