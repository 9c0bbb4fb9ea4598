"""Starts what hears the devices of a show, on the supervisor's sockets."""

from __future__ import annotations

import os
import socket
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Protocol

from omote.inputs.allowed_senders import THIS_MACHINE, AllowedSenders, read_senders
from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_document import decode_stored
from omote.inputs.bindings.binding_file import read_bindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.dmx.dmx_input import DmxInput
from omote.inputs.face_output.face_target import SURFACE, read_targets
from omote.inputs.microphone.microphone_messages import MICROPHONE_PATH
from omote.inputs.osc_input import OscInput
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.input_log import InputLog
from omote.inputs.page_devices.page_devices import PageDevices
from omote.inputs.performers.camera_messages import CAMERA_PATH
from omote.inputs.performers.performer_list import PerformerList
from omote.inputs.trackers.tracker_protocols import MEDIAPIPE_PATH, TRACKER_PROTOCOLS
from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.show_addresses import own_address
from omote.server.camera.camera_link import CameraLinks
from omote.server.devices.dmx_listener import DmxListener
from omote.server.devices.face_output import FaceOutput
from omote.server.devices.mediapipe_link import MediapipeLink
from omote.server.devices.osc_listener import OscListener, OscSockets
from omote.server.devices.page_device_source import PageDeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.switches.device_switches import DeviceSwitches, Switched
from omote.server.devices.trackers.tracker_listener import TrackerListener, TrackerSocket
from omote.server.devices.trackers.tracker_sockets import read_trackers
from omote.server.devices.vtube_studio.api_programs import ApiPrograms
from omote.server.http.app import ShowServer
from omote.server.microphone.microphone_link import MicrophoneLink
from omote.server.persistence.authored_work import AuthoredWork
from omote.server.persistence.device_file import DeviceFile, device_path
from omote.server.supervision.device_sockets import DeviceOptions
from omote.server.supervision.early_tick import EarlyTicks
from omote.server.supervision.source_report import SourceReport
from omote.show.access.people_list import Visitor
from omote.show.session import ShowSession

Report = Callable[[str], None]
Started = (
    OscListener
    | DmxListener
    | TrackerListener
    | MediapipeLink
    | MicrophoneLink
    | CameraLinks
    | FaceOutput
    | ApiPrograms
    | PageDeviceSource
)


class Closable(Protocol):
    """What is to be closed at the end of a show."""

    async def close(self) -> None:
        """Closes it."""


async def start_devices(
    server: ShowServer,
    options: DeviceOptions,
    report: Report,
    early: EarlyTicks | None = None,
    show: Path | None = None,
) -> list[Closable]:
    """Hears all devices that a show was opened with; returns what is to be closed. early: is told when OSC comes; desks
    of light send without end, and wait for the beat. show: its file, beside which lies what pages switch on."""
    early = early or EarlyTicks()
    allowed = read_senders(options.allow) if options.allow else THIS_MACHINE
    allowed = allowed.with_host(own_address())  # a desk's program here sends to groups by a network card
    log = RejectionLog(report)
    bindings, commands = _open_bindings(server, options, report)
    started: list[Started] = []
    if options.osc is not None:
        started.append(await _hear_osc(server, _copy(options.osc), options, log, allowed, early))
    if options.sacn is not None or options.artnet is not None:
        started.append(_hear_dmx(bindings, options, log, allowed, report))
    notes = _open_notes(show, report)
    switched = _open_switched(server, options, log, allowed, notes, report)
    started += [switched.trackers, switched.mediapipe, switched.programs, switched.faces]
    switches = _open_switches(switched, options, notes, report, lambda: server.outside)
    server.enable_phone_page(lambda: switches.describe(server.clock()))
    started += [_open_microphones(server, early), _open_cameras(server, log, report)]
    sources = tuple(started)
    devices = PageDevices(
        lambda: server.session, bindings, commands, InputLog(_wall() - server.clock()),
        lambda: [probe for each in sources for probe in each.probes], switches,
    )  # fmt: skip
    started.append(PageDeviceSource(devices, lambda: server.session, server.links.answer))
    server.sources.extend([*started, SourceReport(lambda: server.session, report)])
    return list(started)


async def _hear_osc(
    server: ShowServer, datagrams: socket.socket, options: DeviceOptions, log: RejectionLog, allowed: AllowedSenders,
    early: EarlyTicks,
) -> OscListener:  # fmt: skip
    connections = None if options.osc_connections is None else _copy(options.osc_connections)
    sockets = OscSockets(datagrams, connections)
    osc = OscListener(OscInput(lambda: server.session), sockets, log, allowed, spoke=early.note)
    early.watch(datagrams)
    await osc.start()
    _tell_surfaces(osc, options, server.clock())
    server.enable_oscquery(datagrams.getsockname()[1], allowed.allows)
    return osc


def _tell_surfaces(osc: OscListener, options: DeviceOptions, now: float) -> None:
    """Tells surfaces that the operator named what is on air, though they do not ask."""
    for target in read_targets(options.send):
        if target.protocol == SURFACE:
            osc.osc.subscribe((target.host, target.port), now, lasting=True)


