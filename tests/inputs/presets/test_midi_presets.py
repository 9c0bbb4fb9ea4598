"""Golden packets of MIDI desks: what each sends by its maker's chart plays, and what it is sent lights it."""

from typing import Any

import pytest

from omote.builtin import load_cast
from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.page_devices import PageDevices
from omote.inputs.presets.midi_presets import FACES
from omote.inputs.presets.preset import FEELINGS
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.devices import DeviceBytes, DeviceKind, MidiBytes, Plug
from omote.show.objects.link import Hello
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession


class Plugged:
    """A show of the built-in cast with one device, as it is delivered."""

    def __init__(self, name: str, kind: DeviceKind = "midi") -> None:
        self.session = ShowSession(load_cast())
        self.name = name
        self.now = 0.0
        self.session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
        bindings = BindingInput(Bindings(), lambda: self.session)
        commands = BindingCommands(EditableBindings(), bindings.bindings, {})
        self.devices = PageDevices(lambda: self.session, bindings, commands)
        assert self.devices.receive("a", Plug(name, kind), 0.0) == []
        self.sent = b""
        self.tick(60)  # it shows what is on air by now

    def tick(self, count: int = 2) -> CharacterState:
        for _ in range(count):
            self.now += 1 / 60
            state = self.session.tick(self.now)
            told: list[Any] = [each.message for each in self.devices.tick(state, self.now)]
            self.sent += b"".join(each.data for each in told if isinstance(each, DeviceBytes))
        return state.characters["one"]

    def send(self, *packets: str) -> CharacterState:
        for packet in packets:
            answers = self.devices.receive("a", MidiBytes(self.name, bytes.fromhex(packet)), self.now)
            assert answers == []
        assert self.devices.devices[self.name].health.rejected == 0
        return self.tick()


def test_nanokontrol2() -> None:
    desk = Plugged("nanoKONTROL2")
    assert desk.send("b0 00 00", "b0 00 7f").channels == {"jawOpen": 1.0}
    smiled = desk.send("b0 01 00", "b0 01 40").channels
    assert smiled["mouthSmileLeft"] == smiled["mouthSmileRight"] == pytest.approx(64 / 127)
    assert desk.send("b0 10 3f", "b0 10 41", "b0 10 7f").head[0] == pytest.approx(1.5708, abs=1e-3)
    called = desk.send("b0 21 7f", "b0 21 00").expression_call
    assert called is not None
    assert called.target == FEELINGS[1]
    face = desk.send("b0 46 7f", "b0 46 00").face_call
    assert face is not None
    assert face.target == FACES[6] == "dog"
    assert desk.send("b0 2a 7f").panics == 1


def test_x_touch_mini() -> None:
    desk = Plugged("X-TOUCH MINI")
    assert desk.send("ba 01 00", "ba 01 7f").channels == {"jawOpen": 1.0}
    desk.sent = b""
    desk.tick(60)
    assert bytes.fromhex("b0 09 0d") in desk.sent, "the ring stands at its end"
    called = desk.send("9a 0a 7f", "8a 0a 00").expression_call
    assert called is not None
    assert called.target == FEELINGS[2]
    desk.tick(60)
    assert bytes.fromhex("90 02 01") in desk.sent, "the key of what is on air is lit"
    assert desk.send("ba 09 00", "ba 09 20").face_fader == pytest.approx(32 / 127)


def test_launchpad_mini_mk3() -> None:
    desk = Plugged("Launchpad Mini MK3 LPMiniMK3 MIDI")
    assert desk.sent.startswith(bytes.fromhex("f0 00 20 29 02 0d 0e 01 f7")), "it is brought to programmer mode"
    assert bytes.fromhex("90 51 15") in desk.sent, "neutral is on air: pad 81 is green"
    called = desk.send("90 52 7f", "90 52 00").expression_call
    assert called is not None
    assert called.target == "smile"
    held = desk.send("90 35 7f")
    assert held.channels == {"cheekPuff": 1.0}
    assert desk.send("90 35 00").channels == {}
    desk.send("b0 1d 7f", "b0 1d 00")
    desk.tick(60)
    assert desk.session.tick(desk.now).black == 1.0
    assert bytes.fromhex("b0 1d 03") in desk.sent, "the key above panic is lit while all is black"
    assert desk.send("b0 13 7f").panics == 1
    assert desk.session.tick(desk.now).black == 1.0, "panic brings no light"


def test_two_desks_of_one_kind_have_names_and_bindings_of_their_own() -> None:
    desk = Plugged("nanoKONTROL2")
    desk.devices.receive("a", Plug("nanoKONTROL2 (2)", "midi"), desk.now)
    desk.send("b0 00 00", "b0 00 7f")
    second = MidiBytes("nanoKONTROL2 (2)", bytes.fromhex("b0 00 00"))
    desk.devices.receive("a", second, desk.now)
    assert desk.tick().channels == {"jawOpen": 1.0}, "its fader waits where the other has put the value"
