"""Units that saturate: a jaw that an expression opens is not opened once more by its fader, nor a lid shut twice."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from weakref import WeakKeyDictionary

import numpy as np

from omote.arrays import Values
from omote.model.action_units import ARKIT
from omote.model.known_names import PlayRegion
from omote.model.space.expression import Expression
from omote.model.weak_cache import weakly_cached
from omote.perform.frame import Frame
from omote.perform.mix import mix_in

SATURATING: Mapping[str, PlayRegion] = MappingProxyType(
    {
        "mouth-open": "mouth",
        "jawOpen": "mouth",
        "eyeBlinkLeft": "eyes",
        "eyeBlinkRight": "eyes",
        "eyeWideLeft": "eyes",
        "eyeWideRight": "eyes",
    }
)
"""The units that open, or shut, as far as the further of what plays them, and the region whose mix wears them."""
JAW_OPEN = "jawOpen"
JAW = ("mouth-open", JAW_OPEN)
TONGUE = "tongueOut"
TONGUE_OPENS = 0.3
"""Weight of `jawOpen` that a tongue which is out has at least: lips 8 to 10 mm apart, the dog's 16, for a tip of 5."""
HEAD_RADIUS = 0.09
"""Metres from the axis to the skin: what an angle and a ratio of radii are worth beside a height."""
MOVES_MOST = 0.6
"""Where a unit moves skin as much as this share of its farthest, it says what it is: the chin of a jaw, the middle of a
lid. Elsewhere, as at the corners of a mouth, other units pull as well."""
LEAST_SHARE = 0.1
"""Of a unit: what wears less of it is something else."""
OF_TAKES = frozenset(f"{unit}{side}" for unit in ARKIT for side in ("", "Left", "Right"))
"""Units that a tracker sends at one time, each for itself: none of them is a second source of another."""
SOFTNESS = 0.02
"""How round the corner is where one gets further than the other: 0 gives the further of both, 4 their sum."""
FULL = 1.0
"""The weight of a unit that a jaw opens without bending."""
BEYOND = 0.3
"""Weight at most that a jaw opens beyond `FULL` for two sources: 32 degrees of 25 (Muto 1996, Travers 2000)."""
WORN_ALTOGETHER = 0.1
"""The weight from which on what is worn counts as a second source whole: below, a jaw alone is left as it was."""


def saturate(
    expressions: Mapping[str, Expression], frame: Frame, channels: Mapping[str, float], /
) -> Mapping[str, float]:
    """The channels without what the mix of expressions, or another channel, opens or shuts already.

    A unit that saturates (`SATURATING`) goes as far as the further of both, not as far as their sum: `worn` of it and
    a channel `c` make `(worn + c + sqrt((worn - c)^2 + k worn c)) / 2`, of which the channel adds what is over `worn`.
    The jaw's total is bent beyond what it opens alone. A tongue that is out parts lips that nothing else has opened.
    Where nothing else wears a unit its channel stays bit for bit.

    expressions: those of the cast, by name; frame: its mixes; channels: weights, by name. Sums and square roots alone:
    every machine finds the same.
    """
    changed = dict[str, float]()
    others = {name: weight for name, weight in channels.items() if name not in OF_TAKES}
    for unit, region in SATURATING.items():
        if unit not in expressions:
            continue
        mix = mix_in(region, frame.expressions, frame.regions)
        before = weight = channels.get(unit, 0.0)
        if unit == JAW_OPEN:
            weight = _parted(weight, TONGUE_OPENS * (mix.get(TONGUE, 0.0) + channels.get(TONGUE, 0.0)))
        if weight > 0.0:
            own = others.pop(unit, None)
            worn = _worn(expressions[unit], expressions, mix) + _worn(expressions[unit], expressions, others)
            weight = added_by(weight, worn, held=unit in JAW) if worn else weight
            if own is not None:
                others[unit] = weight
        if weight != before:
            changed[unit] = weight
    return {**channels, **changed} if changed else channels


def added_by(weight: float, worn: float, *, held: bool = False) -> float:
    """What a channel adds to a unit of which so much is worn already: 0 to `weight`.

    weight: of the channel, above 0; worn: 0 or more; held: whether the total is bent beyond `FULL`.
    """
    if held:
        second = min(worn / WORN_ALTOGETHER, 1.0)
        weight += second * (_bend(weight) - weight)
    return max(_further(worn, weight) - worn, 0.0)


def _parted(jaw: float, opened: float) -> float:
    """The weight of a jaw that a tongue opens so far at least."""
    if opened <= 0.0:
        return jaw
    return _further(jaw, opened) if jaw > 0.0 else jaw + opened


def _further(one: float, other: float) -> float:
    """The further of two weights above 0, with a round corner where they meet."""
    apart = one - other
    return 0.5 * (one + other + math.sqrt(apart * apart + SOFTNESS * one * other))


def _bend(total: float) -> float:
    """A weight that nears `FULL + BEYOND` beyond `FULL`, without a corner."""
    over = total - FULL
    return FULL + BEYOND * over / (BEYOND + over) if over > 0.0 else total


def _worn(unit: Expression, expressions: Mapping[str, Expression], weights: Mapping[str, float]) -> float:
    """How much of a unit these wear, 0 or more."""
    worn = 0.0
    for name, weight in weights.items():
        if name in expressions:
            worn += weight * worn_share(unit, expressions[name])
    return max(worn, 0.0)


def worn_share(unit: Expression, expression: Expression) -> float:
    """How much of a unit an expression wears, 0 or from `LEAST_SHARE` on: its field's share along the unit's, where the
    unit moves skin most.

    Summed exactly (`math.fsum`), so that every machine finds the same.
    """
    shares = _shares_of(unit)
    share = shares.get(expression)
    if share is None:
        share = shares[expression] = _share(unit, expression)
    return share


@weakly_cached
def _shares_of(_: Expression, /) -> WeakKeyDictionary[Expression, float]:
    return WeakKeyDictionary()


def _share(unit: Expression, expression: Expression) -> float:
    if np.shape(unit.dh) != np.shape(expression.dh):
        return 0.0
    moves = _moves(unit)
    lengths = (moves * moves).sum(axis=0)
    rows = np.flatnonzero(lengths > MOVES_MOST * MOVES_MOST * lengths.max(initial=0.0))
    own = moves[:, rows].ravel()
    other = _moves(expression)[:, rows].ravel()
    square = math.fsum((own * own).tolist())
    share = math.fsum((own * other).tolist()) / square if square else 0.0
    return share if share >= LEAST_SHARE else 0.0


def _moves(expression: Expression) -> Values:
    """About how far it moves each row of the sheet, metres: around, up and out, (3, V)."""
    return np.stack([expression.dtheta * HEAD_RADIUS, expression.dh, (expression.ratio - 1.0) * HEAD_RADIUS])
