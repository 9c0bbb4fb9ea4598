"""What cues leave standing."""

from dataclasses import replace

import pytest

from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.tracking import NOTHING_TRACKED, tracked_after, tracked_at, tracked_through

JOY = {"joy": 1.0}
FEAR = {"fear": 1.0}


def cue(number: int, **moves: dict[str, float]) -> Cue:
    """A cue that moves parts of `one`."""
    return Cue(str(number), str(number), {f"one/{part}": Move(goal) for part, goal in moves.items()})


CUES = (cue(1, face=JOY, brows=FEAR), cue(2, eyes=JOY), cue(3, expression=FEAR, eyes=FEAR), cue(4, mouth=JOY))


def test_a_cue_leaves_what_it_moves_and_all_else_stands() -> None:
    assert dict(tracked_through(CUES[:2])) == {"one/face": JOY, "one/brows": FEAR, "one/eyes": JOY}


def test_a_whole_expression_takes_its_regions_and_the_cue_s_own_come_after_it() -> None:
    assert dict(tracked_through(CUES)) == {
        "one/face": JOY,
        "one/expression": FEAR,
        "one/eyes": FEAR,
        "one/mouth": JOY,
    }


@pytest.mark.parametrize("place", range(len(CUES)))
def test_what_stands_at_a_place_is_what_stood_before_it_and_its_own(place: int) -> None:
    before = tracked_at(CUES, place - 1) if place else NOTHING_TRACKED
    assert tracked_at(CUES, place) == tracked_after(before, CUES[place])


def test_what_is_skipped_leaves_nothing_unless_it_is_the_one() -> None:
    cues = tuple(replace(each, skip=True) for each in CUES)
    assert tracked_at(cues, 2) == tracked_through(CUES[2:3])
