"""What cues send, over real sockets: it arrives as it was written, and who is not there is told once."""

import asyncio
import socket
from collections.abc import Callable
from functools import partial

import pytest

from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.osc_packet import OscMessage, decode_packet
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.page_devices import PageDevices
from omote.perform.cues.cue_action import CueAction
from omote.server.devices.cue_sender import CueSender
from omote.server.devices.page_device_source import PageDeviceSource
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.cues import Go, PutCue
from omote.show.objects.devices import DeviceBytes, Plug
from omote.show.objects.link import Hello
from omote.show.wire import decode_answer
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"


class Sender:
    """A show whose list has one cue, and what it sends."""

    def __init__(self, harness: ShowHarness, *actions: CueAction) -> None:
        self.harness = harness
        session = harness.show.session
        session.receive("ana", Hello("console", PROTOCOL_VERSION), 0.0)
        self.said: list[str] = []
        self.sent: list[tuple[str, bytes]] = []
        playing = BindingInput(Bindings(), lambda: session)
        commands = BindingCommands(EditableBindings(), playing.bindings, {})
        self.devices = PageDevices(lambda: session, playing, commands)
        send: Callable[[str, bytes], None] = lambda who, data: self.sent.append((who, data))  # noqa: E731
        self.sender = CueSender(lambda: session, self.devices, send, self.said.append)
        harness.show.sources += [PageDeviceSource(self.devices, lambda: session, send), self.sender]
        assert session.receive("ana", PutCue("put", actions=[*actions]), 0.0) == []

    def go(self, call: str) -> None:
        """GO, from the top of the list, and a tick."""
        session = self.harness.show.session
        session.cues._players["main"].set_standby("1")
        self.harness.clock.now += 1.0
        assert session.receive("ana", Go(call), self.harness.clock.now) == []
        self.harness.tick()

    async def until(self, is_so: Callable[[], bool]) -> None:
        """Lets sockets be heard until something is so."""
        while not is_so():
            await asyncio.sleep(0)


async def test_a_message_of_osc_arrives_as_it_was_written(show_harness: ShowHarness) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind((HOST, 0))
        receiver.setblocking(False)
        to = f"localhost:{receiver.getsockname()[1]}"
        late = CueAction("osc", to, "/late", delay=0.5)
        sender = Sender(show_harness, CueAction("osc", to, '/cue/1/start 1 0.5 "a b" true'), late)
        sender.go("g1")
        heard = asyncio.get_running_loop().sock_recv
        assert decode_packet(await heard(receiver, 999)) == [OscMessage("/cue/1/start", (1, 0.5, "a b", True))]
        for _ in range(31):
            show_harness.tick()
        assert show_harness.show.session.cues._players["main"].state.planned == ()
        assert decode_packet(await heard(receiver, 999)) == [OscMessage("/late")]
        assert sender.said == []
        await sender.sender.close()


async def test_who_is_not_there_is_told_once_and_holds_nothing_up(show_harness: ShowHarness) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((HOST, 0))
        port = taken.getsockname()[1]
    nowhere = CueAction("osc", "nowhere.invalid:9", "/go")
    sender = Sender(show_harness, CueAction("osc", f"{HOST}:{port}", "/go"), nowhere)
    for number in range(3):
        sender.go(f"g{number}")
        target = sender.sender._targets[HOST, port]
        await sender.until(partial(lambda of: not of.quiet, target))
    other = sender.sender._targets["nowhere.invalid", 9]
    await sender.until(lambda: other.told and other.opening is None)
    refused, unknown = sorted(sender.said)
    assert refused == f"what cues send to {HOST}:{port} does not arrive: nobody hears there."
    assert unknown.startswith("what cues send to nowhere.invalid:9 does not arrive: the host is not found")
    await sender.sender.close()


async def test_midi_goes_to_the_page_that_has_the_device(show_harness: ShowHarness) -> None:
    sender = Sender(show_harness, CueAction("midi", "pad", "90 3C 7F"))
    for call in ("g1", "g2"):
        sender.go(call)
    assert sender.said == ["cue 1 sends MIDI to pad, which is plugged in at no page of devices."]
    show_harness.show.session.receive("ana", Plug("Pad", "midi"), 0.0)
    sender.go("g3")
    bytes_sent = [(who, decode_answer(data)) for who, data in sender.sent]
    assert [pair for pair in bytes_sent if isinstance(pair[1], DeviceBytes)] == [
        ("ana", DeviceBytes("Pad", b"\x90\x3c\x7f", cue=True))
    ]
    await sender.sender.close()
