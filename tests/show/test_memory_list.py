"""What consoles are told of memories."""

from __future__ import annotations

from omote.model.cast import Cast
from omote.show.memory_list import MemoryListing, list_memories
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello
from omote.show.objects.memories import DeleteMemory, KeepMemory, MemoryList, MemoryState, RestoreMemory
from omote.show.session import ShowSession
from tests import synthetic

FACE, SMILE = synthetic.FACES[1], synthetic.EXPRESSIONS[1]


def lists(session: ShowSession, now: float) -> list[MemoryList]:
    """The lists that consoles hear."""
    return [each.message for each in session.hands_now(now) if isinstance(each.message, MemoryList)]


def test_a_list_has_the_face_and_the_expression_of_each_character(cast: Cast) -> None:
    session = ShowSession(cast)
    session.scene["one"].call_face(FACE, seconds=0)
    session.scene["one"].call_expression(SMILE, seconds=0)
    session.scene.keep_memory("finale")
    goals = {"one/face": {FACE: 1.0}, "one/expression": {SMILE: 1.0}}
    assert list_memories(session.scene.memories) == MemoryList([MemoryState("finale", goals)])


def test_consoles_are_told_at_their_welcome_and_once_of_each_change(cast: Cast) -> None:
    session = ShowSession(cast)
    listing = MemoryListing(session.scene.memories)
    assert listing.news(session.scene.memories) is None, "whoever is there was told at its welcome"
    welcome = session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    assert not [each for each in welcome if isinstance(each.message, MemoryList)], "there is none yet"
    steps = (KeepMemory("1", "a"), KeepMemory("2", "b"), DeleteMemory("3", "a", "k"), RestoreMemory("4", "k"))
    for now, (step, names) in enumerate(zip(steps, (["a"], ["a", "b"], ["b"], ["b", "a"]), strict=True), 1):
        session.receive("ana", step, float(now))
        (told,) = lists(session, float(now))
        assert sorted(memory.name for memory in told.memories) == sorted(names)
        assert lists(session, now + 0.5) == []
    late = session.receive("ben", Hello("console", PROTOCOL_VERSION, "ben"), 9.0)
    assert [each.message for each in late if isinstance(each.message, MemoryList)] == [told]
