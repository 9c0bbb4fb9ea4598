"""Pads by messages: through every door, kept with the show, leased whole, on air and in preview, by devices and OSC."""

from __future__ import annotations

from dataclasses import replace

import msgspec
import pytest

from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.osc_feedback import AddressValues, tell_state
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import OscMessage
from omote.inputs.oscquery_tree import build_addresses, find_node
from omote.inputs.reading import Reading
from omote.model.cast import Cast
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.pads.blend_space import PadLook
from omote.perform.scene.scene import Scene
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, Panic
from omote.show.objects.cues import Go, GoBack, GoToCue, PutCue, PutMove, RedoCues, UndoCues
from omote.show.objects.hand.macros import DropMapping, MoveMacro, RestoreMapping, SetMapping
from omote.show.objects.hand.pads import AddCastPads, CopyPad, DropPad, MovePad, PadList, RenamePad, RestorePad, SetPad
from omote.show.objects.leases import SetLeases
from omote.show.objects.link import Bus, Hello, Refused
from omote.show.objects.preview import Take
from omote.show.pad_list import AGAIN_SECONDS
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot
from omote.show.wire import decode, encode

LOOKS = [PadLook("Smile", {"smile": 1.0}, (-1.0, 0.0)), PadLook("Jaw", {"jawOpen": 1.0}, (1.0, 0.0))]
LIPS = SetPad("lips", "lips", "mouth", 2, LOOKS)


@pytest.fixture
def session(cast: Cast) -> ShowSession:
    """Ana and Ben are there, Eve looks at the preview; a pad plays the mouth."""
    session = ShowSession(cast)
    buses: dict[str, Bus] = {"ana": "air", "ben": "air", "eve": "preview"}
    for who, bus in buses.items():
        session.receive(who, Hello("console", PROTOCOL_VERSION, who, f"page of {who}", who, bus=bus), 0.0)
    assert session.receive("ana", decode(encode(LIPS)), 0.0) == []
    return session


def reason(session: ShowSession, who: str, message: object, now: float = 0.0) -> str:
    """Why a message was rejected; "" where it was obeyed."""
    answers = session.receive(who, message, now)  # type: ignore[arg-type]
    return "".join(each.message.reason for each in answers if isinstance(each.message, Refused))


def lists(session: ShowSession, now: float) -> list[tuple[str, PadList]]:
    """What consoles are told of pads."""
    return [(each.who, each.message) for each in session.hands_now(now) if isinstance(each.message, PadList)]


def test_a_point_is_moved_by_anybody_and_told_with_the_state(session: ShowSession) -> None:
    session.tick(0.0)
    assert reason(session, "ben", decode(encode(MovePad("one", "lips", 1.0, 0.0)))) == ""
    state = session.tick(1.0).characters["one"]
    assert state.regions == {"mouth": {"jawOpen": 1.0}}
    assert (state.pads["lips"].place, state.pads["lips"].plays) == ([1.0, 0.0], True)
    assert reason(session, "ben", CallExpression("one", "c", "smile", 0.0)) == ""
    assert not session.tick(2.0).characters["one"].pads["lips"].plays
    assert reason(session, "ben", Panic("one")) == ""
    assert session.tick(3.0).characters["one"].pads == {}


def test_consoles_are_told_the_pads_at_their_welcome_and_when_they_change_and_not_too_often(
    session: ShowSession,
) -> None:
    (_, told), *others = lists(session, 1.0)
    assert [pad.name for pad in told.pads][-1] == "lips"
    assert {who for who, _ in others} == {"ben", "eve"}
    assert lists(session, 1.01) == []
    for step in range(3):
        session.receive("ana", CopyPad(f"c{step}", "lips", f"l{step}"), 1.0)
    assert lists(session, 1.0 + AGAIN_SECONDS / 2.0) == []
    assert [pad.name for pad in lists(session, 1.0 + AGAIN_SECONDS)[0][1].pads][-3:] == ["l0", "l1", "l2"]
    welcome = session.receive("dan", Hello("console", PROTOCOL_VERSION, "dan"), 2.0)
    assert [type(each.message) for each in welcome][-1] is PadList
    assert len(session.receive("wall", Hello("stage", PROTOCOL_VERSION), 2.0)) == 1


