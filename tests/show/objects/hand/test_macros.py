"""Macros by messages: set, moved, told, kept with the show, whole or not at all where others hold parts."""

from __future__ import annotations

import msgspec
import pytest

from omote.inputs.osc_feedback import tell_state
from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import encode_message
from omote.model.cast import Cast
from omote.perform.mappings.mapping import HalfBelow, MacroCondition, MacroMapping, MacroTarget
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import Panic
from omote.show.objects.characters import AddCharacter
from omote.show.objects.faders import SetChannel, SetHead
from omote.show.objects.hand.macros import (
    DropMapping,
    MappingList,
    MoveMacro,
    RenameMapping,
    RestoreMapping,
    SetMapping,
)
from omote.show.objects.leases import SetLeases
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot
from omote.show.wire import decode, encode

TURN = MacroTarget("head/yaw", high=0.4, below=HalfBelow(-0.2, ((0.0, 0.0), (0.5, 0.9), (1.0, 1.0))))
SMILE = MacroMapping("smile", (MacroTarget("channel/jawOpen", rise=0.1), TURN))
JAW = MacroMapping("jaw", (MacroTarget("channel/jawOpen"),))


@pytest.fixture(name="session")
def _session(cast: Cast) -> ShowSession:
    session = ShowSession(cast)
    for who in ("ana", "ben"):
        session.receive(who, Hello("console", PROTOCOL_VERSION, who, f"page of {who}", who), 0.0)
    assert session.receive("ana", SetMapping("one", "1", SMILE), 0.0) == []
    return session


def refusal_of(session: ShowSession, who: str, message: object) -> str:
    answers = session.receive(who, message, 0.0)  # type: ignore[arg-type]
    (refused,) = (each.message for each in answers if isinstance(each.message, Refused))
    return refused.reason


def test_a_mapping_travels_whole() -> None:
    message = SetMapping("one", "1", MacroMapping("m", (TURN,), MacroCondition("expression/smile", 0.3)), "k")
    assert decode(encode(message)) == message
    with pytest.raises(ValueError, match="a macro cannot play 'head/up!'"):
        decode(encode(message).replace(b"head/yaw", b"head/up!"))


def test_it_is_moved_told_and_kept_with_the_show(session: ShowSession, cast: Cast) -> None:
    session.tick(0.0)
    assert session.receive("ben", MoveMacro("one", "smile", -1.0), 0.0) == []
    written = msgspec.msgpack.encode(session.snapshot())
    other = ShowSession.restored(cast, msgspec.msgpack.decode(written, type=SessionSnapshot), epoch=2)
    other.tick(0.0)
    state = other.tick(1.0).characters["one"]
    assert (state.head[0], state.macros["smile"].value, state.macros["smile"].share) == (-0.2, -1.0, 1.0)
    assert state.held is not None
    assert state.held.head == (0.0, 0.0, 0.0)


def test_consoles_are_told_of_each_change_once_and_of_all_when_they_come(session: ShowSession) -> None:
    def told() -> list[MappingList]:
        return [each.message for each in session.hands_now(0.0) if isinstance(each.message, MappingList)]

    wanted = MappingList({"one": [SMILE]})
    assert told() == [wanted, wanted]
    assert told() == []
    session.receive("ana", SetMapping("one", "2", JAW), 0.0)
    session.receive("ana", RenameMapping("one", "3", "smile", "grin"), 0.0)
    (first, _) = told()
    assert [each.name for each in first.mappings["one"]] == ["grin", "jaw"]
    welcome = session.receive("cy", Hello("console", PROTOCOL_VERSION, "cy"), 0.0)
    assert first in [each.message for each in welcome]
    session.receive("ana", RestoreMapping("one", "4", "smile"), 0.0)
    session.receive("ana", DropMapping("one", "5", "jaw"), 0.0)
    assert told()[0] == wanted


def test_where_another_holds_a_part_of_one_target_it_is_rejected_whole(session: ShowSession) -> None:
    session.receive("ana", SetMapping("one", "2", JAW), 0.0)
    session.receive("ana", SetLeases("on", True), 0.0)
    session.receive("ana", SetHead("one", 0.1, 0.0, 0.0), 0.0)
    before = session.scene.snapshot()
    assert "ana holds the head" in refusal_of(session, "ben", MoveMacro("one", "smile", 0.5))
    assert session.scene.snapshot() == before
    assert session.receive("ben", MoveMacro("one", "jaw", 0.5), 0.0) == []
    assert session.leasing.table.held.keys() == {"one/head", "one/channels"}


def test_a_panic_elsewhere_takes_it_out_of_the_hand(session: ShowSession) -> None:
    session.tick(0.0)
    session.receive("ana", MoveMacro("one", "smile", 0.5), 0.0)
    session.receive("ben", Panic("one", "p"), 0.0)
    assert "panic was pressed" in refusal_of(session, "ana", MoveMacro("one", "smile", 0.6))
    assert session.tick(1.0).characters["one"].macros["smile"].value == 0.0


def test_surfaces_play_it_and_are_told_where_it_stands(session: ShowSession) -> None:
    osc = OscInput(lambda: session)
    osc.receive(("10.0.0.5", 9000), encode_message("/omote/one/macro/smile", 0.5), 0.0)
    assert tell_state(session.tick(0.0))["/omote/one/macro/smile"] == (0.5,)


def test_in_preview_it_moves_unseen_and_its_mapping_is_the_same(session: ShowSession) -> None:
    unseen = session.preview.scene()
    session.receive("ana", SetMapping("one", "2", JAW), 0.0)
    assert list(session.preview.scene()["one"].mappings) == ["smile", "jaw"]
    session.preview.scene()["one"].move_macro("jaw", 0.5)
    assert session.scene["one"].advance(0.0).macros["jaw"].value == 0.0
    assert unseen is not session.preview.scene()


def test_what_there_is_not_is_refused(session: ShowSession) -> None:
    assert "there is no macro 'jaw'" in refusal_of(session, "ana", MoveMacro("one", "jaw", 0.5))
    assert "give a number from -1 to 1" in refusal_of(session, "ana", MoveMacro("one", "smile", 2.0))
    session.receive("ana", SetChannel("one", "jawOpen", 0.5), 0.0)
    wrong = MacroMapping("eyes", (MacroTarget("channel/nowhere"),))
    assert "there is no channel 'nowhere'" in refusal_of(session, "ana", SetMapping("one", "3", wrong))


def test_what_one_of_all_characters_refuses_changes_none(session: ShowSession) -> None:
    session.receive("ana", AddCharacter("2", "two", "Two", "generic"), 0.0)
    session.receive("ana", SetMapping("two", "3", JAW), 0.0)
    before = session.scene["one"].mappings
    assert "smile" in refusal_of(session, "ana", RenameMapping("*", "4", "smile", "grin"))
    assert session.scene["one"].mappings == before
