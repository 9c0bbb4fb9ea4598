"""Switches trackers and receivers of faces on and off while a show runs, as pages ask, and tells them what is on."""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from omote.inputs.face_output.face_target import SEND_PORTS, SEND_TITLES, SURFACE, FaceTarget, read_targets
from omote.inputs.trackers.tracker_protocols import API_NAME, TRACKER_PROTOCOLS, TrackerProtocol, advise
from omote.server.access.phone_page import PHONE_PATH
from omote.server.access.show_addresses import is_loopback, own_address
from omote.server.devices.face_output import FaceOutput
from omote.server.devices.mediapipe_link import MediapipeLink
from omote.server.devices.trackers.tracker_listener import TrackerListener, TrackerSocket
from omote.server.devices.trackers.tracker_sockets import TrackerWish, open_tracker, read_wish
from omote.server.devices.vtube_studio.api_programs import ApiPrograms
from omote.server.persistence.device_file import DeviceFile
from omote.show.objects.devices import Devices, FoundTracker, ReceiverState, SendWay, SwitchDevice, TrackerOffer

MOST_RECEIVERS = 16
WAYS = [SendWay(name, SEND_TITLES[name], port) for name, port in SEND_PORTS.items() if name != SURFACE]
Report = Callable[[str], None]


@dataclass(frozen=True)
class Switched:
    """What is switched: the trackers of a show, results of MediaPipe, VTube Studio's programs, and faces that are
    sent."""

    trackers: TrackerListener
    mediapipe: MediapipeLink
    programs: ApiPrograms
    faces: FaceOutput


