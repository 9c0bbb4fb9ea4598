"""A mapping: what a macro, a number under a hand, plays of its character; checked once, when it is made."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.perform.layers.follower import rate_of
from omote.perform.limits import (
    CHANNEL_HIGHEST,
    CHANNEL_LOWEST,
    GAZE_LIMITS,
    HEAD_LIMITS,
    check_known,
    check_switch,
    check_within,
)
from omote.perform.mappings.monotone_curve import STRAIGHT, Knots, Pieces, check_knots, pieces_of, value_of
from omote.perform.pads.blend_space import AXES, PLACE_RANGE

TargetKind = Literal["channel", "head", "gaze", "pad"]
ReadKind = Literal["macro", "channel", "expression"]
CHANNEL = "channel"
HEAD = "head"
GAZE = "gaze"
PAD = "pad"
MOST_TARGETS = 8
LONGEST_MACRO = 40
LONGEST_TARGET = 120
"""Characters."""
LONGEST_FOLLOWER = 5.0
"""Seconds."""
MACRO_LIMITS = (-1.0, 1.0)
WIDEST = max(CHANNEL_HIGHEST, *HEAD_LIMITS.values(), *GAZE_LIMITS.values())
"""What any target takes: weights, radians."""
IN_ADDRESSES = "/*?[]{}# ,"
"""What no name of a macro has: its address of OSC is made of it."""
ANGLES: Mapping[str, Mapping[str, float]] = {HEAD: HEAD_LIMITS, GAZE: GAZE_LIMITS}
"""Radians either way."""


Half = tuple[float, float | None, Pieces, float, float]
"""Of a target: what it gives in the middle, how far it goes from there (None: it stays), by which curve, and the rates
(1/s) of its rise and its fall, 0 at once."""


@dataclass(frozen=True)
class HalfBelow:
    """The half of a target below the middle of its macro.

    Parameters
    ----------
    high : float
        What the target gives where the macro is at -1.
    curve : sequence of pairs of float
        As of `MacroTarget`: from the middle down.

    Raises
    ------
    ValueError
        On knots through which there is no curve.
    TypeError
        On what is no number.

    Examples
    --------
    >>> omote.MacroTarget("head/yaw", high=0.4, below=omote.HalfBelow(-0.2)).value_at(-1.0)
    -0.2

    References
    ----------
    docs/method.md, "Mappings".
    """

    high: float
    curve: Knots = STRAIGHT

    def __post_init__(self) -> None:
        """Rejects a curve that there is not."""
        high = check_within(self.high, -WIDEST, WIDEST, "what a macro gives at -1")
        object.__setattr__(self, "high", high)
        object.__setattr__(self, "curve", check_knots(self.curve, "the curve below zero"))


@dataclass(frozen=True)
class MacroTarget:
    """One of the targets of a macro: what it gives of it, and how that follows.

    Parameters
    ----------
    to : str
        `channel/jawOpen`, `head/yaw` (pitch, roll), `gaze/yaw` (pitch), or `pad/mouth/x` (y, z), where the point of a
        pad is.
    low, high : float
        What it gives where the macro is at 0 and at 1, in the unit of the target (weights, radians, places); `low` may
        be the higher one.
    curve : sequence of pairs of float
        Two to seven knots of the way between: where the macro is, 0 to 1, and the part of the way from `low` to
        `high`; the first is (0, 0).
    below : HalfBelow, optional
        The half below zero; without it the target stays at `low` there.
    rise, fall : float
        Seconds, 0 to 5, in which what it gives has gone nine tenths of a step, up and down.

    Raises
    ------
    ValueError
        On a target that there is not, on numbers out of range and knots through which there is no curve.
    TypeError
        On what is no number.

    Examples
    --------
    >>> brows = omote.MacroTarget("channel/browInnerUp", high=0.8, curve=[(0, 0), (0.5, 0.2), (1, 1)])
    >>> brows.value_at(0.0), round(brows.value_at(0.5), 3), brows.value_at(1.0)
    (0.0, 0.16, 0.8)

    References
    ----------
    docs/method.md, "Mappings"; F. N. Fritsch, R. E. Carlson (1980).
    """

    to: str
    low: float = 0.0
    high: float = 1.0
    curve: Knots = STRAIGHT
    below: HalfBelow | None = None
    rise: float = 0.0
    fall: float = 0.0

    def __post_init__(self) -> None:
        """Rejects what no macro plays."""
        low, high = range_of(self.to)
        for name in ("low", "high"):
            number = check_within(getattr(self, name), low, high, f"what the macro gives {self.to} ({name})")
            object.__setattr__(self, name, number)
        for name in ("rise", "fall"):
            seconds = check_within(getattr(self, name), 0.0, LONGEST_FOLLOWER, f"the {name} of {self.to} (seconds)")
            object.__setattr__(self, name, seconds)
        object.__setattr__(self, "curve", check_knots(self.curve, f"the curve of {self.to}"))
        object.__setattr__(self, "below", self.below)  # msgspec tells a field that an object has itself, not by default
        if self.below is not None:
            check_within(self.below.high, low, high, f"what the macro gives {self.to} at -1")

    @cached_property
    def place(self) -> tuple[TargetKind, str]:
        """Its kind, and its name among those of its kind."""
        kind, _, name = self.to.partition("/")
        return check_known(kind, get_args(TargetKind), "kind of target"), name

    def value_at(self, macro: float) -> float:
        """What it gives, in its unit.

        Parameters
        ----------
        macro : float
            Where the macro is, -1 to 1.

        Returns
        -------
        float
            Between `low` and `high`, or below zero between `low` and the end of that half.

        Examples
        --------
        >>> turn = omote.MacroTarget("head/yaw", high=0.4, below=omote.HalfBelow(-0.2))
        >>> turn.value_at(0.5), turn.value_at(-0.5)
        (0.2, -0.1)
        """
        low = self.low
        if macro >= 0.0:
            return low + (self.high - low) * value_of(self._pieces, macro)
        below = self.below
        return low if below is None else low + (below.high - low) * value_of(self._pieces_below, -macro)

    @cached_property
    def halves(self) -> tuple[Half, Half]:
        """What it gives from the middle up, and below: worked out once, for hands move it each tick."""
        rates = rate_or_none(self.rise), rate_or_none(self.fall)
        below = None if self.below is None else self.below.high - self.low
        return (self.low, self.high - self.low, self._pieces, *rates), (self.low, below, self._pieces_below, *rates)

    @cached_property
    def _pieces(self) -> Pieces:
        return pieces_of(self.curve)

    @cached_property
    def _pieces_below(self) -> Pieces:
        return pieces_of(self.curve if self.below is None else self.below.curve)


class TargetRows(NamedTuple):
    """The targets of a mapping as numbers. lows (m,), spans (m, 2): what each gives in the middle, and how far it goes
    from there above and below, not a number where it stays; runs (m, 4): where its curves above and below begin and end
    in pieces (k, 9); rates (m, 2): of its rise and its fall (1/s), 0 at once."""

    lows: Values
    spans: Values
    runs: NDArray[np.int64]
    pieces: Values
    rates: Values


@dataclass(frozen=True)
class MacroCondition:
    """Where a macro plays at all: while something is above a level, or below it.

    Parameters
    ----------
    reads : str
        `macro/NAME`, another of the character's; `channel/jawOpen`, as its fader holds it; or `expression/smile`, as
        much of it as is called on the whole face.
    level : float
        Where it opens, -1 to 1.5.
    above : bool
        Whether it plays above the level or below it.
    hysteresis : float
        How far beyond the level it shuts again, 0 to 1: what trembles there does not open and shut it.

    Raises
    ------
    ValueError
        On what cannot be read, and on numbers out of range.
    TypeError
        On what is no number or no switch.

    Examples
    --------
    >>> omote.MacroCondition("expression/smile", 0.5).opens(0.48, was_open=True)
    True

    References
    ----------
    docs/method.md, "Mappings".
    """

    reads: str
    level: float
    above: bool = True
    hysteresis: float = 0.05

    def __post_init__(self) -> None:
        """Rejects what cannot be read."""
        check_known(self.place[0], get_args(ReadKind), "kind of source of a condition")
        if not 0 < len(self.place[1]) <= LONGEST_TARGET:
            raise ValueError(f"the condition reads {self.reads!r:.80}; give such as channel/jawOpen")
        object.__setattr__(self, "level", check_within(self.level, -1.0, CHANNEL_HIGHEST, "the level of a condition"))
        hysteresis = check_within(self.hysteresis, 0.0, 1.0, "the hysteresis of a condition")
        object.__setattr__(self, "hysteresis", hysteresis)
        check_switch(self.above, "whether a condition is above its level")
        object.__setattr__(self, "above", self.above)  # told as `below` of a target

    @cached_property
    def place(self) -> tuple[str, str]:
        """The kind of what it reads, and its name among those."""
        kind, _, name = self.reads.partition("/")
        return kind, name

    def opens(self, reading: float, *, was_open: bool) -> bool:
        """Whether the macro plays now.

        Parameters
        ----------
        reading : float
            Of what it reads.
        was_open : bool
            Whether it played until now.

        Returns
        -------
        bool
            True beyond the level, and until the reading is back behind it by the hysteresis.

        Examples
        --------
        >>> smiles = omote.MacroCondition("expression/smile", 0.5, hysteresis=0.1)
        >>> smiles.opens(0.45, was_open=False), smiles.opens(0.45, was_open=True)
        (False, True)
        """
        beyond = reading - self.level if self.above else self.level - reading
        return beyond > (-self.hysteresis if was_open else 0.0)


@dataclass(frozen=True)
class MacroMapping:
    """What a macro plays: one number under a hand, several targets.

    Parameters
    ----------
    name : str
        Of the macro: 1 to 40 letters, digits and such, without spaces and `/*?[]{}#,`.
    targets : sequence of MacroTarget
        One to eight, each of another target.
    when : MacroCondition, optional
        Where it plays at all; it fades over 0.2 s.

    Raises
    ------
    ValueError
        On a name that none can have, on no target, on more than eight, and on one that comes twice.

    Examples
    --------
    >>> jaw = omote.MacroMapping("mouth", [omote.MacroTarget("channel/jawOpen")])
    >>> jaw.is_two_way
    False

    References
    ----------
    docs/method.md, "Mappings".
    """

    name: str
    targets: tuple[MacroTarget, ...]
    when: MacroCondition | None = None

    def __post_init__(self) -> None:
        """Rejects what is no mapping."""
        check_macro_name(self.name)
        object.__setattr__(self, "targets", tuple(self.targets))
        object.__setattr__(self, "when", self.when)  # told as `below` of a target
        if not 0 < len(self.targets) <= MOST_TARGETS:
            raise ValueError(f"the macro {self.name} has {len(self.targets)} targets; give 1 to {MOST_TARGETS}")
        reached = [target.to for target in self.targets]
        twice = next((to for place, to in enumerate(reached) if to in reached[:place]), None)
        if twice is not None:
            raise ValueError(f"the macro {self.name} has {twice} twice; draw one curve for it")

    @property
    def is_two_way(self) -> bool:
        """Whether it plays below zero.

        Returns
        -------
        bool
            True where a target has a half below zero.

        Examples
        --------
        >>> down = omote.HalfBelow(-0.2)
        >>> omote.MacroMapping("turn", [omote.MacroTarget("head/yaw", high=0.2, below=down)]).is_two_way
        True
        """
        return any(target.below is not None for target in self.targets)

    @cached_property
    def rows(self) -> TargetRows:
        """Its targets as numbers: worked out once, for a character's change with each of its mappings."""
        pieces: list[tuple[float, ...]] = []
        runs: list[list[int]] = []
        for target in self.targets:
            ends = [len(pieces)]
            for _, _, half, _, _ in target.halves:
                pieces += half
                ends.append(len(pieces))
            runs.append([ends[0], ends[1], ends[1], ends[2]])
        halves = [target.halves for target in self.targets]
        return TargetRows(
            np.array([target.low for target in self.targets]),
            np.array([[math.nan if span is None else span for _, span, _, _, _ in each] for each in halves]),
            np.array(runs, np.int64),
            np.array(pieces, np.float64).reshape(-1, 9),
            np.array([above[3:] for above, _ in halves]),
        )

    @cached_property
    def plays_pads(self) -> bool:
        """Whether it moves the point of a pad."""
        return any(target.place[0] == PAD for target in self.targets)

    @cached_property
    def is_nothing_at_rest(self) -> bool:
        """Whether it gives nothing where it is at 0."""
        return not any(target.low for target in self.targets)

    def with_name(self, name: str) -> MacroMapping:
        """The same for another macro.

        Parameters
        ----------
        name : str
            Of that macro, as of the class.

        Returns
        -------
        MacroMapping
            With the same targets.

        Raises
        ------
        ValueError
            On a name that none can have.

        Examples
        --------
        >>> omote.MacroMapping("mouth", (omote.MacroTarget("channel/jawOpen"),)).with_name("jaw").name
        'jaw'
        """
        return replace(self, name=name)


