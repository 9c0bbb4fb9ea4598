"""Several sources on one target (Numba): their sum, softly limited, of + - * / alone.

Each source is stretched as if the limit were endless, the stretched are added, and the sum is limited: so one source
alone is what it is, all is plain addition up to the knee, more of any source is never less of the sum, and no order
counts.
"""

from __future__ import annotations

from numba import float64, njit, types

from omote.arrays import Values

KNEE = 0.8
"""Of the limit: up to here the sum is exact. At a clip the speed of what shows jumps by 1.0 of the hand's, here by .09
within a tick (shared design, "Mappings")."""


@njit(float64(*[float64] * 3), cache=True, error_model="numpy")
def _stretched(value: float, lowest: float, highest: float) -> float:
    """What the soft limit would make a value of: endless at the limit."""
    limit = highest if value > 0.0 else lowest
    if not abs(value) < abs(limit):
        return 0.0  # it alone shows
    knee = KNEE * limit
    width = limit - knee
    return knee + width * (value - knee) / (limit - value)


@njit(float64(types.Array(float64, 1, "C", readonly=True), float64, float64), cache=True, error_model="numpy")
def soft_sum(values: Values, lowest: float, highest: float) -> float:
    """The sum of some sources: exact up to four fifths of the limit of its sign, and within that limit where each
    source is; of those that are beyond it alone, the one that is furthest.

    With the knee k, the limit L and w = L - k: S(u) = k + w v / (w + v), v = u - k; the sum is S of all S^-1(x).

    Parameters
    ----------
    values : array (n,)
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
    alone = 0.0
    for value in values:
        if value == 0.0:
            continue
        count += 1
        if value >= highest or value <= lowest:
            furthest = value if abs(value) > abs(furthest) else furthest
        alone = value
        within = KNEE * lowest <= value <= KNEE * highest
        total += value if within else _stretched(value, lowest, highest)
    if furthest != 0.0:
        return furthest
    if count <= 1:
        return alone
    limit = highest if total > 0.0 else lowest
    knee = KNEE * limit
    beyond = total - knee
    if beyond * limit <= 0.0:
        return total
    width = limit - knee
    return knee + width * beyond / (width + beyond)