def test_a_look_that_the_cast_lacks_is_named(session: ShowSession, cast: Cast) -> None:
    lost = [replace(LOOKS[0], mix={"beam": 1.0}), LOOKS[1]]
    assert reason(session, "ana", replace_looks(LIPS, lost, "again")) == ""
    missing = {pad.name: pad.missing for pad in lists(session, 1.0)[0][1].pads}
    assert missing["lips"] == ["beam"]
    session.recast(cast.with_expressions(beam=cast.expressions["smile"]))
    missing = {pad.name: pad.missing for pad in lists(session, 2.0)[0][1].pads}
    assert missing["lips"] == []


def replace_looks(message: SetPad, looks: list[PadLook], identity: str) -> SetPad:
    return msgspec.structs.replace(message, looks=looks, id=identity)


def test_pads_lie_in_the_show_and_play_on_after_a_restart(session: ShowSession, cast: Cast) -> None:
    session.tick(0.0)
    session.receive("ana", MovePad("one", "lips", 0.5, 0.5), 0.0)
    session.tick(0.1)
    written = msgspec.msgpack.encode(session.snapshot())
    other = ShowSession.restored(cast, msgspec.msgpack.decode(written, type=SessionSnapshot), epoch=2)
    other.tick(0.1)
    for step in range(1, 60):
        assert other.tick(0.1 + step / 60).characters == session.tick(0.1 + step / 60).characters
    assert dict(other.scene.pads) == dict(session.scene.pads)


def test_pads_are_renamed_copied_dropped_and_brought_back(session: ShowSession) -> None:
    first = list(session.scene.pads)
    assert reason(session, "ana", RenamePad("1", "lips", "snout", "k")) == ""
    assert reason(session, "ana", CopyPad("2", "snout", "beak")) == ""
    assert reason(session, "ana", DropPad("3", "mouth")) == ""
    assert [*session.scene.pads] == [*(name for name in first if name not in ("mouth", "lips")), "snout", "beak"]
    assert reason(session, "ana", AddCastPads("4")) == ""
    assert "mouth" in session.scene.pads
    assert reason(session, "ana", RestorePad("5", "k")) == ""
    assert "lips" in session.scene.pads
    assert reason(session, "ana", RestorePad("6", "nothing")).startswith("there is no change of a pad 'nothing'")
    assert reason(session, "ana", SetPad("7", "x", "mouth", 2, LOOKS[:1])).startswith("the pad x has 1 looks")


def test_macros_follow_a_pad_to_its_new_name_and_back_and_one_that_is_gone_is_said(session: ShowSession) -> None:
    def reached() -> list[str]:
        return [target.to for each in session.scene["one"].mappings.values() for target in each.targets]

    wide = MacroMapping("wide", (MacroTarget("pad/lips/x"), MacroTarget("channel/jawOpen")))
    assert reason(session, "ana", SetMapping("one", "m", wide, "m")) == ""
    assert reason(session, "ana", MoveMacro("one", "wide", 0.5)) == ""
    session.tick(0.1)
    before = session.tick(0.5).characters["one"]
    assert before.pads["lips"].plays
    assert reason(session, "ana", RenamePad("r", "lips", "snout", "k")) == ""
    assert reached() == ["pad/snout/x", "channel/jawOpen"]
    after = session.tick(0.6).characters["one"]
    assert (after.pads["snout"], after.regions) == (before.pads["lips"], before.regions)
    assert reason(session, "ana", MoveMacro("one", "wide", 1.0)) == ""
    session.tick(0.7)
    assert session.tick(1.5).characters["one"].pads["snout"].place[0] == 1.0
    assert reason(session, "ana", DropMapping("one", "d", "wide", "d")) == ""
    assert reason(session, "ana", RestorePad("b", "k")) == ""
    assert reason(session, "ana", RestoreMapping("one", "e", "d")) == ""
    assert reached() == ["pad/lips/x", "channel/jawOpen"], "what is taken back has the name of now"
    assert session.take_renamed_pads() == [("lips", "snout"), ("snout", "lips")]
    assert reason(session, "ana", DropPad("x", "lips")) == ""
    assert session.take_lost() == [
        "the pad lips is gone, and these move it, which does nothing now: the macro wide of One."
    ]


