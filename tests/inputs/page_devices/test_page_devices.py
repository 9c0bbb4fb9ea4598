"""Devices at pages: plugged in, played, told; whatever they send, the show goes on."""

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.inputs.bindings.binding_document import decode_stored
from omote.inputs.page_devices.page_devices import MOST_DEVICES, TOLD_TICKS
from omote.inputs.reading import Reading
from omote.show.declaration import Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.bindings import (
    Bind,
    BindingDocument,
    BindingList,
    BindingsChanged,
    ChooseBank,
    Learn,
    LoadPreset,
    RestoreBindings,
    Unbind,
)
from omote.show.objects.characters import AddCharacter
from omote.show.objects.cues import PutCue
from omote.show.objects.devices import Controls, DeviceBytes, Devices, InputLog, MidiBytes, Plug, Unplug, WatchDevices
from omote.show.objects.faders import SetChannel
from omote.show.objects.leases import ReleaseLease, SetLeases
from omote.show.objects.link import Hello, Refused
from tests.inputs.page_devices.device_room import Room

JAW = "/omote/one/channel/jawOpen"
PAD = "my pad"


@pytest.fixture
def room() -> Room:
    return Room()


def binding(control: str = "1/cc7", **more: Any) -> BindingDocument:
    return BindingDocument(PAD, control, JAW, pick_up=False, **more)


def midi(text: str, device: str = PAD) -> MidiBytes:
    return MidiBytes(device, bytes.fromhex(text))


def test_what_is_bound_is_played_in_the_same_tick(room: Room) -> None:
    room.say("a", Plug(PAD, "midi"))
    (changed,) = room.say("a", Bind("b1", binding()))
    assert isinstance(changed, BindingsChanged)
    assert [each.control for each in changed.added] == ["1/cc7"]
    assert room.say("a", midi("b0 07 7f")) == []
    assert room.jaw == 1.0


def test_all_consoles_are_told_of_bindings_and_the_show_file_keeps_them(room: Room) -> None:
    room.say("a", Bind("b1", binding()))
    lists = room.told(BindingList, room.tick())
    assert set(lists) == {"a", "b"}
    (told,) = lists["b"].bindings
    assert (told.control, told.to, told.low, told.high) == ("1/cc7", JAW, 0.0, 1.0)
    stored, _, wrong = decode_stored(room.kept[-1])
    assert (stored, wrong) == (list(room.commands.editable.own), [])
    assert room.told(BindingList, room.tick(TOLD_TICKS)) == {}


def test_a_change_is_taken_back_and_that_too(room: Room) -> None:
    room.say("a", Bind("b1", binding()))
    room.say("a", Bind("b2", binding(high=0.5)))
    assert [each.high for each in room.commands.editable.own] == [0.5]
    room.say("a", RestoreBindings("r1", "b2"))
    assert [each.high for each in room.commands.editable.own] == [1.0]
    room.say("a", RestoreBindings("r2", "r1"))
    assert [each.high for each in room.commands.editable.own] == [0.5]
    room.say("b", Unbind("u1", binding(high=0.5)))
    assert not room.commands.editable.own
    room.say("b", RestoreBindings("r3", "u1"))
    assert [each.high for each in room.commands.editable.own] == [0.5]


def test_an_id_executes_once(room: Room) -> None:
    assert len(room.say("a", Bind("b1", binding()))) == 1
    assert room.say("a", Bind("b1", binding(high=0.25))) == []


def test_a_device_belongs_to_one_page_until_its_link_ends(room: Room) -> None:
    room.say("a", Plug(PAD, "midi"))
    (refused,) = room.say("b", Plug(PAD, "midi", id="p1"))
    assert isinstance(refused, Refused)
    assert (refused.id, "Ana" in refused.reason) == ("p1", True)
    (refused,) = room.say("b", midi("b0 07 7f"))
    assert "is not plugged in at this page" in refused.reason
    room.session.leave("a")
    devices = room.told(Devices, room.tick())["b"]
    assert [(each.name, each.plugged) for each in devices.devices] == [(PAD, False)]
    assert room.say("b", Plug(PAD, "midi")) == []


