"""Devices at pages at a show session: messages of pages and times in; what is played, answered and told out."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from functools import partial
from typing import Protocol

import msgspec

from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.osc_hands import HAND_AXES
from omote.inputs.osc_orders import OrderReader
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.device_health import SourceCounts, SourceHealth
from omote.inputs.page_devices.input_log import LineLog
from omote.inputs.page_devices.plugged_device import PluggedDevice
from omote.inputs.page_devices.setup_commands import SetupCommands
from omote.inputs.reading import Reading
from omote.inputs.show_control_orders import is_meant, read_show_control
from omote.inputs.trackers.tracker_protocols import TRACKER_TITLES
from omote.perform.pad_playing import NO_PADS
from omote.show.declaration import DeviceMessage, Outgoing
from omote.show.objects.bindings import Bind, ChooseBank, Learn, LoadPreset, RestoreBindings, SourceKind, Unbind
from omote.show.objects.devices import (
    Controls,
    DeviceBytes,
    Devices,
    DeviceState,
    InputLog,
    MidiBytes,
    Plug,
    SwitchDevice,
    Unplug,
    WatchDevices,
)
from omote.show.objects.hand.pads import said_of_gone
from omote.show.objects.hand.setups import SetupMessage
from omote.show.objects.link import Refused
from omote.show.objects.state import State
from omote.show.session import ShowSession

MOST_DEVICES = 64
RESERVED = ("OSC", "sACN", "Art-Net", *TRACKER_TITLES)
"""Names of sources that are no devices at a page."""
OSC_SENDER = "osc"
"""Who has a hand that comes by OSC: no client of the show."""
HAND_SILENCE = 2.0
"""Seconds after which such a hand is no longer there."""
FEEDBACK_TICKS = 2
WATCHED_TICKS = 6
TOLD_TICKS = 60
"""Ticks between what devices are sent, what pages that watch are told, and what all consoles are."""


Probe = Callable[[], SourceCounts]


class Switches(Protocol):
    """What pages switch on and off beside the devices at them: trackers, and receivers of faces."""

    def switch(self, message: SwitchDevice, now: float) -> None:
        """Does what a page asks for; ValueError where it cannot be, and nothing has changed.

        message: what it asks for; now: seconds of the show's clock.
        """

    def describe(self, now: float) -> Devices:
        """What can be switched, and how it does; no devices."""


class NoSwitches:
    """Nothing can be switched."""

    def switch(self, message: SwitchDevice, now: float) -> None:  # noqa: ARG002
        """Refuses every message, whatever is asked for, now and always."""
        raise ValueError(f"nothing can be switched here, {message.word[:60]} neither")

    def describe(self, now: float) -> Devices:  # noqa: ARG002
        """Nothing."""
        return Devices([])


class PageDevices:
    """All devices of a show. bindings: play readings; commands: change bindings; probes: of other sources, such as OSC;
    switches: what can be switched beside them; show_control: the device that the show is for MIDI Show Control; setups:
    change mappings and bindings."""

    def __init__(
        self,
        session: Callable[[], ShowSession],
        bindings: BindingInput,
        commands: BindingCommands,
        log: LineLog | None = None,
        probes: Callable[[], Iterable[Probe]] = tuple,
        switches: Switches | None = None,
        show_control: int = 0,
        setups: SetupCommands | None = None,
    ) -> None:
        self._session = session
        self._bindings = bindings
        self._commands = commands
        self.log = log or LineLog()
        self._probes = probes
        self._switches = switches or NoSwitches()
        self._show_control = show_control
        self._setups = setups or SetupCommands(session, commands)
        self._sources: dict[Probe, SourceHealth] = {}
        self.devices: dict[str, PluggedDevice] = {}
        self._watching: set[str] = set()
        self._told: dict[str, tuple[int, int]] = {}
        self._log_told: dict[str, int] = {}
        self._setups_told: dict[str, int] = {}
        self._plugs = self._ticks = 0
        self._reader: OrderReader | None = None
        self._pads = NO_PADS
        bindings.osc.seat_of = self._seat_of

    def receive(self, who: str, message: DeviceMessage, now: float) -> list[Outgoing]:
        """Does what a page says of devices; returns the answers. What cannot be done is rejected with its reason.

        who: the page; message: what it says; now: seconds of the show's clock.
        """
        try:
            return self._answer(who, message, now)
        except ValueError as error:
            name = getattr(message, "device", "")
            if name in self.devices:
                self.devices[name].health.note(0, 1)
            self.log.note(name or "bindings", str(error), now, rejected=True)
            return [Outgoing(who, Refused(f"{error}.", getattr(message, "id", "")))]

    def play_hands(self, hands: Iterable[tuple[str, Reading]], now: float) -> list[Outgoing]:
        """Plays and learns what programs send of hands: each hand is a device, for as long as it is heard.

        hands: readings, each with the host that sent it; now: seconds of the show's clock.
        """
        outgoing = []
        for (host, name), moved in itertools.groupby(hands, lambda heard: (heard[0], heard[1].device)):
            try:
                device = self._meet_hand(name, host, now)
                outgoing += self._play(device, [reading for _, reading in moved], now)
            except ValueError as error:
                self.log.note(name, str(error), now, rejected=True)
        return outgoing

    def _meet_hand(self, name: str, host: str, now: float) -> PluggedDevice:
        """The device of a hand that is heard now, for the first time or again."""
        device = self.devices.get(name)
        if device is not None and device.who:
            device.heard = now
            return device
        where = f"OSC {host}"
        if device is None:
            self._make_room()
            is_bound = partial(self._bindings.bindings.is_bound, name)
            device = self.devices[name] = PluggedDevice(name, "osc", OSC_SENDER, where, now, None, is_bound)
        else:
            device.plug("osc", OSC_SENDER, where, None)
        device.heard = now
        self._plugs += 1
        self.log.note(name, f"comes from {where}", now)
        return device

    def tick(self, state: State, now: float) -> list[Outgoing]:
        """What devices and pages are told after a tick; devices of links that are gone are unplugged.

        state: what is on air; now: seconds of the show's clock.
        """
        self._bindings.note_state(state)
        self._commands.pass_time(now)
        self._setups.look()
        self._unplug_lost(now)
        self._know_names()
        self._ticks += 1
        outgoing = self._presets_loaded(now) + self._news(now) + self._news_of_setups()
        if self._ticks % FEEDBACK_TICKS == 0:
            outgoing += self._feedback(now)
        return outgoing

    def _presets_loaded(self, now: float) -> list[Outgoing]:
        """What consoles are told of presets that were loaded because a device came that nothing was bound on."""
        outgoing = []
        for changed in self._commands.take_loaded():
            device = changed.added[0].device
            self.log.note(device, f"plays as {changed.preset}, the preset that is made for it", now)
            at = self.devices[device].who if device in self.devices else ""
            consoles = self._session().members.consoles()
            outgoing += [Outgoing(who, msgspec.structs.replace(changed, here=who == at)) for who in consoles]
        return outgoing

    def _know_names(self) -> None:
        session = self._session()
        characters = session.scene.labels
        pads = session.scene.pads
        for pad, to in session.take_renamed_pads():
            self._commands.rename_pad(pad, to)
            self._setups.rename_pad(pad, to)
        fits = self._reader is not None and self._reader.fits(session.cast, characters)
        if fits and pads is self._pads:
            return
        for pad in self._pads:
            if pad not in pads and (needed_by := self._commands.who_plays_pad(pad)):
                session.lost.append(said_of_gone(pad, needed_by))
        self._pads = pads
        if self._reader is None or not fits:
            self._reader = OrderReader(session.cast, characters)
        self._commands.know_names(self._reader, pads)

    def _answer(self, who: str, message: DeviceMessage, now: float) -> list[Outgoing]:
        match message:
            case Plug():
                self._plug(who, message, now)
            case Unplug(device):
                self._unplug(self._device_of(who, device), now)
            case MidiBytes(device, data):
                plugged = self._device_of(who, device)
                answers = self._play(plugged, plugged.feed(data), now)
                self._play_cues(plugged, now)
                return answers
            case Controls(device, values):
                plugged = self._device_of(who, device)
                return self._play(plugged, plugged.read(values), now)
            case _:
                return self._carry_out(who, message, now)
        return []

    def _carry_out(self, who: str, message: DeviceMessage, now: float) -> list[Outgoing]:
        match message:
            case Learn():
                self._commands.learn(who, self._name_of(who), message, now)
            case ChooseBank(device, bank):
                self._bindings.bindings.choose_bank(device, bank)
                self._plugs += 1
            case WatchDevices(on):
                (self._watching.add if on else self._watching.discard)(who)
                self._log_told.pop(who, None)
            case SwitchDevice():
                self._switches.switch(message, now)
                self._plugs += 1
                verb = "switched on" if message.on else "switched off"
                self.log.note(message.word.partition(":")[0], f"{verb} at {self._name_of(who)}", now)
            case SetupMessage():
                return [Outgoing(who, self._setups.carry_out(who, message, now))]
            case Bind() | Unbind() | LoadPreset() | RestoreBindings():
                changed = self._commands.carry_out(message)
                if isinstance(message, LoadPreset) and message.device in self.devices:
                    self.devices[message.device].use(self._commands.greet(message.device, ""))
                return [Outgoing(who, changed)]
        return []

    def find_midi(self, name: str) -> PluggedDevice | None:
        """The MIDI device of a name, in any case, that is at a page now; None where there is none."""
        here = (device for device in self.devices.values() if device.who and device.kind == "midi")
        return next((device for device in here if device.name.casefold() == name.casefold()), None)

    def _plug(self, who: str, message: Plug, now: float) -> None:
        name = message.device
        plugged = self.devices.get(message.device)
        if name in RESERVED:
            raise ValueError(f"{name} is the name of another source; give this device another one")
        if plugged is not None and plugged.who not in ("", who) and plugged.who in self._session().crew:
            raise ValueError(
                f"{name} is plugged in at {plugged.where} already; unplug it there, or give this one another name"
            )
        preset = self._commands.greet(name, message.kind)
        where = self._name_of(who)
        if plugged is None:
            self._make_room()
            is_bound = partial(self._bindings.bindings.is_bound, name)
            self.devices[name] = PluggedDevice(name, message.kind, who, where, now, preset, is_bound)
        else:
            plugged.plug(message.kind, who, where, preset)
        self._plugs += 1
        self.log.note(name, f"plugged in at {where}", now)

    def _make_room(self) -> None:
        gone = [name for name, device in self.devices.items() if not device.who]
        if len(self.devices) >= MOST_DEVICES:
            if not gone:
                raise ValueError(f"{MOST_DEVICES} devices are plugged in, and no more are heard; unplug one")
            del self.devices[gone[0]]

    def _unplug(self, device: PluggedDevice, now: float) -> None:
        device.who = ""
        self._bindings.unplug(device.name, now)
        self._plugs += 1
        self.log.note(device.name, "unplugged", now)

    def _unplug_lost(self, now: float) -> None:
        crew = self._session().crew
        for device in self.devices.values():
            gone = now - device.heard > HAND_SILENCE if device.who == OSC_SENDER else device.who not in crew
            if device.who and gone:
                self._unplug(device, now)

    def _device_of(self, who: str, name: str) -> PluggedDevice:
        device = self.devices.get(name)
        if device is None or device.who != who:
            raise ValueError(f"{name} is not plugged in at this page; plug it in first")
        return device

    def _seat_of(self, name: str) -> str:
        """The operator for whom a device plays: whoever sits at its page; "" where it is at none."""
        member = self._session().crew.get(self.devices[name].who) if name in self.devices else None
        return member.seat if member else ""

    def _name_of(self, who: str) -> str:
        member = self._session().crew.get(who)
        return member.name if member else ""

    def _play(self, device: PluggedDevice, readings: list[Reading], now: float) -> list[Outgoing]:
        device.health.note(len(readings))
        learns = self._commands.learner is not None and self._commands.learner.who == device.who
        try:
            learned = self._commands.hear(readings)
        except ValueError as error:
            self._commands.learner = None
            raise ValueError(f"this cannot be learned: {error}") from error
        for reading in readings:
            device.health.read(reading.control, reading.value)
        hands = [reading for reading in readings if self._is_hand(device, reading, now)]
        # what is moved to be learned plays nothing, but a key that was held before is let go
        wanted = [reading for reading in hands if not learns or (reading.key and reading.value == 0.0)]
        device.came = device.came + len(readings)
        device.newest = readings[-1] if readings else device.newest
        before = self._bindings.osc.rejected
        self._bindings.hear(wanted, now)
        self._note_rejections(device, self._bindings.osc.rejected - before, now)
        return [] if learned is None else [Outgoing(*learned)]

    def _play_cues(self, device: PluggedDevice, now: float) -> None:
        """Plays what has come of MIDI Show Control, where this show is meant; what is wrong with it stands in the
        log."""
        osc = self._bindings.osc
        for control in device.take_show_control():
            try:
                if isinstance(control, str):
                    raise ValueError(control)
                if not is_meant(control, self._show_control):
                    whom = f"device {control.device}, format {control.form:02X}"
                    self.log.note(device.name, f"Show Control {control.command} for others ({whom})", now)
                    continue
                order = read_show_control(control, osc.next_call(), [*self._session().cues.book.orders])
            except ValueError as error:
                device.health.note(0, 1)
                self.log.note(device.name, str(error), now, rejected=True)
                continue
            before = osc.rejected
            osc.play((device.name, 0), order, now)
            device.health.note()
            self.log.note(device.name, f"Show Control {control.command} {control.number}".rstrip(), now)
            self._note_rejections(device, osc.rejected - before, now)

    def _is_hand(self, device: PluggedDevice, reading: Reading, now: float) -> bool:
        """Whether a hand moved a control; one that stands where it was sent is noted."""
        if not device.feedback.hear(reading, now):
            return True
        self._bindings.stand(reading)
        return False

    def _note_rejections(self, device: PluggedDevice, new: int, now: float) -> None:
        newest = self._bindings.osc.last_rejection
        if new and newest is not None:
            device.health.note(0, new)
            self.log.note(device.name, newest.reason, now, rejected=True, count=new)

    def _feedback(self, now: float) -> list[Outgoing]:
        outgoing = []
        for device in self.devices.values():
            if device.who and device.kind == "midi":
                lamps = device.preset.lamps if device.preset else ()
                positions = self._bindings.bindings.positions(device.name, self._bindings.on_air, lamps)
                if data := device.feedback.news(positions, now):
                    outgoing.append(Outgoing(device.who, DeviceBytes(device.name, data)))
        return outgoing

    def _news(self, now: float) -> list[Outgoing]:
        """What pages are told of bindings and devices: what is new, and in their turn all."""
        consoles = self._session().members.consoles()
        self._watching &= consoles.keys()
        news = (self._commands.number, self._plugs)
        outgoing = list[Outgoing]()
        changed = [who for who in consoles if self._told.get(who) != news]
        bindings = self._commands.list_now() if changed else None
        for who in changed:
            if bindings is not None and self._told.get(who, (-1, -1))[0] != news[0]:
                outgoing.append(Outgoing(who, bindings))
        watched = self._ticks % WATCHED_TICKS == 0
        due = {*changed, *(self._watching if watched else ()), *(consoles if self._ticks % TOLD_TICKS == 0 else ())}
        self._told = dict.fromkeys(consoles, news)
        if due:
            devices = self.devices_now(now)
            outgoing += [Outgoing(who, devices) for who in consoles if who in due]
        return outgoing + (self._log_news(now) if watched else [])

    def _news_of_setups(self) -> list[Outgoing]:
        """What consoles are told of set-ups: with each change, and where there are any when they come."""
        number = self._setups.number
        told = {who: self._setups_told.get(who, 0) for who in self._session().members.consoles()}
        self._setups_told = dict.fromkeys(told, number)
        due = [who for who, known in told.items() if known != number]
        return [Outgoing(who, setups) for setups in ([self._setups.list_now()] if due else []) for who in due]

    def _log_news(self, now: float) -> list[Outgoing]:
        for device in self.devices.values():
            if device.came and device.newest is not None:
                self.log.note(device.name, f"{device.newest.control} {device.newest.value:.3f}", now, count=device.came)
                device.came = 0
        new = [who for who in sorted(self._watching) if self._log_told.get(who) != self.log.number]
        self._log_told = dict.fromkeys(self._watching, self.log.number)
        return [Outgoing(who, InputLog(self.log.lines)) for who in new]

    def devices_now(self, now: float) -> Devices:
        """All sources: what plays beside the pages, devices at pages, and those for which bindings wait."""
        self._sources = {probe: self._sources.get(probe) or SourceHealth(probe) for probe in self._probes()}
        sources = [source.look(now, self.log) for source in self._sources.values()]
        bindings = self._bindings.bindings
        heard = {*self.devices, *RESERVED}
        waiting = {binding.device: binding.control for binding in bindings.bindings if binding.device not in heard}
        absent = [
            DeviceState(name, _kind_of(control), "", plugged=False, rate=0.0, heard=0, rejected=0, values={})
            for name, control in waiting.items()
        ]
        devices = [*sources, *(self._state(device, now) for device in self.devices.values()), *absent]
        return msgspec.structs.replace(self._switches.describe(now), devices=devices)

    def _state(self, device: PluggedDevice, now: float) -> DeviceState:
        bindings = self._bindings.bindings
        crossings = bindings.crossings(device.name, self._bindings.on_air)
        return device.state(now, crossings, bindings.bank_of(device.name), bindings.banks_of(device.name))


def _kind_of(control: str) -> SourceKind:
    """What a device is that has not been there yet, by a control that is bound."""
    if control in HAND_AXES:
        return "osc"
    return "midi" if "/" in control else "gamepad"