class DeviceSwitches:
    """What is on. heard, sent: what the command line has asked for, which no page takes away; a tracker whose port is
    taken is off, and pages switch it on. notes: keep what pages have switched on; outside: gives the address of the
    show's pages for other machines, "" where none opens them."""

    def __init__(
        self, switched: Switched, heard: Iterable[TrackerWish], sent: Iterable[FaceTarget], notes: DeviceFile,
        report: Report = lambda _: None, outside: Callable[[], str] = lambda: "",
    ) -> None:  # fmt: skip
        self._switched = switched
        self._notes = notes
        self._report = report
        self._outside = outside
        self._heard = dict[str, TrackerWish]()
        self._faults = dict[str, tuple[str, str]]()
        for wish in heard:
            self._start(wish)
        self._sent = {target.word: target for target in sent}
        self._fixed = frozenset((*self._heard, *self._sent))
        for target in self._sent.values():
            self._send(target)

    def restore(self) -> None:
        """Switches on what pages have switched on before; what cannot be is said on the terminal."""
        kept = [("listen", word) for word in self._notes.notes.listen] + [("send", w) for w in self._notes.notes.send]
        for direction, word in kept:
            try:
                if direction == "send" or read_wish(word).protocol.name not in self._fixed:
                    self._switch_on(direction, word)
            except ValueError as error:
                self._report(f"{word} stays off: {error}.")

    def switch(self, message: SwitchDevice, now: float) -> None:  # noqa: ARG002  (as other sources are)
        """Does what a page asks for; ValueError where it cannot be, and nothing has changed.

        message: what is asked for; now: seconds, monotonic.
        """
        if message.on:
            self._switch_on(message.direction, message.word)
        else:
            self._switch_off(message.direction, message.word)
        heard = tuple(wish.word for name, wish in self._heard.items() if name not in self._fixed)
        sent = tuple(word for word in self._sent if word not in self._fixed)
        self._notes.keep(listen=heard, send=sent)

    def describe(self, now: float) -> Devices:  # noqa: ARG002  (as other sources are)
        """What can be switched, and how it does."""
        host = own_address() or ""
        programs = self._switched.programs
        announced = [
            FoundTracker(f"{API_NAME}:{port}@{place}", title, place)
            for (place, port), title in programs.announced.items()
        ]
        return Devices(
            [],
            [self._offer(protocol, host or "127.0.0.1") for protocol in TRACKER_PROTOCOLS.values()],
            announced,
            self._receivers(),
            WAYS,
            PHONE_PATH if self._outside() else "",
            host,
        )

    def _start(self, wish: TrackerWish) -> None:
        """Hears what the command line has asked for, or keeps the reason why it cannot be."""
        try:
            if self._switched.trackers.port(wish.protocol.name) is None:
                self._begin(wish)
            self._heard[wish.protocol.name] = wish
        except ValueError as error:
            self._faults[wish.protocol.name] = str(error), wish.word

    def _switch_on(self, direction: str, word: str) -> None:
        if direction == "listen":
            wish = read_wish(word.strip())
            self._check_free(wish.protocol.name)
            _check_numeric(wish.phone)
            self._end(wish.protocol.name)
            self._begin(wish)
            self._heard[wish.protocol.name] = wish
            self._faults.pop(wish.protocol.name, None)
            return
        (target,) = read_targets(word) or [None]
        if target is None or target.protocol == SURFACE:
            raise ValueError("name one receiver of faces, such as vmc:127.0.0.1; a surface of OSC asks by itself")
        self._check_free(target.word)
        _check_numeric(target.host)
        self._check_receiver(target)
        if target.word not in self._sent:
            self._send(target)
        self._sent[target.word] = target

    def _switch_off(self, direction: str, word: str) -> None:
        if direction == "listen":
            name = read_wish(word.strip()).protocol.name
            self._check_free(name)
            self._end(name)
            self._heard.pop(name, None)
            return
        for target in read_targets(word):
            self._check_free(target.word)
            self._sent.pop(target.word, None)
            self._switched.faces.remove(target.word)
            self._switched.programs.remove(target.word)

    def _begin(self, wish: TrackerWish) -> None:
        """Hears a tracker; ValueError where its socket cannot be had."""
        name = wish.protocol.name
        if name == API_NAME:
            self._switched.programs.read(wish.phone, wish.port or 0)
        elif wish.protocol.port is None:
            self._switched.mediapipe.on = True
        else:
            try:
                tracker = TrackerSocket(wish.protocol, open_tracker(wish), wish.phone)
            except OSError as error:
                raise ValueError(str(error).rstrip(".")) from error
            self._switched.trackers.add(tracker)

    def _end(self, name: str) -> None:
        if name == API_NAME:
            self._switched.programs.stop_reading()
        elif TRACKER_PROTOCOLS[name].port is None:
            self._switched.mediapipe.on = False
        else:
            self._switched.trackers.remove(name)

    def _send(self, target: FaceTarget) -> None:
        if target.protocol == API_NAME:
            self._switched.programs.add(target)
        elif target.protocol != SURFACE:
            self._switched.faces.add(target)

    def _check_free(self, what: str) -> None:
        if what in self._fixed:
            raise ValueError(f"{what} is asked for on the command line; start the show without it to switch it here")

    def _check_receiver(self, target: FaceTarget) -> None:
        own = target.host == own_address() or is_loopback(target.host)
        if own and target.port in (wish.port for wish in self._heard.values() if wish.protocol.heard):
            raise ValueError(f"{target.word} would send the show its own face; name another port")
        if target.protocol == API_NAME and API_NAME in self._heard:
            raise ValueError("VTube Studio is read already; what is set there would come back as a face")
        if len(self._sent) >= MOST_RECEIVERS:
            raise ValueError(f"{MOST_RECEIVERS} receivers are sent faces, and no more; switch one off")

    def _offer(self, protocol: TrackerProtocol, host: str) -> TrackerOffer:
        wish = self._heard.get(protocol.name)
        asked = protocol.port if wish is None else wish.port
        port = self._switched.trackers.port(protocol.name) or asked
        stranger = "" if wish is None else self._switched.trackers.stranger(protocol.name)
        fault, again = self._faults.get(protocol.name, ("", ""))
        return TrackerOffer(
            name=protocol.name,
            title=protocol.title,
            port=port,
            asks="computer" if protocol.program else "phone" if protocol.ask else "sender" if protocol.heard else "",
            word="" if wish is None else wish.word,
            fixed=protocol.name in self._fixed,
            advice=advise(protocol, host, port),
            stranger=stranger,
            strange=f"{protocol.name}:{port}@{stranger}" if stranger else "",
            fault=fault,
            again=again,
        )

    def _receivers(self) -> list[ReceiverState]:
        receivers = [
            (
                receiver.target,
                receiver.character,
                receiver.sent,
                receiver.fault or _explain_absence(receiver.target, receiver.character),
            )
            for receiver in self._switched.faces.receivers
        ]
        receivers += [
            (receiver.target, receiver.target.character, receiver.sent, receiver.fault)
            for receiver in self._switched.programs.receivers
        ]
        return [
            ReceiverState(
                target.word, SEND_TITLES[target.protocol], f"{target.host}:{target.port}", character, sent, fault,
                target.word in self._fixed,
            )
            for target, character, sent, fault in receivers
        ]  # fmt: skip


def _explain_absence(target: FaceTarget, character: str) -> str:
    if character or not target.character:
        return ""
    return f"no character is called {target.character[:40]}, or several are"


def _check_numeric(host: str) -> None:
    """ValueError for a name, which a tick would wait for."""
    try:
        if host:
            ipaddress.IPv4Address(host)
    except ValueError as error:
        raise ValueError(f"{host[:60]!r} is no address; type its number, such as 192.168.1.30") from error