def test_a_key_that_is_held_is_let_go_when_its_page_goes(room: Room) -> None:
    room.say("a", Plug(PAD, "gamepad"))
    room.say("a", Bind("b1", binding("button4", button="momentary")))
    room.say("a", Controls(PAD, {"button4": 1.0}))
    assert room.jaw == 1.0
    room.session.leave("a")
    room.tick()
    assert room.jaw == 0.0


def test_a_stick_plays_when_it_is_moved_alone_and_rests_in_its_middle(room: Room) -> None:
    room.say("a", Plug(PAD, "gamepad"))
    room.say("a", Bind("b1", BindingDocument(PAD, "axis0", "/omote/one/head", "yaw", pick_up=False)))
    for value in (0.5, 0.53, 0.47):
        room.say("a", Controls(PAD, {"axis0": value}))
    assert room.session.tick(room.now).characters["one"].head[0] == 0.0
    heard = room.playing.osc.heard
    room.say("a", Controls(PAD, {"axis0": 0.5}))
    assert room.playing.osc.heard == heard
    room.say("a", Controls(PAD, {"axis0": 1.0}))
    assert room.session.tick(room.now).characters["one"].head[0] == pytest.approx(3.14159 / 2, abs=1e-4)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -0.01, 1.01])
def test_a_control_that_stands_nowhere_is_rejected_and_logged(room: Room, value: float) -> None:
    room.say("a", Plug(PAD, "gamepad"))
    (refused,) = room.say("a", Controls(PAD, {"axis0": value}))
    assert "give 0 to 1" in refused.reason
    assert room.devices.devices[PAD].health.rejected == 1
    assert [line.rejected for line in room.devices.log.lines][-1]


def test_learn_binds_what_moves_next_and_tells_who_asked(room: Room) -> None:
    room.say("b", Plug(PAD, "midi"))
    assert room.say("a", Learn("l1", JAW)) == []
    (told,) = {id(each): each for each in room.told(BindingList, room.tick()).values()}.values()
    assert (told.learning.who, told.learning.to) == ("Ana", JAW)
    found: list[Outgoing] = []
    for n in range(10, 60, 5):
        found += room.devices.receive("b", midi(f"b0 07 {n:02x}"), room.now)
    (learned,) = found
    assert learned.who == "a"
    assert isinstance(learned.message, BindingsChanged)
    assert [(each.control, each.pick_up) for each in learned.message.added] == [("1/cc7", True)]
    assert room.commands.list_now().learning is None
    room.say("a", RestoreBindings("r1", "l1"))
    assert not room.commands.editable.own


def test_what_is_moved_to_be_learned_plays_nothing(room: Room) -> None:
    name = "Xbox 360 Controller (STANDARD GAMEPAD Vendor: 045e)"
    room.say("a", Plug(name, "gamepad"))
    room.say("a", Controls(name, {"trigger7": 0.25}))
    assert room.jaw == 0.25
    room.say("a", Learn("l1", "/omote/one/channel/smile"))
    room.say("a", Controls(name, {"trigger7": 0.5}))
    assert room.jaw == 0.25
    room.say("a", Learn("l2", ""))
    room.say("a", Controls(name, {"trigger7": 0.75}))
    assert room.jaw == 0.75


def test_learning_is_stopped_or_ends_by_itself(room: Room) -> None:
    room.say("a", Learn("l1", JAW))
    room.say("a", Learn("l2", ""))
    assert room.commands.learner is None
    room.say("a", Learn("l3", JAW))
    room.now += 31.0
    room.tick()
    assert room.commands.learner is None
    (refused,) = room.say("a", Learn("l4", "/omote/one/nose"))
    assert "near are" in refused.reason


def test_a_known_device_plays_as_soon_as_it_is_plugged_in_and_what_was_unbound_stays_so(room: Room) -> None:
    room.say("a", Plug("Xbox 360 Controller (STANDARD GAMEPAD Vendor: 045e)", "gamepad"))
    name = "Xbox 360 Controller (STANDARD GAMEPAD Vendor: 045e)"
    room.say("a", Controls(name, {"trigger7": 0.75}))
    assert room.jaw == 0.75
    assert room.devices.devices_now(0.0).devices[-1].preset == "xbox"
    for n, each in enumerate(room.commands.list_now().bindings):
        room.say("a", Unbind(f"u{n}", each))
    room.say("a", Unplug(name))
    room.say("a", Plug(name, "gamepad"))
    assert not room.commands.editable.own
    (changed,) = room.say("a", LoadPreset("p1", name, "xbox", "one"))
    assert {each.to.split("/")[2] for each in changed.added} == {"one", "panic"}
    (refused,) = room.say("a", LoadPreset("p2", name, "theremin"))
    assert "there is no preset" in refused.reason