def test_what_a_pad_plays_in_preview_goes_on_under_its_new_name(session: ShowSession) -> None:
    other = Scene.restored(session.cast, session.scene.snapshot())
    other.move_pad("one", "lips", 1.0)
    session.scene.rename_pad("lips", "snout")
    other.follow_pads(session.scene)
    assert [*other.advance(0.0).characters["one"].frame.pads] == ["snout"]
    assert other.advance(0.0).characters["one"].frame.pads["snout"].plays


def test_cues_follow_a_pad_to_its_new_name_as_one_edit_and_what_waits_and_stood_too(session: ShowSession) -> None:
    session.tick(0.0)
    for number, x in (("1", -1.0), ("2", 1.0), ("3", 0.0)):
        assert reason(session, "ana", PutCue(f"c{number}", number=number)) == ""
        (*_, cue) = session.cues.book.cues
        goal = {":pad lips": 1.0, ":x": x, ":y": 0.0}
        delay = 1.0 if number == "2" else 0.0
        assert reason(session, "ana", PutMove(f"m{number}", cue, "one/mouth", goal, seconds=0.0, delay=delay)) == ""
    before = session.cues.book

    def calls() -> list[str]:
        moves = [move for cue in session.cues.book.cues.values() for move in cue.moves.values()]
        return [name for move in moves for name in move.goal if name.startswith(":pad")]

    def shown(now: float) -> dict[str, list[float]]:
        return {name: pad.place for name, pad in session.tick(now).characters["one"].pads.items()}

    assert reason(session, "ana", Go("g1"), 1.0) == ""
    shown(2.0)
    assert reason(session, "ana", Go("g2"), 2.0) == ""
    session.cues.locked = True
    assert reason(session, "ben", RenamePad("r", "lips", "snout", "k"), 2.1) == ""
    session.cues.locked = False
    assert calls() == [":pad snout"] * 3
    assert [(edit.what, edit.by) for edit in session.cues.book.edits[len(before.edits) :]] == [
        ("rename the pad lips to snout", "ben")
    ]
    assert shown(2.5) == {"snout": [-1.0, 0.0]}
    assert shown(3.5) == {"snout": [1.0, 0.0]}
    assert reason(session, "ana", GoBack("b"), 4.0) == ""
    assert shown(6.0) == {"snout": [-1.0, 0.0]}
    assert reason(session, "ana", UndoCues("u"), 6.0) == ""
    assert session.cues.book.cues == before.cues
    assert reason(session, "ana", RedoCues("v"), 6.0) == ""
    assert reason(session, "ana", RestorePad("w", "k"), 6.0) == ""
    assert calls() == [":pad lips"] * 3
    assert reason(session, "ana", GoToCue("t", "3"), 7.0) == ""
    assert shown(8.0) == {"lips": [0.0, 0.0]}
    status = session.cues.status(8.0)
    assert status is not None
    assert status.rejected == []
    assert session.take_lost() == []
    assert reason(session, "ana", DropPad("d", "mouth"), 8.0) == ""
    assert session.take_lost() == []
    assert reason(session, "ana", DropPad("e", "lips"), 8.0) == ""
    assert session.take_lost() == [
        "the pad lips is gone, and these move it, which does nothing now: the cue 1 of main, the cue 2 of main, the "
        "cue 3 of main."
    ]


