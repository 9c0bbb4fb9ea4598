"""Bindings at a session: a device plays as a console does, and consoles see its name."""

import math

import pytest

from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.midi_stream import MidiDecoder
from omote.inputs.reading import Reading
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import Panic
from omote.show.objects.faders import Hands
from omote.show.objects.link import Hello
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession
from tests import synthetic

PAD = "nanoKONTROL2"


@pytest.fixture
def session() -> ShowSession:
    return ShowSession(synthetic.cast())


def bound(session: ShowSession, *bindings: Binding) -> BindingInput:
    made = BindingInput(Bindings(bindings), lambda: session)
    made.note_state(session.tick(0.0))
    return made


def test_a_dial_a_button_and_a_head_play(session: ShowSession) -> None:
    session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
    devices = bound(
        session,
        Binding(PAD, "1/cc1", read_target("/omote/one/channel/jawOpen")),
        Binding(PAD, "1/note36", read_target("/omote/one/face", ["broad", 0.0])),
        Binding(PAD, "1/cc2", read_target("/omote/one/head", axis="yaw"), -90.0, 90.0, pick_up=False),
    )
    devices.hear(MidiDecoder(PAD).feed(bytes.fromhex("b0 01 00 01 40 02 7f 90 24 50")), 0.1)
    state = session.tick(0.2)
    assert state.characters["one"].channels == {"jawOpen": pytest.approx(64 / 127)}
    assert state.characters["one"].head[0] == pytest.approx(math.pi / 2)
    assert state.characters["one"].faces == {"broad": 1.0}
    (hands,) = session.hands_now(0.2)
    assert isinstance(hands.message, Hands)
    assert set(hands.message.hands.values()) == {PAD}


def test_what_the_show_rejects_is_counted_with_the_device(session: ShowSession) -> None:
    devices = bound(session, Binding(PAD, "1/note36", read_target("/omote/one/face", ["nobody"])))
    devices.hear([Reading(PAD, "1/note36", 1.0, key=True)], 0.1)
    assert devices.osc.rejected == 1
    assert devices.osc.last_rejection is not None
    assert devices.osc.last_rejection.sender == PAD


def test_a_device_that_is_unplugged_lets_go_and_leaves(session: ShowSession) -> None:
    devices = bound(session, Binding(PAD, "1/note36", read_target("/omote/one/channel/jawOpen"), button="momentary"))
    devices.hear([Reading(PAD, "1/note36", 1.0, key=True)], 0.1)
    assert session.tick(0.2).characters["one"].channels == {"jawOpen": 1.0}
    devices.unplug(PAD, 0.3)
    assert session.tick(0.4).characters["one"].channels == {}
    assert session.crew == {}


@pytest.mark.parametrize("pick_up", [False, True])
@pytest.mark.parametrize("character", ["one", "*"])
@pytest.mark.parametrize("target", ["pad/moods", "macro/wide", "channel/jawOpen"])
def test_what_is_held_while_panic_is_pressed_waits_until_it_is_back_at_rest(
    session: ShowSession, target: str, character: str, *, pick_up: bool
) -> None:
    session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
    session.scene["one"].set_mapping(MacroMapping("wide", (MacroTarget("channel/jawOpen"),)))
    axis = "x" if target.startswith("pad") else None
    low = 0.0 if target.startswith("channel") else -1.0
    rest = -low / (1.0 - low)
    path = f"/omote/{character}/{target}"
    devices = bound(session, Binding(PAD, "x", read_target(path, axis=axis), low, 1.0, pick_up=pick_up))

    def moved(*positions: float, now: float) -> CharacterState:
        for position in positions:
            devices.hear([Reading(PAD, "x", position)], now)
        state = session.tick(now)
        devices.note_state(state)
        return state.characters["one"]

    held = moved(rest, 1.0, now=0.1)
    session.receive("a", Panic(character), 0.2)
    rested = moved(now=2.0)
    assert (rested.pads, rested.macros, rested.channels) != (held.pads, held.macros, held.channels)
    jitters = moved(0.95, 1.0, 0.6, now=2.1)
    assert (jitters.pads, jitters.macros, jitters.channels) == (rested.pads, rested.macros, rested.channels)
    assert devices.bindings.waiting == {(PAD, "x"): 0.6}
    assert devices.bindings.crossings(PAD, devices.on_air) == {"x": rest}
    again = moved(rest, 1.0, now=2.2)
    assert (again.pads, again.macros) == (held.pads, held.macros)
    assert devices.bindings.waiting == {}