def test_a_motor_fader_is_sent_what_is_on_air_but_not_while_it_is_touched(room: Room) -> None:
    room.say("a", Plug(PAD, "midi"))
    room.say("a", Bind("b1", binding("1/bend")))

    def set_jaw(value: float) -> list[bytes]:
        room.session.receive("b", SetChannel("one", "jawOpen", value), room.now)
        sent = room.told(DeviceBytes, room.tick(2))
        return [each.data for who, each in sent.items() if who == "a"]

    assert set_jaw(1.0) == [bytes.fromhex("e0 7f 7f")]
    assert set_jaw(1.0) == []
    room.say("a", midi("90 68 7f e0 00 40"))
    assert room.jaw == pytest.approx(0.5, abs=1e-3)
    assert set_jaw(0.0) == []
    room.say("a", midi("90 68 00"))
    room.tick(60)
    assert set_jaw(0.25) != []


def test_a_fader_that_comes_back_where_it_was_sent_acts_with_its_next_step(room: Room) -> None:
    room.session.receive("b", SetChannel("one", "jawOpen", 1.0), room.now)
    room.say("a", Bind("b1", BindingDocument(PAD, "1/cc7", JAW)))
    room.tick()
    room.say("a", Plug(PAD, "midi"))
    assert room.told(DeviceBytes, room.tick(2))["a"].data == bytes.fromhex("b0 07 7f")
    heard = room.playing.osc.heard
    room.say("a", midi("b0 07 7f"))
    assert room.playing.osc.heard == heard, "what comes back of what was sent plays nothing"
    room.say("a", midi("b0 07 40"))
    assert room.jaw == pytest.approx(64 / 127)


def test_a_device_plays_for_the_seat_of_its_page(room: Room) -> None:
    room.session.receive("c", Hello("console", PROTOCOL_VERSION, "Cleo", seat="cleo's seat"), room.now)
    room.say("c", Plug(PAD, "midi"))
    room.say("c", Bind("b1", binding()))
    room.say("c", midi("b0 07 7f"))
    assert room.session.crew[f"device {PAD}"].seat == room.session.crew["c"].seat
    room.say("c", Unplug(PAD))
    room.say("a", Plug(PAD, "midi"))
    room.say("a", midi("b0 07 00"))
    assert room.session.crew[f"device {PAD}"].seat == room.session.crew["a"].seat


def test_banks_are_of_a_device(room: Room) -> None:
    room.say("a", Plug(PAD, "midi"))
    room.say("a", Bind("b1", binding(bank="B")))
    room.say("a", midi("b0 07 7f"))
    assert room.jaw == 0.0
    room.say("b", ChooseBank(PAD, "B"))
    room.say("a", midi("b0 07 7e"))
    assert room.jaw > 0.9
    state = room.devices.devices_now(0.0).devices[-1]
    assert (state.bank, state.banks) == ("B", ["B"])


def test_pages_that_watch_hear_of_values_and_the_log(room: Room) -> None:
    room.say("a", Plug(PAD, "midi"))
    room.say("b", WatchDevices(on=True))
    room.say("a", midi("b0 07 7f"))
    told = room.tick(6)
    devices = room.told(Devices, told)["b"].devices
    assert devices[-1].values == {"1/cc7": 1.0}
    lines = room.told(InputLog, told)["b"].lines
    assert [line.text for line in lines] == ["plugged in at Ana", "1/cc7 1.000"]
    assert set(room.told(InputLog, told)) == {"b"}


def test_too_many_devices_are_rejected_with_a_reason(room: Room) -> None:
    for n in range(MOST_DEVICES):
        assert room.say("a", Plug(f"pad {n}", "midi")) == []
    (refused,) = room.say("a", Plug("one more", "midi"))
    assert f"{MOST_DEVICES} devices" in refused.reason
    room.say("a", Unplug("pad 3"))
    assert room.say("a", Plug("one more", "midi")) == []
    (refused,) = room.say("a", Plug("sACN", "midi"))
    assert "another source" in refused.reason


