"""Two who look at one another."""

import itertools

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion.mutual_gaze import SHORTEST_BREAK, contacts

SEEDS = st.tuples(st.integers(0, 2**31 - 1), st.integers(0, 2**31 - 1))
STEP = 1 / 30


def spells(met: list[bool]) -> list[tuple[bool, float]]:
    """The spells of a sequence but the first and the last, with their seconds."""
    ends = np.flatnonzero(np.diff(met)) + 1
    return [(met[begin], (end - begin) * STEP) for begin, end in itertools.pairwise(ends)]


@given(SEEDS)
def test_they_meet_each_others_eyes_in_spells_of_one_to_five_seconds(seeds: tuple[int, int]) -> None:
    seen = [contacts(seeds, step * STEP) for step in range(9000)]
    found = spells([one and other for one, other in seen])
    meeting = [seconds for met, seconds in found if met]
    breaks = [seconds for met, seconds in found if not met]
    assert min(meeting) >= 1.0 - 2 * STEP
    assert max(meeting) <= 5.0 + 2 * STEP
    assert min(breaks) >= SHORTEST_BREAK - 2 * STEP
    assert 0.3 < sum(meeting) / (sum(meeting) + sum(breaks)) < 0.6


@given(SEEDS)
def test_now_one_and_now_the_other_looks_away_first(seeds: tuple[int, int]) -> None:
    seen = [contacts(seeds, step / 10) for step in range(6000)]
    first = [after for before, after in itertools.pairwise(seen) if before == (True, True) != after]
    assert (False, True) in first
    assert (True, False) in first
    assert all(any(each) for each in first), "both never look away at once"
