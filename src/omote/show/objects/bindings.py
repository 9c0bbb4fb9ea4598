"""Bindings: the controls of devices, and what they play."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, ClassVar, Literal

import msgspec

from omote.show.declaration import CallId, CharacterName, DeviceMessage, Name, ServerMessage
from omote.show.objects.documents import Document
from omote.show.osc import ROOT

DeviceName = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
ControlName = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
SourceKind = Literal["midi", "gamepad", "space_mouse", "osc", "sacn", "artnet", "tracker"]


class BindingDocument(msgspec.Struct, frozen=True):
    """A control of a device, and what it plays (`inputs/bindings`).

    `control`: as a reading names it (`1/cc7`, `1/note60`, `axis0`); `to`: an address of OSC with its character, or
    `bank:NAME`. `axis`: `yaw` of a head; `arguments`: of a call. `low`, `high`: values at both ends of the control
    (nil: the target's own); `curve`: exponent between them; `pick_up`: a fader acts once it has crossed the value on
    air. `button`: how a key moves a level, `relative`: how an encoder counts, "" for neither; `step`: the part of the
    range that one step moves. `bank`: where it plays, "" in all. `dead_zone`: how far from its middle a stick counts as
    there, 0..0.45 of its way.
    """

    device: DeviceName
    control: ControlName
    to: Annotated[str, msgspec.Meta(min_length=1, max_length=160)]
    axis: Annotated[str, msgspec.Meta(max_length=24)] = ""
    arguments: Annotated[list[float | str], msgspec.Meta(max_length=8)] = []
    low: float | None = None
    high: float | None = None
    curve: float = 1.0
    pick_up: bool = True
    button: Literal["", "momentary", "toggle"] = ""
    relative: Literal["", "twos_complement", "binary_offset", "sign_magnitude"] = ""
    step: float = 1.0 / 128.0
    bank: Annotated[str, msgspec.Meta(max_length=80)] = ""
    dead_zone: float = 0.0


def pad_of(address: str) -> str:
    """The pad whose point an address of OSC moves, as it has the name; "" for none."""
    _, _, path = address.removeprefix(f"/{ROOT}/").partition("/")
    kind, _, name = path.partition("/")
    return name if kind == "pad" else ""


def address_after_rename(address: str, pad: str, to: str) -> str:
    """An address that moves a pad under its new name, where it has that exactly as before; any other as it is.

    address: of OSC, with its character; pad: the name before; to: the name now.
    """
    name = pad_of(address)
    return f"{address.removesuffix(name)}{to}" if name == pad else address


class BindingMessage(DeviceMessage, frozen=True):
    """What a page asks of bindings; each executes once."""


class Bind(BindingMessage, frozen=True):
    """Binds a control, in the place of the same one with the same target, and of `replaces`. An `id` executes once;
    answered, as the messages below that have one, with `bindings_changed`."""

    id: CallId
    binding: BindingDocument
    replaces: BindingDocument | None = None


class Unbind(BindingMessage, frozen=True):
    """Takes a binding away."""

    id: CallId
    binding: BindingDocument


class Learn(BindingMessage, frozen=True):
    """Binds the next control that moves to an address, in the place of nothing; `to` "" stops. Ends by itself after
    half a minute."""

    id: CallId
    to: Annotated[str, msgspec.Meta(max_length=160)]
    axis: Annotated[str, msgspec.Meta(max_length=24)] = ""
    arguments: Annotated[list[float | str], msgspec.Meta(max_length=8)] = []
    bank: Annotated[str, msgspec.Meta(max_length=80)] = ""


class LoadPreset(BindingMessage, frozen=True):
    """Binds a device as a preset has it, in the place of all its bindings; `character`: whom it plays, `*` all."""

    id: CallId
    device: DeviceName
    preset: Name
    character: CharacterName = "*"


class RestoreBindings(BindingMessage, frozen=True):
    """Takes back what the message of the id `change` did to the bindings; that can be taken back itself."""

    id: CallId
    change: CallId


class ChooseBank(DeviceMessage, frozen=True):
    """Turns a device to one of its banks, "" to none."""

    device: DeviceName
    bank: Annotated[str, msgspec.Meta(max_length=80)]


class LearningState(msgspec.Struct, frozen=True):
    """What the next control that moves will be bound to, and who asked for it (a console's name)."""

    id: str
    to: str
    axis: str
    arguments: list[float | str]
    who: str


class PresetDocument(msgspec.Struct, frozen=True):
    """A preset: its name, what people call the device, and whether it is made for it (`matches`: device names, as
    regular expressions in any case)."""

    name: str
    label: str
    kind: SourceKind
    matches: list[str]


class BindingList(ServerMessage, frozen=True):
    """All bindings in their order: complete, to consoles after the welcome and with each change. `fixed`: those of
    these that a file of the command line has made, which no page changes. `missing`: for each of the bindings why it
    waits, where it names a face, an expression or a character that is not there, else ""."""

    bindings: list[BindingDocument]
    fixed: list[BindingDocument]
    learning: LearningState | None
    presets: list[PresetDocument]
    missing: list[str] = []


class BindingsChanged(ServerMessage, frozen=True):
    """Answers bind, unbind, learn (when a control has been bound), load_preset and restore_bindings: what is new and
    what is gone; `restore_bindings` takes it back. `preset`: nobody asked, the preset of this label was loaded when its
    device was plugged in for the first time: all consoles are told, `here` says whether it was at this one."""

    id: str
    added: list[BindingDocument]
    removed: list[BindingDocument]
    preset: str = ""
    here: bool = True


class StoredBindings(Document, frozen=True):
    """All bindings of a show, and the preset that each device was given ("": none, and none is wanted)."""

    kind: ClassVar[str] = "bindings"
    most: ClassVar[int] = 1

    bindings: list[BindingDocument] = msgspec.field(default_factory=list)
    presets: dict[str, str] = msgspec.field(default_factory=dict)

    def names(self) -> Iterable[str]:
        """What the bindings call, set and play, as the arguments of their addresses."""
        return [argument for binding in self.bindings for argument in binding.arguments if isinstance(argument, str)]