def test_a_stage_has_no_devices(room: Room) -> None:
    room.session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    (answer,) = room.session.receive("s", Plug(PAD, "midi"), 0.0)
    assert isinstance(answer.message, Refused)
    assert room.session.take_device_messages() == []


def test_a_button_of_a_gamepad_presses_go_and_another_calls_a_cue(room: Room) -> None:
    for number in ("1", "2", "7"):
        room.session.receive("a", PutCue(f"p{number}", number=number), room.now)
    room.say("a", Plug("Xbox pad", "gamepad"))
    room.say("a", Bind("b1", BindingDocument("Xbox pad", "button0", "/omote/go")))
    room.say("a", Bind("b2", BindingDocument("Xbox pad", "button1", "/omote/go", arguments=["7"])))
    called = []
    for values in ({"button0": 1.0}, {"button0": 0.0}, {"button0": 1.0}, {"button1": 1.0}):
        room.now += 1.0
        room.say("a", Controls("Xbox pad", values))
        room.tick()
        status = room.session.cues.status(room.now)
        assert status is not None
        called.append(status.lists["main"].current.number)  # type: ignore[union-attr]
    assert called == ["1", "1", "2", "7"]


CONTROLS = st.binary(max_size=9).map(lambda data: b"\xf0\x7f\x7f\x02" + bytes(byte & 0x7F for byte in data) + b"\xf7")


def test_a_desk_plays_the_list_by_midi_show_control(room: Room) -> None:
    """Real bytes of GO with and without a number, STOP, RESUME, LOAD; of what is for others nothing is played."""
    for number in ("1", "2", "12.5"):
        room.session.receive("a", PutCue(f"p{number}", number=number), room.now)
    room.say("a", Plug("Desk", "midi"))

    def sends(text: str) -> tuple[str | None, str | None, float]:
        room.now += 1.0
        room.say("a", MidiBytes("Desk", bytes.fromhex(text)))
        room.tick()
        status = room.session.cues.status(room.now)
        assert status is not None
        way = status.lists["main"]
        numbers = [None if cue is None else cue.number for cue in (way.current, way.standby)]
        return numbers[0], numbers[1], status.rate

    assert sends("F0 7F 7F 02 01 01 F7")[:2] == ("1", "2")
    assert sends("F0 7F 05 02 01 01 F7")[:2] == ("1", "2")  # for the device 5
    assert sends("F0 7F 7F 02 60 01 F7")[:2] == ("1", "2")  # fireworks
    assert sends("F0 7F 00 02 01 01 31 32 2E 35 00 31 F7")[:2] == ("12.5", None)  # of the first list
    assert sends("F0 7F 7F 02 01 01 31 32 2E 35 F7")[:2] == ("12.5", None)  # it is current: nothing is called twice
    assert sends("F0 7F 7F 02 01 05 32 F7")[:2] == ("12.5", "2")
    assert sends("F0 7F 7F 02 01 02 F7")[2] < 1.0
    assert sends("F0 7F 7F 02 01 03 F7")[2] == 1.0
    assert room.session.cues.status(room.now).lists["main"].by == "Desk"  # type: ignore[union-attr]
    rejected = room.devices.devices["Desk"].health.rejected
    assert sends("F0 7F 7F 02 01 01 39 39 F7")[0] == "12.5"  # there is no cue 99
    assert room.devices.devices["Desk"].health.rejected == rejected + 1
    assert "there is no cue of this list '99'" in room.devices.log.lines[-1].text


@settings(max_examples=60, deadline=None)
@given(st.lists(st.one_of(CONTROLS, st.binary(max_size=12), st.lists(st.floats(), max_size=3)), max_size=8))
def test_whatever_comes_no_state_is_spoiled(sent: list[bytes | list[float]]) -> None:
    room = Room()
    room.say("a", Plug("nanoKONTROL2", "midi"))
    room.say("a", Plug("Xbox pad", "gamepad"))
    room.session.receive("a", PutCue("p1"), 0.0)
    room.say("a", Learn("l1", JAW))
    for n, each in enumerate(sent):
        if isinstance(each, bytes):
            room.devices.receive("a", MidiBytes("nanoKONTROL2", each), room.now)
        else:
            values = {f"axis{axis}": value for axis, value in enumerate(each)}
            room.devices.receive("a", Controls("Xbox pad", values), room.now)
        room.tick(n % 3 + 1)
    (character,) = room.session.tick(room.now).characters.values()
    numbers = [*character.channels.values(), *character.head, *character.gaze]
    assert all(-2.0 < number < 2.0 for number in numbers)


