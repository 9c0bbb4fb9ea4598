"""Macros as they are kept: where hands have them, whether their conditions hold, and what their targets give; and what
becomes of that when mappings change. They play as vectors (`macro_vectors.py`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from omote.perform.frame import with_fields
from omote.perform.limits import check_known, check_within
from omote.perform.mappings.kept_mappings import ByName, renaming_in
from omote.perform.mappings.mapping import (
    MACRO_LIMITS,
    PAD,
    MacroMapping,
    MacroTarget,
    range_of,
)

Pair = tuple[float, float]
"""What the first and the second of two filters in a row give."""
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
