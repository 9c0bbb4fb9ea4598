"""A mapping learned by touching: what the console that teaches moves, and nothing moves on air when it is learned."""

from __future__ import annotations

import pytest

from omote.model.cast import Cast
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.show.mapping_learning import LEARNS_SECONDS
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.faders import SetChannel, SetHead
from omote.show.objects.hand.macros import FinishMapping, LearnMapping, MappingLearned
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession
from omote.show.wire import decode, encode


@pytest.fixture(name="session")
def _session(cast: Cast) -> ShowSession:
    session = ShowSession(cast)
    for who in ("ana", "ben"):
        session.receive(who, Hello("console", PROTOCOL_VERSION, who, f"page of {who}", who), 0.0)
    session.tick(0.0)
    session.receive("ana", SetChannel("one", "browInnerUp", 0.2), 0.0)
    session.receive("ana", LearnMapping("l", "one", "smile"), 0.0)
    return session


def touch(session: ShowSession) -> None:
    """Ana opens the jaw in two moves, raises the brows and turns the head; Ben opens an eye."""
    for weight in (0.7, 0.6):
        session.receive("ana", SetChannel("one", "jawOpen", weight), 1.0)
    session.receive("ana", SetChannel("one", "browInnerUp", 0.5), 1.0)
    session.receive("ana", SetHead("one", 0.25, 0.0, 0.0), 1.0)
    session.receive("ben", SetChannel("one", "mouthSmile", 0.5), 1.0)


def test_what_one_console_touches_becomes_the_targets_and_nothing_moves(session: ShowSession) -> None:
    touch(session)
    before = session.tick(1.0).characters["one"]
    assert session.receive("ana", FinishMapping("f"), 1.0) == []
    after = session.tick(1.0).characters["one"]
    targets = session.scene["one"].mappings["smile"].targets
    assert [(target.to, target.low, target.high) for target in targets] == [
        ("channel/jawOpen", 0.0, 0.6),
        ("channel/browInnerUp", 0.0, 0.3),
        ("head/yaw", 0.0, 0.25),
    ]
    assert after.channels == pytest.approx(before.channels)
    assert after.head == before.head
    assert after.held is not None
    assert after.held.channels.get("jawOpen", 0.0) == 0.0
    assert after.held.channels["browInnerUp"] == 0.2
    assert after.macros["smile"].value == 1.0


def test_a_head_that_springs_back_was_touched_and_a_fader_that_is_put_back_was_not(session: ShowSession) -> None:
    for yaw in (0.1, 0.3, 0.2, 0.0):
        session.receive("ana", SetHead("one", yaw, -0.2 * yaw, 0.0), 1.0)
    for weight in (0.7, 0.0):
        session.receive("ana", SetChannel("one", "jawOpen", weight), 1.0)
    session.receive("ana", FinishMapping("f"), 1.0)
    targets = session.scene["one"].mappings["smile"].targets
    assert [(target.to, target.high) for target in targets] == [("head/yaw", 0.3), ("head/pitch", -0.2 * 0.3)]


def test_consoles_are_told_what_is_learned(session: ShowSession) -> None:
    def told() -> MappingLearned | None:
        news = [each.message for each in session.hands_now(0.0) if isinstance(each.message, MappingLearned)]
        return news[0] if news else None

    assert told() == MappingLearned("one", "smile", "ana", [])
    session.receive("ana", SetChannel("one", "jawOpen", 0.5), 0.0)
    assert told() == MappingLearned("one", "smile", "ana", [MacroTarget("channel/jawOpen", high=0.5)])
    session.receive("ana", FinishMapping("f", keep=False), 0.0)
    assert told() == MappingLearned("", "", "", [])
    assert dict(session.scene["one"].mappings) == {}


def test_it_ends_by_itself_and_who_has_gone_teaches_no_more(session: ShowSession) -> None:
    touch(session)
    session.tick(1.0 + LEARNS_SECONDS)
    assert list(session.scene["one"].mappings) == ["smile"]
    session.receive("ana", LearnMapping("l2", "one", "jaw"), 100.0)
    session.receive("ana", SetChannel("one", "jawOpen", 0.1), 100.0)
    session.leave("ana")
    session.receive("ben", LearnMapping("l3", "one", "jaw"), 100.0)
    assert list(session.scene["one"].mappings) == ["smile"]


def test_one_teaches_at_a_time(session: ShowSession) -> None:
    for message in (LearnMapping("b", "one", "jaw"), FinishMapping("c")):
        (refused,) = session.receive("ben", message, 0.0)
        assert isinstance(refused.message, Refused)
    (refused,) = session.receive("ana", LearnMapping("d", "two", "jaw"), 0.0)
    assert isinstance(refused.message, Refused)
    assert "there is no character 'two'" in refused.message.reason


def test_eight_targets_at_most(session: ShowSession, cast: Cast) -> None:
    names = [name for name in cast.expressions if name != "neutral"][:9]
    for name in names:
        session.receive("ana", SetChannel("one", name, 0.9), 0.0)
    session.receive("ana", FinishMapping("f"), 0.0)
    mapping = session.scene["one"].mappings["smile"]
    assert isinstance(mapping, MacroMapping)
    assert len(mapping.targets) == 8


def test_the_longest_id_of_a_lesson_gives_a_mapping_that_a_recording_can_keep(session: ShowSession) -> None:
    session.receive("ana", LearnMapping("n" * 64, "one", "smile"), 0.0)
    touch(session)
    _, (mapping, *_) = session.learning.end(keeps=True)
    assert decode(encode(mapping)) == mapping
