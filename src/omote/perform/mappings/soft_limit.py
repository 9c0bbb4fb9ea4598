"""Several sources on one target: their sum, softly limited, of + - * / alone.

Each source is stretched as if the limit were endless, the stretched are added, and the sum is limited: so one source
alone is what it is, all is plain addition up to the knee, more of any source is never less of the sum, and no order
counts.
"""

from __future__ import annotations

from collections.abc import Iterable

KNEE = 0.8
"""Of the limit: up to here the sum is exact. At a clip the speed of what shows jumps by 1.0 of the hand's, here by .09
within a tick (shared design, "Mappings")."""


def soft_sum(values: Iterable[float], lowest: float, highest: float) -> float:
    """The sum of some sources: exact up to four fifths of the limit of its sign, and within that limit where each
    source is; of those that are beyond it alone, the one that is furthest.

    With the knee k, the limit L and w = L - k: S(u) = k + w v / (w + v), v = u - k; the sum is S of all S^-1(x).

    Parameters
    ----------
    values : sequence of float
        What each source gives.
    lowest, highest : float
        The limits below and above zero, in the same unit.

    Returns
    -------
    float
        Continuous with its slope wherever at most one source is beyond its limit.
    """
    total = 0.0
    count = 0
    furthest = 0.0
    for value in values:
        if value == 0.0:
            continue
        count += 1
        if value >= highest or value <= lowest:
            furthest = value if abs(value) > abs(furthest) else furthest
        alone = value
        total += value if KNEE * lowest <= value <= KNEE * highest else _stretched(value, lowest, highest)
    if furthest:
        return furthest
    if count <= 1:
        return alone if count else 0.0
    limit = highest if total > 0.0 else lowest
    knee = KNEE * limit
    beyond = total - knee
    if beyond * limit <= 0.0:
        return total
    width = limit - knee
    return knee + width * beyond / (width + beyond)


def _stretched(value: float, lowest: float, highest: float) -> float:
    """What the soft limit would make a value of: endless at the limit."""
    limit = highest if value > 0.0 else lowest
    if not abs(value) < abs(limit):
        return 0.0  # it alone shows
    knee = KNEE * limit
    width = limit - knee
    return knee + width * (value - knee) / (limit - value)
