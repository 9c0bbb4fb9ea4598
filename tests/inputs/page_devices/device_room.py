"""A show with two consoles and devices at them, in one process."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.page_devices import PageDevices
from omote.inputs.page_devices.setup_commands import SetupCommands
from omote.show.declaration import DeviceMessage, Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from tests import synthetic


class Room:
    """A show with two consoles, Ana's and Ben's, and devices at them."""

    def __init__(self) -> None:
        self.session = ShowSession(synthetic.cast())
        for who, name in (("a", "Ana"), ("b", "Ben")):
            self.session.receive(who, Hello("console", PROTOCOL_VERSION, name), 0.0)
        self.playing = BindingInput(Bindings(), lambda: self.session)
        self.kept: list[bytes] = []
        self.commands = BindingCommands(EditableBindings(), self.playing.bindings, {}, self.kept.append)
        self.kept_setups: dict[str, bytes | None] = {}
        self.setups = SetupCommands(lambda: self.session, self.commands, {}, self.kept_setups.__setitem__)
        self.devices = PageDevices(lambda: self.session, self.playing, self.commands, setups=self.setups)
        self.now = 0.0
        self.tick()

    def say(self, who: str, message: DeviceMessage) -> list[Any]:
        """What the page hears at once."""
        assert self.session.receive(who, message, self.now) == []
        found: list[Outgoing] = []
        for each, said in self.session.take_device_messages():
            found += self.devices.receive(each, said, self.now)
        assert {each.who for each in found} <= {who}
        return [each.message for each in found]

    def tick(self, count: int = 1) -> list[Outgoing]:
        found = []
        for _ in range(count):
            self.now += 1 / 60
            found += self.devices.tick(self.session.tick(self.now), self.now)
        return found

    def told(self, kind: type[Any], outgoing: Sequence[Outgoing]) -> dict[str, Any]:
        """The last message of a kind, by client."""
        return {each.who: each.message for each in outgoing if isinstance(each.message, kind)}

    @property
    def jaw(self) -> float:
        return self.session.tick(self.now).characters["one"].channels.get("jawOpen", 0.0)
