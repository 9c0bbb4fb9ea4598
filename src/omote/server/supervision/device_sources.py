"""Starts what hears the devices of a show, on the supervisor's sockets."""

from __future__ import annotations

import os
import socket
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

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
from omote.inputs.page_devices.input_log import LineLog
from omote.inputs.page_devices.page_devices import PageDevices
from omote.inputs.page_devices.setup_commands import SetupCommands
from omote.inputs.performers.camera_messages import CAMERA_PATH
from omote.inputs.performers.performer_list import PerformerList
from omote.inputs.trackers.tracker_protocols import MEDIAPIPE_PATH, TRACKER_PROTOCOLS
from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.show_addresses import own_address
from omote.server.camera.camera_link import CameraLinks
from omote.server.devices.cue_sender import CueSender
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.dmx_listener import DmxListener
from omote.server.devices.face_output import FaceOutput
from omote.server.devices.guarded_source import GuardedSource
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
from omote.show.objects.bindings import StoredBindings
from omote.show.objects.hand.setups import StoredSetup
from omote.show.objects.performers import StoredPerformer
from omote.show.session import ShowSession
from omote.showfile.changes import Change, DocumentRemoval, StoredDocument

Report = Callable[[str], None]


@dataclass(frozen=True)
class _Opening:
    """What all sources of a show are opened with. log: of what they reject; allowed: who may send to them."""

    server: ShowServer
    options: DeviceOptions
    report: Report
    early: EarlyTicks
    log: RejectionLog
    allowed: AllowedSenders

    def session(self) -> ShowSession:
        """The session that plays."""
        return self.server.session

    def work(self) -> AuthoredWork | None:
        """The authored work of the show file."""
        return None if self.server.editing is None else self.server.editing.authored_work


async def start_devices(
    server: ShowServer,
    options: DeviceOptions,
    report: Report,
    early: EarlyTicks | None = None,
    show: Path | None = None,
) -> list[DeviceSource]:
    """Hears all devices that a show was opened with; returns what is to be closed.

    server: of the show; options: what was asked for; report: says on the terminal what is wrong; early: is told when
    OSC comes; desks of light send without end, and wait for the beat. show: its file, beside which lies what pages
    switch on.
    """
    allowed = read_senders(options.allow) if options.allow else THIS_MACHINE
    allowed = allowed.with_host(own_address())  # a desk's program here sends to groups by a network card
    opening = _Opening(server, options, report, early or EarlyTicks(), RejectionLog(report), allowed)
    bindings, commands = _open_bindings(opening)
    started: list[DeviceSource] = []
    osc = None if options.osc is None else await _hear_osc(opening, _copy(options.osc))
    if osc is not None:
        started.append(osc)
    if options.sacn is not None or options.artnet is not None:
        started.append(_hear_dmx(opening, bindings))
    notes = DeviceFile(None if show is None else device_path(show), report)
    notes.load()
    switched = _open_switched(opening, notes)
    if osc is not None:
        osc.osc.port_of = switched.trackers.port
    started += [switched.trackers, switched.mediapipe, switched.programs, switched.faces]
    wanted = read_trackers(options.listen), read_targets(options.send)
    switches = DeviceSwitches(switched, *wanted, notes, report, lambda: server.outside)
    switches.restore()
    server.enable_phone_page(lambda: switches.describe(server.clock()))
    started += [_open_microphones(opening), _open_cameras(opening)]
    sources = tuple(started)
    devices = PageDevices(
        opening.session, bindings, commands, LineLog(_wall() - server.clock()),
        lambda: [probe for source in sources for probe in source.probes], switches, options.show_control,
        _open_setups(opening, commands),
    )  # fmt: skip
    answer = server.links.answer
    started.append(CueSender(opening.session, devices, answer, server.tell_crew))
    started.append(PageDeviceSource(devices, opening.session, answer, None if osc is None else osc.osc.hands))
    asked = [*started, SourceReport(opening.session, report)]
    server.sources.extend(GuardedSource(source, report) for source in asked)
    return started


