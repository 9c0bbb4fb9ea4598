"""The macros of a character while they play: one number a target in vectors, for one kernel to go through them all.

What a macro gives a target is its curve first and the follower after it: a follower before the curve would spread the
smoothing of a steep piece over the flat ones, and one value cannot rise and fall at speeds of its own at each target.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.perform.frame import MacroStatus, with_fields
from omote.perform.layers.follower import LONGEST_STEP, rate_of, steps_of
from omote.perform.limits import CHANNEL_LOWEST, check_within
from omote.perform.mappings.kept_mappings import ByName
from omote.perform.mappings.macros import NO_MACROS, Macros, MacroState, Pair
from omote.perform.mappings.mapping import ANGLES, CHANNEL, MACRO_LIMITS, PAD, MacroCondition, TargetKind, TargetRows
from omote.perform.pads.blend_space import PLACE_RANGE

GATE_SECONDS = 0.2
"""In which a macro whose condition opens or shuts has gone nine tenths of the way."""
GATE_RATE = rate_of(GATE_SECONDS)
FULL_CHANNEL = (CHANNEL_LOWEST, 1.0)
"""Where the sum of sources of a channel ends; one alone may go beyond, as a fader does."""
UNMOVED = MacroStatus(0.0, 0.0)
NO_STATUSES: Mapping[str, MacroStatus] = {}
Read = Callable[[MacroCondition], float]
Target = tuple[TargetKind, str]


@dataclass(frozen=True, eq=False)
class MacroTable:
    """All that follows from the mappings of a character alone. names: of its macros; begins (n + 1,): where the targets
    of each begin among all (m,); sources: the macro and the target of each, then those of what fades of mappings that
    have gone; targets: that any source has, channels first, by name, and channels those; beside_pads (m + e,): which
    sources play no pad; limits (t, 2): of each target. All else: as of the kernels."""

    mappings: ByName
    names: Mapping[str, int]
    begins: list[int]
    sources: tuple[tuple[str, str], ...]
    targets: tuple[Target, ...]
    channels: tuple[str, ...]
    owners: NDArray[np.int64]
    lows: Values
    spans: Values
    runs: NDArray[np.int64]
    pieces: Values
    rates: Values
    order: NDArray[np.int64]
    target_begins: NDArray[np.int64]
    limits: Values
    beside_pads: NDArray[np.bool_]
    conditions: tuple[tuple[int, MacroCondition], ...]
    plays_pads: bool


@dataclass(frozen=True, eq=False)
class MacroVectors:
    """The macros of a character as they are now; the vectors are never changed. values, moved, opens (n,): where each
    is, whether a hand has moved it since the last panic, and 1 where it was and its condition holds; gates (n, 2): how
    much of it shows, as both filters give it; given (m, 2): what each target gives; fading (m + e, 2): what mappings
    that have changed since gave each target on its way out, empty where nothing fades."""

    table: MacroTable
    values: Values
    moved: NDArray[np.bool_]
    opens: Values
    gates: Values
    given: Values
    fading: Values

    def value_of(self, name: str) -> float:
        """Where a macro is; 0 where there is none of the name."""
        place = self.table.names.get(name)
        return 0.0 if place is None else float(self.values[place])

    @property
    def moved_to(self) -> dict[str, float]:
        """Where those are that a hand has moved."""
        return {name: float(self.values[place]) for name, place in self.table.names.items() if self.moved[place]}


NOTHING_FADES: Values = np.empty((0, 2))
NO_ROWS = TargetRows(np.empty(0), np.empty((0, 2)), np.empty((0, 4), np.int64), np.empty((0, 9)), np.empty((0, 2)))


def vectors_of(macros: Macros, mappings: ByName) -> MacroVectors | None:
    """The macros as vectors; None where none was moved and nothing fades. mappings: of the character."""
    if not macros.moved and not macros.fading:
        return None
    vectors = _unmoved(mappings, [(name, to) for name, pairs in macros.fading.items() for to in pairs])
    table = vectors.table
    for name, state in macros.moved.items():
        place = table.names[name]
        vectors.values[place] = state.value
        vectors.moved[place] = True
        vectors.opens[place] = state.open
        vectors.gates[place] = state.gate
        vectors.given[table.begins[place] : table.begins[place + 1]] = state.given
    if not macros.fading:
        return vectors
    fading = np.zeros((len(table.sources), 2))
    for place, (name, to) in enumerate(table.sources):
        fading[place] = macros.fading.get(name, {}).get(to, (0.0, 0.0))
    return with_fields(vectors, fading=fading)


def states_of(vectors: MacroVectors | None) -> Macros:
    """The macros as they are kept (`vectors_of`)."""
    if vectors is None:
        return NO_MACROS
    table = vectors.table
    pairs = _pairs(vectors.given)
    numbers = zip(vectors.moved.tolist(), vectors.values.tolist(), vectors.opens.tolist(), strict=True)
    moved = {
        name: MacroState(value, opens > 0.0, gate, tuple(pairs[begin:end]))
        for name, (is_moved, value, opens), gate, (begin, end) in zip(
            table.names, numbers, _pairs(vectors.gates), pairwise(table.begins), strict=True
        )
        if is_moved
    }
    fading = dict[str, dict[str, Pair]]()
    for (name, to), pair in zip(table.sources, _pairs(vectors.fading), strict=False):
        if pair != (0.0, 0.0):
            fading.setdefault(name, {})[to] = pair
    return Macros(moved, fading)


def move_macro(vectors: MacroVectors | None, mappings: ByName, name: str, value: float, read: Read) -> MacroVectors:
    """The macros with one of them moved by a hand.

    vectors: those of the character, None where none has moved; mappings: of it; name: of the macro; value: -1 to 1;
    read: what a condition reads now.
    """
    if not (type(value) is float and -1.0 <= value <= 1.0):  # nearly never, and names take as long as all else
        value = check_within(value, *MACRO_LIMITS, f"the macro {name}")
    if vectors is None:
        vectors = _unmoved(mappings, ())
    place = vectors.table.names[name]
    values = vectors.values.copy()
    values[place] = value
    if vectors.moved[place]:
        return with_fields(vectors, values=values)
    mapping = mappings[name]
    opens = mapping.when is None or mapping.when.opens(read(mapping.when), was_open=False)
    later = with_fields(
        vectors, values=values, moved=vectors.moved.copy(), opens=vectors.opens.copy(), gates=vectors.gates.copy()
    )
    later.moved[place] = True
    later.opens[place] = opens
    later.gates[place] = float(opens and mapping.is_nothing_at_rest)
    return later


def advance_macros(vectors: MacroVectors, read: Read, dt: float) -> MacroVectors:
    """The macros `dt` seconds later; the same object where nothing has moved.

    vectors: those of the character; read: what a condition reads now.
    """
    table = vectors.table
    step, count = (dt, 1) if 0.0 < dt <= LONGEST_STEP else _steps(dt)  # nearly always one
    opens = _opened(vectors, read)
    gates = np.empty_like(vectors.gates)
    given = np.empty_like(vectors.given)
    kernels = _kernels()
    moves = opens is not vectors.opens
    moves |= kernels.follow_pairs(vectors.gates, opens, _gate_rates(len(gates)), step, count, gates)
    moves |= kernels.follow_targets(
        vectors.values, vectors.moved, vectors.given, table.owners, table.lows, table.spans, table.runs, table.pieces,
        table.rates, step, count, given,
    )  # fmt: skip
    fading = vectors.fading
    if len(fading):
        fading = np.empty_like(vectors.fading)
        rates = _gate_rates(len(fading))
        moves |= kernels.follow_pairs(vectors.fading, np.zeros(len(fading)), rates, step, count, fading)
    return with_fields(vectors, opens=opens, gates=gates, given=given, fading=fading) if moves else vectors


def is_a_condition_new(vectors: MacroVectors, read: Read) -> bool:
    """Whether a condition of a macro that was moved opens or shuts now.

    vectors: those of the character; read: what a condition reads now.
    """
    return _opened(vectors, read) is not vectors.opens


def _opened(vectors: MacroVectors, read: Read) -> Values:
    """Whether each macro plays now; the same object where none has opened or shut. read: what a condition reads now."""
    opens = vectors.opens
    for place, when in vectors.table.conditions:
        was_open = bool(vectors.opens[place])
        if vectors.moved[place] and when.opens(read(when), was_open=was_open) is not was_open:
            opens = opens.copy() if opens is vectors.opens else opens
            opens[place] = not was_open
    return opens


def given_by(vectors: MacroVectors) -> Values:
    """What each source gives now, in the unit of its target."""
    values: Values = vectors.given[:, 1] * vectors.gates[vectors.table.owners, 1]
    if len(vectors.fading):
        values = np.concatenate([values, np.zeros(len(vectors.fading) - len(values))]) + vectors.fading[:, 1]
    return values


def sum_by_target(table: MacroTable, values: Values, own: Sequence[float]) -> list[float]:
    """What each target has of all its sources, softly limited.

    table: of the character; values: of `given_by`; own: what faders hold of each target.
    """
    held = np.array(own)
    sums = np.empty(len(table.targets))
    _kernels().sum_sources(values, held, table.order, table.target_begins, table.limits, sums)
    numbers: list[float] = sums.tolist()
    return numbers


def channels_given(macros: Macros, mappings: ByName) -> frozenset[str]:
    """The channels to which macros give something now. mappings: of the character."""
    vectors = vectors_of(macros, mappings)
    if vectors is None:
        return frozenset()
    reached = (
        to.partition("/") for (_, to), value in zip(vectors.table.sources, given_by(vectors), strict=True) if value
    )
    return frozenset(name for kind, _, name in reached if kind == CHANNEL)


def macro_statuses(mappings: ByName, vectors: MacroVectors | None) -> Mapping[str, MacroStatus]:
    """All macros of a character as they are now. mappings: of it; vectors: its macros, None where none has moved."""
    if vectors is None:
        return dict.fromkeys(mappings, UNMOVED) if mappings else NO_STATUSES
    numbers = zip(vectors.values.tolist(), vectors.gates[:, 1].tolist(), strict=True)
    return dict(zip(mappings, map(MacroStatus._make, numbers), strict=True))


def _unmoved(mappings: ByName, fading: Iterable[tuple[str, str]]) -> MacroVectors:
    table = make_table(mappings, fading)
    count = len(table.names)
    given = np.repeat(table.lows, 2).reshape(-1, 2)
    return MacroVectors(
        table, np.zeros(count), np.zeros(count, bool), np.zeros(count), np.zeros((count, 2)), given, NOTHING_FADES
    )


def make_table(mappings: ByName, fading: Iterable[tuple[str, str]]) -> MacroTable:
    """What follows from the mappings of a character. fading: macros and targets of what fades, also of others."""
    sources = dict.fromkeys([*((name, each.to) for name, own in mappings.items() for each in own.targets), *fading])
    places = {name: place for place, name in enumerate(mappings)}
    counts = [len(mapping.targets) for mapping in mappings.values()]
    lows, spans, runs, pieces, rates = (
        np.concatenate(rows) for rows in zip(NO_ROWS, *(mapping.rows for mapping in mappings.values()), strict=True)
    )
    before = np.cumsum([0, *(len(mapping.rows.pieces) for mapping in mappings.values())])[:-1]
    kinds = [_target_of(to) for _, to in sources]
    targets = tuple(sorted(dict.fromkeys(kinds), key=lambda target: (target[0] != CHANNEL, target)))
    slot_of = {target: slot for slot, target in enumerate(targets)}
    slots = np.array([slot_of[kind] for kind in kinds], np.int64)
    return MacroTable(
        mappings,
        places,
        np.cumsum([0, *counts]).tolist(),
        tuple(sources),
        targets,
        tuple(name for kind, name in targets if kind == CHANNEL),
        np.repeat(np.arange(len(counts)), counts),
        lows,
        spans,
        runs + np.repeat(before, counts)[:, None],
        pieces,
        rates,
        np.argsort(slots, kind="stable"),
        np.searchsorted(np.sort(slots), np.arange(len(targets) + 1)),
        np.array([_limits(*target) for target in targets], np.float64).reshape(-1, 2),
        np.array([kind != PAD for kind, _ in kinds], bool),
        tuple((places[name], mapping.when) for name, mapping in mappings.items() if mapping.when is not None),
        any(mapping.plays_pads for mapping in mappings.values()),
    )


def _target_of(to: str) -> Target:
    kind, _, name = to.partition("/")
    return kind, name  # type: ignore[return-value]  # checked with its mapping


def _limits(kind: TargetKind, name: str) -> tuple[float, float]:
    """Where the sum of the sources of a target ends."""
    if kind == CHANNEL:
        return FULL_CHANNEL
    if kind == PAD:
        return PLACE_RANGE
    limit = ANGLES[kind][name]
    return -limit, limit


def _pairs(rows: Values) -> list[Pair]:
    return [*zip(rows[:, 0].tolist(), rows[:, 1].tolist(), strict=True)]


def _steps(dt: float) -> tuple[float, int]:
    """A gap (seconds) in equal steps, and how many; at no time at all, what follows at once does."""
    steps = list(steps_of(dt))
    return (steps[0], len(steps)) if steps else (0.0, 1)


@cache
def _gate_rates(count: int) -> Values:
    return np.full(count, GATE_RATE)


@cache
def _kernels() -> ModuleType:
    """The kernels, loaded when a first macro is moved: no command line needs Numba."""
    from omote.perform.mappings import macro_kernels

    return macro_kernels
