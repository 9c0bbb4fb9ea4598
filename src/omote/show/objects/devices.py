"""Devices at pages and in the network: what comes from them, and what they are told."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from omote.show.declaration import DeviceMessage, RequestId, ServerMessage
from omote.show.objects.bindings import ControlName, DeviceName, SourceKind

DeviceKind = Literal["midi", "gamepad", "space_mouse"]


class Plug(DeviceMessage, frozen=True):
    """A device is at this page from now on, until `unplug` or the end of the link. Rejected while another page has one
    of that name: two of a kind need two names."""

    once = False

    device: DeviceName
    kind: DeviceKind
    id: RequestId = ""


class Unplug(DeviceMessage, frozen=True):
    """A device is gone; its bindings wait for it."""

    device: DeviceName


class MidiBytes(DeviceMessage, frozen=True):
    """What a MIDI device has sent, as it came."""

    device: DeviceName
    data: Annotated[bytes, msgspec.Meta(max_length=1024)]


class Controls(DeviceMessage, frozen=True):
    """Where controls of a gamepad or a space mouse stand now, those that have moved: 0..1, an axis rests at .5; one
    whose name begins with `button` is a key."""

    device: DeviceName
    values: Annotated[dict[ControlName, float], msgspec.Meta(max_length=64)]


class WatchDevices(DeviceMessage, frozen=True):
    """This page shows devices from now on, or no more: while it does it hears of them ten times a second."""

    on: bool


class SwitchDevice(DeviceMessage, frozen=True):
    """Switches on or off what is heard (`listen`: a tracker) or told (`send`: a receiver of faces), by the word that
    stands after `--listen` or `--send`."""

    once = False

    direction: Literal["listen", "send"]
    word: Annotated[str, msgspec.Meta(min_length=1, max_length=200)]
    on: bool
    id: RequestId = ""


class DeviceState(msgspec.Struct, frozen=True):
    """A device, or another source of a show: where it is (a console's name, a host), whether it is there now.

    `rate`: readings or packets a second; `heard`, `rejected`: counts since the server began. `values`: where its
    controls stood last, 0..1, the newest sixty-four; `waiting`: controls that wait to be picked up, and the position
    at which they will be. `bank`: the one that it is turned to, of its `banks`; `preset`: the one it was given.
    `advice`: what to do at whoever sends it, such as what to type into a phone.
    """

    name: str
    kind: SourceKind
    where: str
    plugged: bool
    rate: float
    heard: int
    rejected: int
    values: dict[str, float]
    waiting: dict[str, float] = {}
    bank: str = ""
    banks: list[str] = []
    preset: str = ""
    advice: str = ""


class TrackerOffer(msgspec.Struct, frozen=True):
    """A tracker that can be heard. name: as `--listen` spells it; port: its usual one, or where it is heard, None where
    it comes to the port of the pages; asks: what its word may name behind "@": a phone that is asked for frames, a
    computer that we connect to, a sender that may play beside this machine, or "".

    word: what it is switched on by, "" while it is off; fixed: the command line has; advice: what to do at the sender.
    stranger: a host that has sent and may not, or ""; strange: the word by which it may. fault: why it is off though
    the start has asked for it, or ""; again: the word by which it is switched on then.
    """

    name: str
    title: str
    port: int | None
    asks: Literal["", "phone", "computer", "sender"]
    word: str
    fixed: bool
    advice: str
    stranger: str = ""
    strange: str = ""
    fault: str = ""
    again: str = ""


class FoundTracker(msgspec.Struct, frozen=True):
    """A program that has announced itself, and the word by which it is heard."""

    word: str
    title: str
    where: str


class ReceiverState(msgspec.Struct, frozen=True):
    """A program that faces are sent to. word: as after `--send`; character: whose face, "" where nobody is called so;
    sent: packets since it was switched on; fault: why it does not arrive, or ""; fixed: the command line has it."""

    word: str
    title: str
    where: str
    character: str
    sent: int
    fault: str
    fixed: bool


class SendWay(msgspec.Struct, frozen=True):
    """A way to send a face: its name as `--send` spells it, and the port where receivers usually hear it."""

    name: str
    title: str
    port: int


class Devices(ServerMessage, frozen=True):
    """All sources: complete, to consoles when one comes or goes and once a second, to pages that watch ten times a
    second. trackers: what can be heard; found: what has announced itself; receivers: to whom faces are sent, in one of
    these ways; phone_page: the address that a phone opens to copy what to type, "" where the show listens on its own
    machine alone; host: that machine's address in its network, to which trackers send, "" where it is in none."""

    devices: list[DeviceState]
    trackers: list[TrackerOffer] = []
    found: list[FoundTracker] = []
    receivers: list[ReceiverState] = []
    ways: list[SendWay] = []
    phone_page: str = ""
    host: str = ""


class InputLine(msgspec.Struct, frozen=True):
    """What came from a source, or why it was rejected; `count`: how often the same within a second; `time`: seconds
    since 1970. Of a sender of a face there is one line while it sends: `rate` a second, `bars`: the channels that move
    most, and where each stands."""

    number: int
    time: float
    source: str
    text: str
    rejected: bool
    count: int = 1
    rate: float = 0.0
    bars: dict[str, float] = {}


class InputLog(ServerMessage, frozen=True):
    """What came in last, the oldest first, at most two hundred lines: complete, to pages that watch devices."""

    lines: list[InputLine]


class DeviceBytes(ServerMessage, frozen=True):
    """What a device is to be sent (MIDI): to the page that has it. `cue`: a cue sends it, so the page says where it
    does not arrive."""

    device: str
    data: bytes
    cue: bool = False