def test_a_device_plays_for_the_seat_of_its_page_wherever_it_is_plugged_in(room: Room) -> None:
    room.say("a", Bind("b1", binding()))
    room.session.receive("a", SetLeases("on", True), room.now)
    for who in "ab":
        room.say(who, Plug(PAD, "midi"))
        room.say(who, MidiBytes(PAD, bytes([0xB0, 7, 64])))
        table = room.session.leasing.table
        assert table.held == {"one/channels": room.session.crew[who].seat}
        room.session.receive(who, ReleaseLease(f"release {who}", "*", "*"), room.now)
        room.say(who, Unplug(PAD))


def test_a_preset_that_loads_by_itself_is_said_at_every_console_and_can_be_taken_back_where_it_is(room: Room) -> None:
    name = "nanoKONTROL2"
    assert room.say("a", Plug(name, "midi")) == []
    told = room.told(BindingsChanged, room.tick())
    assert {who: (each.preset, each.here) for who, each in told.items()} == {
        "a": ("Korg nanoKONTROL2", True),
        "b": ("Korg nanoKONTROL2", False),
    }
    assert told["a"].added == room.commands.list_now().bindings
    assert any("plays as Korg nanoKONTROL2" in line.text for line in room.devices.log.lines)
    assert room.told(BindingsChanged, room.tick(5)) == {}, "once"
    room.say("a", RestoreBindings("back", told["a"].id))
    assert room.commands.list_now().bindings == []
    room.say("a", Unplug(name))
    room.say("a", Plug(name, "midi"))
    assert room.told(BindingsChanged, room.tick()) == {}, "what was taken away does not come back"


def test_a_binding_whose_character_has_gone_is_marked_with_the_reason_until_it_is_back(room: Room) -> None:
    room.say("a", Plug(PAD, "midi"))
    path = "/omote/two/channel/jawOpen"
    room.say("a", Bind("b1", BindingDocument(PAD, "1/cc7", path, pick_up=False)))
    room.say("a", Bind("b2", binding("1/cc8")))
    told = room.told(BindingList, room.tick())["b"]
    assert told.missing == ["there is no character 'two' in this scene, which has one, and * for all", ""]
    room.session.receive("a", AddCharacter("n", "two", "Two", "generic"), room.now)
    told = room.told(BindingList, room.tick())["b"]
    assert told.missing == ["", ""]
    room.say("a", midi("b0 07 7f"))
    assert room.session.tick(room.now).characters["two"].channels == {"jawOpen": 1.0}


def test_a_hand_by_osc_is_a_device_that_is_learned_and_goes_when_it_is_silent() -> None:
    room = Room()
    hand = "Hand one right"

    def move(**axes: float) -> list[Any]:
        readings = [("10.0.0.9", Reading(hand, axis, value)) for axis, value in axes.items()]
        return [each.message for each in room.devices.play_hands(readings, room.now)]

    def jaw() -> float:
        return room.session.tick(room.now).characters["one"].channels.get("jawOpen", 0.0)

    move(opening=0.9, curl1=0.5)
    room.say("a", Learn("l1", JAW, "", []))
    learned: list[Any] = []
    for step in range(8):
        learned += move(opening=0.1 * step, curl1=0.5 + 0.01 * step)
    ((binding,),) = [each.added for each in learned if isinstance(each, BindingsChanged)]
    assert (binding.device, binding.control, binding.pick_up) == (hand, "opening", False)
    move(opening=0.25)
    room.now += 1.0
    assert jaw() == pytest.approx(0.25, abs=1e-3)
    states = {each.name: each for each in room.devices.devices_now(room.now).devices}
    assert (states[hand].kind, states[hand].where, states[hand].plugged) == ("osc", "OSC 10.0.0.9", True)
    room.now += 5.0
    room.tick()
    assert not {each.name: each for each in room.devices.devices_now(room.now).devices}[hand].plugged
    move(opening=0.8)
    room.now += 1.0
    assert jaw() == pytest.approx(0.8, abs=1e-3)