def range_of(to: object) -> tuple[float, float]:
    """What a target takes, lowest and highest; ValueError for one that there is not. to: as of `MacroTarget`."""
    kind, _, name = to.partition("/") if isinstance(to, str) and len(to) <= LONGEST_TARGET else ("", "", "")
    if kind == CHANNEL and name:
        return CHANNEL_LOWEST, CHANNEL_HIGHEST
    if kind == PAD and axis_of_pad(name)[1] in AXES:
        return PLACE_RANGE
    limit = ANGLES.get(kind, {}).get(name)
    if limit is None:
        raise ValueError(
            f"a macro cannot play {to!r:.80}; give channel/NAME, {HEAD}/{'|'.join(HEAD_LIMITS)}, "
            f"{GAZE}/{'|'.join(GAZE_LIMITS)} or {PAD}/NAME/{'|'.join(AXES)}"
        )
    return -limit, limit


def rate_or_none(seconds: float) -> float:
    """The rate (1/s) of a follower of so many seconds; 0 for one that is there at once."""
    return rate_of(seconds) if seconds else 0.0


def fitted(to: str, value: float) -> float:
    """The number that a target takes that is nearest to a value. to: as of `MacroTarget`."""
    low, high = range_of(to)
    return min(max(value, low), high)


def axis_of_pad(name: str) -> tuple[str, str]:
    """The pad and the axis that a target means by its name among those of its kind: `mouth/x`."""
    pad, _, axis = name.rpartition("/")
    return pad, axis if pad else ""


def check_macro_name(name: object) -> str:
    """Returns the name of a macro; ValueError for one that none can have."""
    if not isinstance(name, str) or not 0 < len(name) <= LONGEST_MACRO:
        raise ValueError(f"the name of a macro is {name!r:.100}; give 1 to {LONGEST_MACRO} letters")
    wrong = next((letter for letter in name if letter in IN_ADDRESSES or not letter.isprintable()), None)
    if wrong is not None:
        raise ValueError(f"a macro cannot be called {name!r}, for {wrong!r} has a meaning in addresses; leave it out")
    return name


def places_in(mappings: Iterable[MacroMapping]) -> list[tuple[TargetKind, str]]:
    """The kinds and the names of all targets of some mappings, each once, in their order."""
    return list(dict.fromkeys(target.place for mapping in mappings for target in mapping.targets))
