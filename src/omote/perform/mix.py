"""A mix: weights over names, as a vector whose absent names weigh nothing (docs/method.md, "Weights are enough")."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from omote.model.known_names import PlayRegion

Weights = Mapping[str, float]

LOWEST = -0.1
HIGHEST = 1.1
"""A weight on air never leaves this range: a velocity taken over may carry it past 0 or 1, but not far."""


def mix_of_one(name: str) -> dict[str, float]:
    """The mix of one name."""
    return {name: 1.0}


def combine(terms: Iterable[tuple[float, Weights]]) -> dict[str, float]:
    """The sum of factor times mix over the terms, without the names that weigh exactly nothing."""
    total: dict[str, float] = {}
    for factor, weights in terms:
        if factor:
            for name, weight in weights.items():
                total[name] = total.get(name, 0.0) + factor * weight
    return {name: weight for name, weight in total.items() if weight}


def mix_in(region: PlayRegion, whole: Weights, regions: Mapping[PlayRegion, Weights]) -> Weights:
    """The mix that shows in a region: its own, or that of the whole face where it has none.

    regions: the mixes of those that have their own.
    """
    return regions.get(region, whole)


def normalise(weights: Weights) -> dict[str, float]:
    """The mix in the same proportions that sums to one."""
    total = math.fsum(weights.values())
    return {name: weight / total for name, weight in weights.items()}


def share_in_range(base: Weights, offset: Weights) -> float:
    """The largest share 0..1 of `offset` that keeps every weight of base + share * offset in range."""
    share = 1.0
    for name, change in offset.items():
        weight = base.get(name, 0.0)
        room = (HIGHEST - weight) if change > 0 else (LOWEST - weight)
        if abs(change) > abs(room):
            share = min(share, max(0.0, room / change))
    return share