def test_a_pad_needs_the_part_that_it_plays_and_holds_it(session: ShowSession) -> None:
    session.receive("ana", SetLeases("on", True), 0.0)
    assert reason(session, "ana", MovePad("one", "lips", 0.5)) == ""
    assert [*session.leasing.table.held] == ["one/mouth"]
    before = session.scene.snapshot()
    assert reason(session, "ben", MovePad("one", "lips", -0.5)).startswith("ana holds the mouth of one")
    assert reason(session, "ben", MovePad("one", "moods", 0.5)).startswith("ana holds the mouth of one"), "all or none"
    assert session.scene.snapshot() == before
    assert reason(session, "ben", MovePad("one", "nothing", 0.5)).startswith("there is no pad 'nothing'")
    assert reason(session, "ben", SetPad("s", "new", "mouth", 2, LOOKS)) == "", "whoever holds what may make pads"


def test_a_panic_of_another_takes_the_point_out_of_the_hand(session: ShowSession) -> None:
    session.tick(0.0)
    session.receive("ana", MovePad("one", "lips", 1.0), 0.0)
    session.receive("ben", Panic("one"), 0.0)
    assert "panic was pressed at another console" in reason(session, "ana", MovePad("one", "lips", 0.9), 0.1)
    assert reason(session, "ana", MovePad("one", "lips", 0.9), 1.0) == ""


def test_a_point_in_preview_plays_nothing_on_air_until_it_is_taken(session: ShowSession) -> None:
    session.tick(0.0)
    assert reason(session, "eve", MovePad("one", "lips", 1.0)) == ""
    assert session.tick(1.0).characters["one"].regions == {}
    assert session.preview_state is not None
    assert session.preview_state.characters["one"].regions == {"mouth": {"jawOpen": 1.0}}
    assert (
        reason(session, "ana", replace_looks(LIPS, [LOOKS[0], replace(LOOKS[1], mix={"smile": 1.0})], "x"), 1.0) == ""
    )
    session.tick(2.0)
    assert session.preview_state.characters["one"].regions == {"mouth": {"smile": 1.0}}, "pads are of the show"
    assert reason(session, "ana", Take("t", 1.0), 2.0) == ""
    state = session.tick(4.0).characters["one"]
    assert (state.regions, state.pads["lips"].place) == ({"mouth": {"smile": 1.0}}, [1.0, 0.0])


def test_a_surface_moves_a_point_is_told_of_it_and_reads_its_dimensions(session: ShowSession, cast: Cast) -> None:
    reader = OrderReader(cast, {"one": "One"})
    for arguments in ((0.5, -0.25), (0.5,)):
        (order,) = reader.read(OscMessage("/omote/one/pad/lips", arguments), "c")
        assert order == MovePad("one", "lips", *arguments)
        assert reason(session, "ana", order) == ""
    told = tell_state(session.tick(0.1))
    assert told["/omote/one/pad/lips"] == (0.5, -0.25)
    assert "no z" in reason(session, "ana", MovePad("one", "lips", 0.0, 0.0, 0.0))
    dimensions = {name: pad.dimensions for name, pad in session.scene.pads.items()}
    node = find_node(build_addresses(cast, ["one"], dimensions), "/omote/one/pad/lips")
    assert node is not None
    assert (node["TYPE"], node["RANGE"]) == ("ff", [{"MIN": -1.0, "MAX": 1.0}] * 2)


def test_two_dials_move_the_two_numbers_of_a_point(session: ShowSession, cast: Cast) -> None:
    bindings = Bindings(
        [
            Binding("box", control, read_target("/omote/one/pad/lips", (), axis), -1.0, 1.0, pick_up=False)
            for control, axis in (("1/cc1", "x"), ("1/cc2", "y"))
        ]
    )
    reader = OrderReader(cast, {"one": "One"})
    for number, (control, value) in enumerate((("1/cc1", 1.0), ("1/cc2", 0.0), ("1/cc1", 0.75))):
        state = session.tick(0.1 * number)
        for message in bindings.hear(Reading("box", control, value), AddressValues(state), state.number):
            for order in reader.read(message, f"c{number}"):
                assert reason(session, "ana", order) == ""
    assert session.tick(1.0).characters["one"].pads["lips"].place == [0.5, -1.0]
