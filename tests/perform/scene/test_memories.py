"""Memories by name: as many as a show keeps, under names that people can read, and each change taken back exactly."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.frame import Gaze, Head
from omote.perform.scene.goals import TURN_LIMITS
from omote.perform.scene.memories import (
    MOST_MEMORIES,
    MOST_REPLACED,
    NO_MEMORIES,
    Memory,
    check_memories,
    turn_at,
    with_memory,
    with_restored,
    without_memory,
)
from omote.perform.scene.movement import Movement, proceed, redirect


def look(number: int) -> Memory:
    """A memory that is told apart by its framing."""
    return Memory({"*/framing": {str(number): 1.0}})


@given(changes=st.lists(st.tuples(st.sampled_from("ab"), st.booleans()), max_size=MOST_REPLACED))
def test_changes_are_taken_back_one_by_one_and_done_again(changes: list[tuple[str, bool]]) -> None:
    memories = with_memory(with_memory(NO_MEMORIES, "a", look(-1), "a"), "b", look(-2), "b")
    states = []
    for number, (name, keeps) in enumerate(changes):
        states.append(memories.kept)
        if keeps or name not in memories.kept:
            memories = with_memory(memories, name, look(number), f"k{number}")
        else:
            memories = without_memory(memories, name, f"k{number}")
    last = memories.kept
    for number in reversed(range(len(changes))):
        memories = with_restored(memories, f"k{number}")
        assert memories.kept == states[number]
    for number in range(len(changes)):
        memories = with_restored(memories, f"k{number}")
    assert memories.kept == last
    check_memories(memories)


@pytest.mark.parametrize("name", ["", "  ", "x" * 41, 7, None])
def test_a_name_that_nobody_can_read_is_rejected(name: object) -> None:
    with pytest.raises(ValueError, match="the name of a memory is"):
        with_memory(NO_MEMORIES, name, look(0), "k")


def test_there_are_so_many_and_each_can_still_be_kept_anew() -> None:
    memories = NO_MEMORIES
    for number in range(MOST_MEMORIES):
        memories = with_memory(memories, str(number), look(number), str(number))
    with pytest.raises(ValueError, match="there are 32 memories"):
        with_memory(memories, "one more", look(0), "k")
    assert with_memory(memories, "0", look(9), "k").kept["0"] == look(9)
    assert len(memories.replaced) == MOST_REPLACED
    with pytest.raises(ValueError, match="there is no memory 'x'"):
        without_memory(memories, "x", "k")
    with pytest.raises(ValueError, match="there is no change of a memory 'x'"):
        with_restored(memories, "x")


@given(yaw=st.floats(-0.5, 0.5), seconds=st.floats(0.1, 5.0), share=st.floats(0.0, 1.0))
def test_head_and_gaze_stay_in_their_range_on_the_way(yaw: float, seconds: float, share: float) -> None:
    for part, rest in (("head", Head()), ("gaze", Gaze())):
        way = redirect(Movement(vars(rest)), {**vars(rest), "yaw": yaw}, seconds, TURN_LIMITS[part])
        turned = turn_at(part, proceed(way, share * seconds))
        assert isinstance(turned, Head | Gaze)
        assert min(0.0, yaw) - 1e-9 <= turned.yaw <= max(0.0, yaw) + 1e-9
        assert type(turned) is type(rest)
