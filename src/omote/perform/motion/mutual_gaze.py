"""Mutual gaze: when two who look at one another meet each other's eyes, and who looks away first."""

from __future__ import annotations

from functools import lru_cache

from omote.perform.motion.counter_hash import uniform
from omote.perform.motion.quantiles import MUTUAL_SPELL

SLOT = 6.0
"""Seconds in which two meet each other's eyes once: 45 in a hundred of the time (Argyle and Ingham 1972: 30 to 60)."""
SHORTEST_BREAK = 0.6
"""Seconds between two spells at least."""
BOTH = 0.6
"""The share of breaks in which the other looks away too."""
AFTER = 0.4
"""Seconds by which that is later, and the other back earlier."""
_LENGTH, _BEGIN, _WHO, _BOTH = 31, 32, 33, 34


@lru_cache(maxsize=64)
def contacts(seeds: tuple[int, int], time: float) -> tuple[bool, bool]:
    """Whether each of two who look at one another is at the other's eyes.

    Parameters
    ----------
    seeds : tuple of int
        Of both, in an order that stays.
    time : float
        Of the scene, seconds.

    Returns
    -------
    tuple of bool
        Of both; all from seeds and time, so that nothing has to be kept.
    """
    seed = seeds[0] * 2654435761 + seeds[1]
    slot = int(time // SLOT)
    begin, end = _spell(seed, slot)
    if begin <= time < end:
        return True, True
    if time < begin:  # the break since the spell before, which is that slot's
        slot, end, begin = slot - 1, _spell(seed, slot - 1)[1], begin
    else:
        begin = _spell(seed, slot + 1)[0]
    other = uniform(seed, _BOTH, slot) < BOTH and end + AFTER <= time < begin - AFTER
    first_leads = uniform(seed, _WHO, slot) < 0.5
    return (False, not other) if first_leads else (not other, False)


@lru_cache(maxsize=256)
def _spell(seed: int, slot: int) -> tuple[float, float]:
    """When the spell of a slot begins and ends."""
    length = MUTUAL_SPELL.at(uniform(seed, _LENGTH, slot))
    begin = SLOT * slot + (SLOT - SHORTEST_BREAK - length) * uniform(seed, _BEGIN, slot)
    return begin, begin + length
