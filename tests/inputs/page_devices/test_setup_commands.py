"""Set-ups: mappings and bindings changed in one press, without a jump, taken back whole, and kept with the show."""

from __future__ import annotations

from itertools import pairwise

import pytest

from omote.inputs.page_devices.setup_commands import SetupCommands
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.pads.blend_space import PadLook
from omote.show.objects.bindings import Bind, BindingDocument, BindingList, RestoreBindings, Unbind
from omote.show.objects.devices import MidiBytes, Plug
from omote.show.objects.hand.macros import DropMapping, MoveMacro, SetMapping
from omote.show.objects.hand.pads import DropPad, RenamePad, RestorePad, SetPad
from omote.show.objects.hand.setups import CallSetup, DropSetup, KeepSetup, RestoreSetup, SetupChanged, SetupList
from omote.show.objects.link import Refused
from tests.inputs.page_devices.device_room import Room

PAD = "my pad"
SMILE = MacroMapping("smile", (MacroTarget("channel/jawOpen", high=0.5),))
JAW = MacroMapping("jaw", (MacroTarget("channel/jawOpen", high=0.8),))


def bound(control: str, macro: str) -> BindingDocument:
    return BindingDocument(PAD, control, f"/omote/one/macro/{macro}", low=0.0, high=1.0)


def dial(room: Room, control: int, value: int) -> None:
    room.say("a", MidiBytes(PAD, bytes([0xB0, control, value])))


@pytest.fixture(name="room")
def _room() -> Room:
    """One set-up, `right`, has been kept, and another, without a name yet, plays: the dial 7 plays the jaw."""
    room = Room()
    room.say("a", Plug(PAD, "midi"))
    room.session.receive("a", SetMapping("one", "m1", SMILE), room.now)
    room.say("a", Bind("b1", bound("1/cc7", "smile")))
    assert room.say("a", KeepSetup("k1", "right")) == [SetupChanged("k1", "right")]
    room.session.receive("a", DropMapping("one", "m2", "smile"), room.now)
    room.session.receive("a", SetMapping("one", "m3", JAW), room.now)
    room.say("a", Bind("b2", bound("1/cc7", "jaw"), bound("1/cc7", "smile")))
    return room


def test_one_press_changes_mappings_and_bindings_and_nothing_jumps(room: Room) -> None:
    dial(room, 7, 0)
    dial(room, 7, 127)
    assert room.jaw == 0.8
    room.say("a", CallSetup("c1", "right"))
    assert list(room.session.scene["one"].mappings) == ["smile"]
    assert [each.target.path for each in room.playing.bindings.bindings] == ["/omote/one/macro/smile"]
    shown = [0.8, room.jaw]
    for _ in range(60):
        room.tick()
        shown.append(room.jaw)
    assert max(abs(after - before) for before, after in pairwise(shown)) < 0.15
    assert shown[-1] == 0.0
    dial(room, 7, 100)
    dial(room, 7, 90)
    assert room.jaw == 0.0, "the dial waits to be picked up"
    dial(room, 7, 0)
    dial(room, 7, 127)
    assert room.jaw == 0.5


def test_it_is_taken_back_whole_and_that_too(room: Room) -> None:
    before = room.session.scene["one"].mappings, room.playing.bindings.bindings
    room.say("a", CallSetup("c1", "right"))
    after = room.session.scene["one"].mappings, room.playing.bindings.bindings
    room.say("b", RestoreSetup("r1", "c1"))
    assert (room.session.scene["one"].mappings, room.playing.bindings.bindings) == before
    room.say("b", RestoreSetup("r2", "r1"))
    assert (room.session.scene["one"].mappings, room.playing.bindings.bindings) == after


def test_a_macro_that_both_have_stays_where_it_is(room: Room) -> None:
    room.session.receive("a", SetMapping("one", "m4", SMILE), room.now)
    room.session.receive("a", MoveMacro("one", "smile", 0.5), room.now)
    room.tick()
    room.say("a", CallSetup("c1", "right"))
    room.tick()
    assert room.session.scene["one"].advance(0.0).macros["smile"].value == 0.5


