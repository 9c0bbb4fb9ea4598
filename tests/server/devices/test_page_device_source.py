"""Devices at pages as a source of a served show: heard once a tick, told what is new."""

from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.page_devices import PageDevices
from omote.server.devices.page_device_source import PageDeviceSource
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.bindings import Bind, BindingDocument, BindingList, BindingsChanged
from omote.show.objects.devices import Devices, MidiBytes, Plug
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from omote.show.wire import decode_answer
from tests import synthetic


def test_what_pages_say_is_played_in_the_tick_and_what_is_told_is_encoded_once() -> None:
    session = ShowSession(synthetic.cast())
    sent = list[tuple[str, bytes]]()
    for who in ("a", "b"):
        session.receive(who, Hello("console", PROTOCOL_VERSION), 0.0)
    playing = BindingInput(Bindings(), lambda: session)
    commands = BindingCommands(EditableBindings(), playing.bindings, {})
    devices = PageDevices(lambda: session, playing, commands)
    source = PageDeviceSource(devices, lambda: session, lambda who, data: sent.append((who, data)))
    jaw = BindingDocument("pad", "1/cc7", "/omote/one/channel/jawOpen", pick_up=False)
    for message in (Plug("pad", "midi"), Bind("b1", jaw), MidiBytes("pad", b"\xb0\x07\x7f")):
        assert session.receive("a", message, 0.0) == []
    source.hear(0.1)
    state = session.tick(0.1)
    assert state.characters["one"].channels == {"jawOpen": 1.0}
    source.tell(state, 0.1)
    kinds = [(who, type(decode_answer(data))) for who, data in sent]
    assert kinds[0] == ("a", BindingsChanged)
    assert {("a", BindingList), ("b", BindingList), ("b", Devices)} <= {*kinds}
    lists = [data for _, data in sent if isinstance(decode_answer(data), BindingList)]
    assert lists[0] is lists[1]
    assert source.probes == []
