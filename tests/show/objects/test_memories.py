"""Memories by messages: through every door, kept with the show, whole or not at all where others hold parts."""

import msgspec

from omote.model.cast import Cast
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.leases import SetLeases
from omote.show.objects.link import Hello, Refused
from omote.show.objects.memories import CallMemory, DeleteMemory, KeepMemory, RestoreMemory
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot
from tests import synthetic

FACE = synthetic.FACES[1]


def begun(cast: Cast) -> ShowSession:
    """Ana and Ben are there; Ana has kept the broad face."""
    session = ShowSession(cast)
    for who in ("ana", "ben"):
        session.receive(who, Hello("console", PROTOCOL_VERSION, who, f"page of {who}", who), 0.0)
    session.receive("ana", CallFace("one", "1", FACE, 0.0), 0.0)
    assert session.receive("ana", KeepMemory("2", "finale"), 0.0) == []
    session.receive("ana", CallFace("one", "3", "generic", 0.0), 0.0)
    return session


def test_it_lies_in_the_show_and_is_called_by_anybody(cast: Cast) -> None:
    session = begun(cast)
    session.tick(0.0)
    written = msgspec.msgpack.encode(session.snapshot())
    other = ShowSession.restored(cast, msgspec.msgpack.decode(written, type=SessionSnapshot), epoch=2)
    other.receive("ben", Hello("console", PROTOCOL_VERSION, "ben"), 0.0)
    assert other.receive("ben", CallMemory("1", "finale", 2.0), 0.0) == []
    other.tick(0.0)
    assert other.tick(2.0).characters["one"].faces == {FACE: 1.0}
    assert other.tick(2.0).memories == ["finale"]


def test_a_retry_of_a_key_changes_nothing_and_undo_brings_back(cast: Cast) -> None:
    session = begun(cast)
    session.receive("ana", DeleteMemory("4", "finale", "k"), 0.0)
    assert session.receive("ana", DeleteMemory("4", "finale", "k"), 0.0) == []
    assert session.tick(0.0).memories == []
    session.receive("ana", RestoreMemory("5", "k"), 0.0)
    assert session.tick(0.0).memories == ["finale"]


def test_where_another_holds_a_part_it_is_rejected_whole(cast: Cast) -> None:
    session = begun(cast)
    session.receive("ana", SetLeases("on", True), 0.0)
    session.receive("ana", SetChannel("one", "jawOpen", 0.5), 0.0)
    assert session.receive("ben", CallMemory("a", "finale"), 0.0) == [], "no part of it is another's"
    assert "one/face" not in session.leasing.table.held, "who calls it holds nothing"
    session.receive("ana", CallFace("one", "b", "generic", 0.0), 0.0)
    before = session.scene.snapshot()
    answers = session.receive("ben", CallMemory("c", "finale"), 0.0)
    (refused,) = (each.message for each in answers if isinstance(each.message, Refused))
    assert refused.held == ["one/face"]
    assert session.scene.snapshot() == before
    assert session.receive("ana", CallMemory("d", "finale"), 0.0) == []