async def _hear_osc(opening: _Opening, datagrams: socket.socket) -> OscListener:
    """Hears OSC, and tells surfaces that the operator named what is on air, though they do not ask."""
    server = opening.server
    options = opening.options
    connections = None if options.osc_connections is None else _copy(options.osc_connections)
    sockets = OscSockets(datagrams, connections)
    osc = OscListener(OscInput(opening.session), sockets, opening.log, opening.allowed, spoke=opening.early.note)
    opening.early.watch(datagrams)
    await osc.start()
    osc.osc.resume(server.clock(), opening.allowed.allows)
    for target in read_targets(options.send):
        if target.protocol == SURFACE:
            osc.osc.subscribe((target.host, target.port), server.clock(), lasting=True)
    server.enable_oscquery(datagrams.getsockname()[1], opening.allowed.allows)
    return osc


def _hear_dmx(opening: _Opening, bindings: BindingInput) -> DmxListener:
    options = opening.options
    sacn, artnet = (None if descriptor is None else _copy(descriptor) for descriptor in (options.sacn, options.artnet))
    heard = {"sacn": sacn, "artnet": artnet}
    dmx = DmxInput(options.universes)
    return DmxListener(dmx, bindings, opening.log, **heard, allowed=opening.allowed, report=opening.report)


def _open_switched(opening: _Opening, notes: DeviceFile) -> Switched:
    """What hears trackers, and what sends faces to other programs."""
    wishes = {wish.protocol.name: wish for wish in read_trackers(opening.options.listen)}
    sockets = [
        TrackerSocket(TRACKER_PROTOCOLS[name], _copy(descriptor), wishes[name].phone)
        for name, descriptor in opening.options.trackers.items()
    ]
    trackers = TrackerListener(sockets, opening.session, opening.log, opening.allowed)
    mediapipe = MediapipeLink(opening.session, opening.log)
    opening.server.enable_sender(MEDIAPIPE_PATH, mediapipe.respond, mediapipe.links)
    faces = FaceOutput((), opening.session, opening.report)
    return Switched(trackers, mediapipe, ApiPrograms(opening.session, opening.log, notes, faces.weigh), faces)


def _open_microphones(opening: _Opening) -> MicrophoneLink:
    """The microphone pages of the show."""
    microphones = MicrophoneLink(opening.session, opening.server.clock, opening.early.note)
    opening.server.enable_sender(MICROPHONE_PATH, microphones.respond, microphones.links)
    return microphones


def _open_cameras(opening: _Opening) -> CameraLinks:
    """The camera pages of the show; without a show file their performers are known until its end."""

    def keep(documents: Mapping[str, bytes], gone: list[str]) -> None:
        if (kept := opening.work()) is not None:
            kind = StoredPerformer.kind
            put = [StoredDocument(kind, *named) for named in documents.items()]
            kept.keep_documents([*(DocumentRemoval(kind, name) for name in gone), *put], opening.report)

    stored = opening.work()
    performers = PerformerList({} if stored is None else stored.documents(StoredPerformer.kind), keep)
    cameras = CameraLinks(opening.session, performers, opening.log, lambda: opening.server.outside)
    opening.server.enable_sender(CAMERA_PATH, cameras.respond, cameras.links)
    return cameras


def _open_bindings(opening: _Opening) -> tuple[BindingInput, BindingCommands]:
    """The bindings of the show file, with those of the file of the command line before them."""

    def keep(document: bytes) -> None:
        _keep(opening, StoredDocument(StoredBindings.kind, StoredBindings.kind, document))

    stored = opening.work()
    own, presets, wrong = decode_stored(
        b"" if stored is None else stored.documents(StoredBindings.kind).get(StoredBindings.kind, b"")
    )
    for sentence in wrong:
        opening.report(f"{sentence}.")
    bindings = BindingInput(Bindings(), opening.session)
    editable = EditableBindings(own, _fixed_bindings(opening.options.bindings, opening.report))
    return bindings, BindingCommands(editable, bindings.bindings, presets, keep)


def _open_setups(opening: _Opening, commands: BindingCommands) -> SetupCommands:
    """The set-ups of the show file."""

    def keep(name: str, body: bytes | None) -> None:
        kind = StoredSetup.kind
        _keep(opening, DocumentRemoval(kind, name) if body is None else StoredDocument(kind, name, body))

    stored = opening.work()
    setups = SetupCommands(
        opening.session, commands, {} if stored is None else stored.documents(StoredSetup.kind), keep
    )
    for sentence in setups.unreadable:
        opening.report(f"{sentence}.")
    return setups


def _keep(opening: _Opening, change: Change) -> None:
    """Keeps a change of documents in the show file, where there is one."""
    if (kept := opening.work()) is not None:
        kept.keep_documents([change], opening.report)


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