def _hear_dmx(
    bindings: BindingInput, options: DeviceOptions, log: RejectionLog, allowed: AllowedSenders, report: Report
) -> DmxListener:
    sacn, artnet = (None if each is None else _copy(each) for each in (options.sacn, options.artnet))
    dmx = DmxInput(options.universes)
    return DmxListener(dmx, bindings, log, sacn=sacn, artnet=artnet, allowed=allowed, report=report)


def _open_notes(show: Path | None, report: Report) -> DeviceFile:
    """What pages have switched on; nothing, with a word on the terminal, where that cannot be read."""
    notes = DeviceFile(None if show is None else device_path(show), report)
    notes.load()
    return notes


def _open_switched(
    server: ShowServer,
    options: DeviceOptions,
    log: RejectionLog,
    allowed: AllowedSenders,
    notes: DeviceFile,
    report: Report,
) -> Switched:
    """What hears trackers, and what sends faces to other programs."""

    def session() -> ShowSession:
        return server.session

    mediapipe, faces = MediapipeLink(session, log), FaceOutput((), session, report)
    server.enable_sender(MEDIAPIPE_PATH, mediapipe.respond)
    trackers = _hear_trackers(server, options, log, allowed)
    return Switched(trackers, mediapipe, ApiPrograms(session, log, notes, faces.weigh), faces)


def _open_switches(
    switched: Switched, options: DeviceOptions, notes: DeviceFile, report: Report, outside: Callable[[], str]
) -> DeviceSwitches:
    """What is on: what the command line asks for, and what pages have switched on before."""
    switches = DeviceSwitches(
        switched, read_trackers(options.listen), read_targets(options.send), notes, report, outside
    )
    switches.restore()
    return switches


def _holds(server: ShowServer) -> Callable[[Visitor], bool]:
    """Whether somebody's token still counts."""
    return lambda visitor: server.access is None or server.access.holds(visitor)


def _open_microphones(server: ShowServer, early: EarlyTicks) -> MicrophoneLink:
    """The microphone pages of the show."""
    microphones = MicrophoneLink(lambda: server.session, server.clock, early.note, _holds(server))
    server.enable_sender(MICROPHONE_PATH, microphones.respond)
    return microphones


def _open_cameras(server: ShowServer, log: RejectionLog, report: Report) -> CameraLinks:
    """The camera pages of the show; without a show file their performers are known until its end."""
    work = _find_work(server)

    def keep(documents: Mapping[str, bytes], gone: list[str]) -> None:
        if (kept := work()) is not None:
            kept.keep_performers(documents, gone, report)

    stored = work()
    performers = PerformerList({} if stored is None else stored.performers, keep)
    cameras = CameraLinks(lambda: server.session, performers, log, _holds(server), lambda: server.outside)
    server.enable_sender(CAMERA_PATH, cameras.respond)
    return cameras


def _find_work(server: ShowServer) -> Callable[[], AuthoredWork | None]:
    return lambda: None if server.editing is None else server.editing.authored_work


def _hear_trackers(
    server: ShowServer, options: DeviceOptions, log: RejectionLog, allowed: AllowedSenders
) -> TrackerListener:
    wishes = {wish.protocol.name: wish for wish in read_trackers(options.listen)}
    sockets = [
        TrackerSocket(TRACKER_PROTOCOLS[name], _copy(descriptor), wishes[name].phone)
        for name, descriptor in options.trackers.items()
    ]
    return TrackerListener(sockets, lambda: server.session, log, allowed)


def _open_bindings(server: ShowServer, options: DeviceOptions, report: Report) -> tuple[BindingInput, BindingCommands]:
    """The bindings of the show file, with those of the file of the command line before them."""

    work = _find_work(server)

    def keep(document: bytes) -> None:
        if (kept := work()) is not None:
            kept.keep_bindings(document, report)

    kept = work()
    own, presets, wrong = decode_stored(b"" if kept is None else kept.bindings)
    for sentence in wrong:
        report(f"{sentence}.")
    bindings = BindingInput(Bindings(), lambda: server.session)
    editable = EditableBindings(own, _fixed_bindings(options.bindings, report))
    return bindings, BindingCommands(editable, bindings.bindings, presets, keep)


def _fixed_bindings(path: str, report: Report) -> list[Binding]:
    """The bindings of a file; none, with a word on the terminal, where it has become unreadable since the start."""
    try:
        return load_bindings(Path(path)) if path else []
    except (OSError, ValueError) as error:
        report(f"{error}; nothing is bound.")
        return []


def load_bindings(path: Path) -> list[Binding]:
    """The bindings of a file; OSError or ValueError with a message that names it."""
    try:
        return read_bindings(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise OSError(f"{path} cannot be read ({explain_error(error)})") from error
    except ValueError as error:
        raise ValueError(f"{path}: {explain_error(error)}") from error


def _wall() -> float:
    """Seconds since 1970, for people to read."""
    return time.time()  # noqa: TID251  (dates lines of a log; drives nothing)


def _copy(descriptor: int) -> socket.socket:
    """A socket of this process's own; the other belongs to the supervisor, for the next process."""
    return socket.socket(fileno=os.dup(descriptor))