def test_the_show_file_keeps_them_and_consoles_hear_of_them(room: Room) -> None:
    told = room.told(SetupList, room.tick())
    assert told == {"a": SetupList(["right"]), "b": SetupList(["right"])}
    room.say("a", CallSetup("c1", "right"))
    assert room.told(SetupList, room.tick())["b"] == SetupList(["right"], "right")
    room.session.receive("a", SetMapping("one", "m5", JAW), room.now)
    news = room.tick()
    assert room.told(SetupList, news)["b"] == SetupList(["right"])
    assert room.told(BindingList, news) == {}
    body = room.kept_setups["right"]
    assert body is not None
    again = SetupCommands(lambda: room.session, room.commands, {"right": body, "wrong": b"{"})
    assert again.list_now() == SetupList(["right"])
    assert "the set-up wrong in the show file cannot be read" in again.unreadable[0]
    room.say("a", DropSetup("d1", "right"))
    assert room.kept_setups["right"] is None
    room.say("a", RestoreSetup("r1", "d1"))
    assert room.kept_setups["right"] == body


def test_who_is_not_there_is_named_and_what_there_is_not_is_refused(room: Room) -> None:
    room.session.scene.add("two")
    room.session.receive("a", SetMapping("two", "m6", JAW), room.now)
    room.say("a", KeepSetup("k2", "both"))
    room.session.scene.remove("two", seconds=0.0)
    room.tick()
    assert room.say("a", CallSetup("c1", "both")) == [SetupChanged("c1", "both", ["two"])]
    (refused,) = room.say("a", RestoreSetup("r9", "x"))
    assert isinstance(refused, Refused)
    assert "long ago" in refused.reason
    for message in (CallSetup("c2", "left"), DropSetup("d2", "left")):
        (answer,) = room.session.receive("a", message, room.now)
        assert isinstance(answer.message, Refused)
        assert "there is no set-up 'left' in this show" in answer.message.reason


def test_bindings_and_set_ups_follow_a_pad_to_its_new_name_while_a_control_is_held(room: Room) -> None:
    looks = [PadLook("Rest", {"neutral": 1.0}, (-1.0,)), PadLook("Jaw", {"jawOpen": 1.0}, (1.0,))]
    session = room.session
    session.receive("a", SetPad("p1", "lips", "mouth", 1, looks), room.now)
    stick = BindingDocument(PAD, "1/cc8", "/omote/one/pad/lips", "x", low=-1.0, high=1.0, pick_up=False)
    room.say("a", Bind("b3", stick))
    room.say("a", KeepSetup("k3", "pads"))
    room.say("a", Unbind("u1", stick))
    room.say("a", RestoreBindings("r0", "u1"))

    def addresses() -> list[str]:
        return [each.target.path for each in room.playing.bindings.bindings if each.target.pad]

    dial(room, 8, 127)
    session.receive("a", RenamePad("p2", "lips", "snout", "k"), room.now)
    told = room.told(BindingList, room.tick())["b"]
    assert addresses() == ["/omote/one/pad/snout"]
    assert [each for each in told.missing if each] == []
    dial(room, 8, 0)
    room.tick()
    assert session.tick(room.now).characters["one"].pads["snout"].place == [-1.0], "who holds it plays on"
    assert b"/pad/snout" in (room.kept_setups["pads"] or b"")
    room.say("a", CallSetup("c5", "pads"))
    assert addresses() == ["/omote/one/pad/snout"]
    room.say("a", RestoreBindings("r1", "u1"))
    session.receive("a", RestorePad("p3", "k"), room.now)
    room.tick()
    assert addresses() == ["/omote/one/pad/lips"]

    session.receive("a", DropPad("p4", "lips"), room.now)
    told = room.told(BindingList, room.tick())["b"]
    assert [each.split(";")[0] for each in told.missing if each] == ["there is no pad 'lips'"]
    assert session.take_lost() == ["the pad lips is gone, and these move it, which does nothing now: 1/cc8 of my pad."]
