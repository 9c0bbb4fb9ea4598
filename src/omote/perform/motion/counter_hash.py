"""Random numbers by counting: the same key gives the same number on every machine, and none depends on another."""

from __future__ import annotations

_MASK = (1 << 64) - 1
_GOLDEN = 0x9E3779B97F4A7C15


def uniform(seed: int, kind: int, count: int) -> float:
    """A number of a sequence, evenly distributed.

    Parameters
    ----------
    seed : int
        Of whom.
    kind : int
        Which sequence.
    count : int
        Which number of it, from 0.

    Returns
    -------
    float
        From 0 to below 1, a multiple of 2 ** -53.

    References
    ----------
    The finalizer of SplitMix64: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators",
    OOPSLA 2014.
    """
    mixed = _mix(_mix(_mix(seed & _MASK) ^ (kind & _MASK)) ^ (count & _MASK))
    return (mixed >> 11) * 2.0**-53


def _mix(value: int) -> int:
    value = (value + _GOLDEN) & _MASK
    value = ((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
    value = ((value ^ (value >> 27)) * 0x94D049BB133111EB) & _MASK
    return value ^ (value >> 31)
