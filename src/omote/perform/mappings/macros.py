"""Macros as they are now: where hands have them, whether their conditions hold, and what their targets give.

What a macro gives a target is its curve first and the follower after it: a follower before the curve would spread the
smoothing of a steep piece over the flat ones, and one value cannot rise and fall at speeds of its own at each target.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from omote.perform.frame import MacroStatus, with_fields
from omote.perform.layers.follower import LONGEST_STEP, NEAR, steps_of
from omote.perform.limits import check_known, check_within
from omote.perform.mappings.kept_mappings import ByName, renaming_in
from omote.perform.mappings.mapping import (
    CHANNEL,
    MACRO_LIMITS,
    PAD,
    MacroCondition,
    MacroMapping,
    MacroTarget,
    range_of,
    rate_or_none,
)
from omote.perform.mappings.monotone_curve import value_of

GATE_SECONDS = 0.2
"""In which a macro whose condition opens or shuts has gone nine tenths of the way."""
Pair = tuple[float, float]
"""What the first and the second of two filters in a row give."""
OPEN: Pair = (1.0, 1.0)
SHUT: Pair = (0.0, 0.0)
ROUNDING = 1e-9
"""How far a curve between two ends may be beyond them."""


@dataclass(frozen=True)
class MacroState:
    """A macro that a hand has moved since the last panic. value: where, -1 to 1; open: whether its condition holds;
    gate: how much of it shows, as both filters give it; given: what each target gives, in its order."""

    value: float
    open: bool
    gate: tuple[float, float]
    given: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Macros:
    """The macros of a character that were moved, by name, and what mappings that have changed since gave, on its way
    out, by macro and target."""

    moved: Mapping[str, MacroState] = field(default_factory=dict)
    fading: Mapping[str, Mapping[str, tuple[float, float]]] = field(default_factory=dict)


NO_MACROS = Macros()
NOTHING_FADES: Mapping[str, Pair] = {}
Read = Callable[[MacroCondition], float]


def move_macro(macros: Macros, mapping: MacroMapping, value: float, read: Read) -> Macros:
    """The macros with one of them moved by a hand.

    mapping: of it; value: -1 to 1; read: what a condition reads now.
    """
    if not (type(value) is float and -1.0 <= value <= 1.0):  # nearly never, and names take as long as all else
        value = check_within(value, *MACRO_LIMITS, f"the macro {mapping.name}")
    before = macros.moved.get(mapping.name)
    if before is not None:
        state = with_fields(before, value=value)
    else:
        opens = mapping.when is None or mapping.when.opens(read(mapping.when), was_open=False)
        gate = OPEN if opens and mapping.is_nothing_at_rest else SHUT
        state = MacroState(value, opens, gate, tuple((target.low, target.low) for target in mapping.targets))
    return with_fields(macros, moved={**macros.moved, mapping.name: state})


def advance_macros(macros: Macros, mappings: ByName, read: Read, dt: float) -> Macros:
    """The macros `dt` seconds later; the same object where nothing has moved.

    mappings: of the character; read: what a condition reads now.
    """
    moved = dict[str, MacroState]()
    still = True
    for name, state in macros.moved.items():
        later = _advanced(state, mappings[name], read, dt)
        moved[name] = later
        still = still and later is state
    fading = _faded(macros.fading, dt) if macros.fading else macros.fading
    return macros if still and fading is macros.fading else Macros(moved, fading)


def is_a_condition_new(macros: Macros, mappings: ByName, read: Read) -> bool:
    """Whether a condition of a macro that was moved opens or shuts now.

    macros: those of the character; mappings: what they play; read: what a condition reads now.
    """
    for name, state in macros.moved.items():
        when = mappings[name].when
        if when is not None and when.opens(read(when), was_open=state.open) is not state.open:
            return True
    return False


def _advanced(state: MacroState, mapping: MacroMapping, read: Read, dt: float) -> MacroState:
    opens = True if mapping.when is None else mapping.when.opens(read(mapping.when), was_open=state.open)
    goal = 1.0 if opens else 0.0
    gate = state.gate
    if gate[1] != goal or gate[0] != goal:
        gate = follow_pair(gate, goal, GATE_SECONDS, GATE_SECONDS, dt)
    value = state.value
    at = abs(value)
    moves = opens is not state.open or gate is not state.gate
    given = []
    follow = _stepped if 0.0 < dt <= LONGEST_STEP else _followed  # nearly always one step
    for (low, span, pieces, rise, fall), pair in zip(mapping.halves[value < 0.0], state.given, strict=True):
        wanted = low if span is None else low + span * value_of(pieces, at)
        if pair[1] != wanted or pair[0] != wanted:
            moves = True
            pair = follow(pair, wanted, rise, fall, dt)
        given.append(pair)
    return with_fields(state, open=opens, gate=gate, given=tuple(given)) if moves else state


def _faded(fading: Mapping[str, Mapping[str, Pair]], dt: float) -> dict[str, dict[str, Pair]]:
    later = {
        name: {
            to: pair
            for to, before in pairs.items()
            if (pair := follow_pair(before, 0.0, GATE_SECONDS, GATE_SECONDS, dt)) != SHUT
        }
        for name, pairs in fading.items()
    }
    return {name: pairs for name, pairs in later.items() if pairs}


def follow_pair(pair: Pair, goal: float, rise: float, fall: float, dt: float) -> Pair:
    """Two filters in a row `dt` seconds later, between what they were and the goal: each has the time of a rise or of
    a fall by where it goes itself, so that it changes while it stands, without a kink.

    pair: what they give; goal: where they go; rise, fall: seconds for nine tenths of a step, 0 at once; dt: seconds.
    """
    return _followed(pair, goal, rate_or_none(rise), rate_or_none(fall), dt)


def _followed(pair: Pair, goal: float, rise: float, fall: float, dt: float) -> Pair:
    """The same by the rates of a rise and of a fall, 1/s; 0 at once."""
    for step in (dt,) if 0.0 < dt <= LONGEST_STEP else _steps(dt):
        pair = _stepped(pair, goal, rise, fall, step)
    return pair


def _steps(dt: float) -> Iterator[float]:
    """At no time at all, what follows at once does."""
    return iter((0.0,)) if dt == 0.0 else steps_of(dt)


def _stepped(pair: Pair, goal: float, rise: float, fall: float, dt: float) -> Pair:
    """One step: of the first filter what is left of its distance, of the second what both leave of it; what is near
    its goal is there."""
    first, second = pair
    ahead = first - goal
    lead = rise if goal > first else fall
    if lead:
        z = lead * dt
        share = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))
        before = first
    else:
        z = share = 0.0
        before = goal
    behind = rise if (before if before != second else goal) > second else fall
    first = goal + ahead * share
    if behind:
        y = behind * dt
        left = 1.0 / (1.0 + y * (1.0 + y * (0.48 + y * 0.235)))
        second = goal + (second - goal) * left
        if share:
            chord = 1.0 + 0.48 * (z + y) + 0.235 * (z * z + z * y + y * y)
            second += ahead * y * chord * share * left
    else:
        second = first
    return (goal, goal) if abs(first - goal) + abs(second - goal) < NEAR else (first, second)


def given_by(macros: Macros, mappings: ByName) -> dict[str, list[float]]:
    """What macros give now, each source of a target by itself, in the unit of the target.

    mappings: of the character.
    """
    sources = dict[str, list[float]]()
    fading = macros.fading
    for name, state in macros.moved.items():
        share = state.gate[1]
        leaving = fading.get(name, NOTHING_FADES)
        for to, pair in zip(mappings[name].reached, state.given, strict=True):
            value = pair[1] * share
            if to in leaving:
                value += leaving[to][1]
            if value:
                sources.setdefault(to, []).append(value)
    for name, leaving in fading.items():
        own = mappings[name].reached if name in macros.moved else ()
        for to, pair in leaving.items():
            if to not in own:
                sources.setdefault(to, []).append(pair[1])
    return sources


def channels_given(macros: Macros, mappings: ByName) -> frozenset[str]:
    """The channels to which macros give something now. mappings: of the character."""
    reached = (to.partition("/") for to in given_by(macros, mappings))
    return frozenset(name for kind, _, name in reached if kind == CHANNEL)


UNMOVED = MacroStatus(0.0, 0.0)
NO_STATUSES: Mapping[str, MacroStatus] = {}


def macro_statuses(mappings: ByName, macros: Macros) -> dict[str, MacroStatus]:
    """All macros of a character as they are now. mappings: of it."""
    moved = macros.moved
    return {
        name: MacroStatus(moved[name].value, moved[name].gate[1]) if name in moved else UNMOVED for name in mappings
    }


def follow_change(macros: Macros, before: ByName, after: ByName) -> Macros:
    """The macros after their mappings have changed: what shows goes on from where it is, and what a mapping gave that
    it no longer gives fades out. before, after: of the character."""
    if before == after:
        return macros
    renaming = renaming_in(before, after)
    if renaming is not None:
        old, new = renaming
        moved = {(new if name == old else name): state for name, state in macros.moved.items()}
        return Macros(moved, {(new if name == old else name): pairs for name, pairs in macros.fading.items()})
    moved = dict[str, MacroState]()
    fading = {name: dict(pairs) for name, pairs in macros.fading.items()}
    for name, state in macros.moved.items():
        mapping = after.get(name)
        later = state if mapping == before[name] else None if mapping is None else _again(state, mapping)
        if later is not None:
            moved[name] = later
        if later is not state:
            fading[name] = _difference(state, before[name], later, mapping, fading.get(name, {}))
    return Macros(moved, {name: pairs for name, pairs in fading.items() if pairs})


def _again(state: MacroState, mapping: MacroMapping) -> MacroState:
    """A macro under another mapping: all of it is where it goes."""
    return with_fields(state, given=tuple((at, at) for at in (each.value_at(state.value) for each in mapping.targets)))


def _difference(
    state: MacroState,
    before: MacroMapping,
    later: MacroState | None,
    after: MacroMapping | None,
    fading: Mapping[str, Pair],
) -> dict[str, Pair]:
    """What a mapping gave beyond what it gives from now on, with what was fading of it already; the points of pads stay
    where they are."""
    share = state.gate[1]
    gone = {to: pair[1] for to, pair in fading.items()}
    for target, pair in zip(before.targets, state.given, strict=True):
        gone[target.to] = gone.get(target.to, 0.0) + pair[1] * share
    if later is not None and after is not None:
        for target, pair in zip(after.targets, later.given, strict=True):
            gone[target.to] = gone.get(target.to, 0.0) - pair[1] * share
    return {to: (value, value) for to, value in gone.items() if value and not to.startswith(f"{PAD}/")}


def check_macros(macros: Macros, mappings: ByName) -> None:
    """Rejects macros that no character has moved. mappings: of the character."""
    for name, state in macros.moved.items():
        mapping = mappings[check_known(name, mappings, "macro")]
        check_within(state.value, *MACRO_LIMITS, f"the macro {name}")
        if len(state.given) != len(mapping.targets):
            raise ValueError(f"the macro {name} gives {len(state.given)} values; expected {len(mapping.targets)}")
        for gate in state.gate:
            check_within(gate, 0.0, 1.0, f"how much shows of the macro {name}")
        for target, pair in zip(mapping.targets, state.given, strict=True):
            _check_pair(pair, target)
    for pairs in macros.fading.values():
        for to, pair in pairs.items():
            low, high = range_of(to)
            for number in pair:
                check_within(number, low - high, high - low, f"what fades out of {to}")


def _check_pair(pair: Pair, target: MacroTarget) -> None:
    low, high = range_of(target.to)
    for number in pair:
        check_within(number, low - ROUNDING, high + ROUNDING, f"what a macro gives {target.to}")
