"""VTube Studio at a show, as a source: the parameters of one are read, those of others are set."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from omote.inputs.face_output.face_target import FaceTarget, find_sent, mean_gaze
from omote.inputs.page_devices.device_health import SourceCounts, count_tracker
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import API_NAME, TRACKER_PROTOCOLS, advise
from omote.inputs.trackers.vtube_studio.api_session import ApiSession
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.vtube_studio.api_announcements import ApiAnnouncements
from omote.server.devices.vtube_studio.api_link import ApiLink, Endpoint
from omote.server.persistence.device_file import DeviceFile
from omote.show.objects.state import CharacterState, State
from omote.show.session import ShowSession

THIS_MACHINE = "127.0.0.1"
EVERY = 2
"""Ticks between two lists, and between two faces that are set: it asks plugins for less than 60 a second."""
Weigh = Callable[[CharacterState], Mapping[str, float]]


@dataclass
class ApiReceiver:
    """A VTube Studio whose parameters are set. sent: faces since it was named."""

    target: FaceTarget
    link: ApiLink
    sent: int = 0

    @property
    def fault(self) -> str:
        """Why nothing arrives, or ""."""
        return self.link.fault or ("" if self.link.session is None else self.link.session.waits)


class ApiPrograms(DeviceSource):
    """The connections of one show. weigh: a character's weights of ARKit's units; notes: keep the tokens."""

    def __init__(
        self, session: Callable[[], ShowSession], log: RejectionLog, notes: DeviceFile, weigh: Weigh,
        announcements: ApiAnnouncements | None = None,
    ) -> None:  # fmt: skip
        self._log = log
        self._notes = notes
        self._weigh = weigh
        self._ticks = 0
        self.announcements = announcements or ApiAnnouncements()
        self.announced: dict[Endpoint, str] = {}
        self.receivers: list[ApiReceiver] = []
        self.reader: ApiLink | None = None
        protocol = replace(TRACKER_PROTOCOLS[API_NAME], open=lambda _: self._decode)
        self.trackers = TrackerInput(protocol, session)
        self._closing: set[asyncio.Task[None]] = set()

    def read(self, host: str, port: int) -> None:
        """Reads the one at a place from now on, and no other; host "": the one that announces itself, or of this
        machine.

        port: where its API is.
        """
        self.stop_reading()
        self.reader = ApiLink(lambda: self._find(host, port), lambda send, place: self._open(send, place, sets=False))

    def stop_reading(self) -> None:
        """Reads none."""
        if self.reader is not None:
            self._close(self.reader)
            self.reader = None
            self.trackers.leave()

    def add(self, target: FaceTarget) -> None:
        """Sets the parameters of the one that a target names from now on."""
        place = (target.host, target.port)
        link = ApiLink(lambda: place, lambda send, where: self._open(send, where, sets=True))
        self.receivers.append(ApiReceiver(target, link))

    def remove(self, word: str) -> None:
        """Sets those of a target no more."""
        for receiver in [receiver for receiver in self.receivers if receiver.target.word == word]:
            self.receivers.remove(receiver)
            self._close(receiver.link)

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick."""
        self._look(now)
        if (reader := self.reader) is not None:
            while reader.waiting and reader.session is not None:
                self.trackers.receive(reader.place[0], reader.waiting.popleft(), now)
            self.trackers.play(now)
            self._log.note_new(self.trackers)
        for receiver in self.receivers:
            while receiver.link.waiting and receiver.link.session is not None:
                self._answer(receiver, receiver.link.waiting.popleft())
        self._log.tell(now)

    def tell(self, state: State, now: float) -> None:  # noqa: ARG002  (every source is told when)
        """Asks for parameters, and sets faces. state: the newest; now: seconds, monotonic."""
        self._ticks += 1
        if self._ticks % EVERY:
            return
        if self.reader is not None and self.reader.session is not None:
            self.reader.session.poll()
        for receiver in self.receivers:
            character = find_sent(receiver.target.character, state.characters)
            if character is not None and receiver.link.session is not None:
                weights = self._weigh(character)
                receiver.sent += receiver.link.session.set_face(weights, character.head, mean_gaze(character))

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of the one that is read."""
        return [] if self.reader is None else [self._count]

    async def close(self) -> None:
        """Closes all connections."""
        self.stop_reading()
        for receiver in list(self.receivers):
            self.remove(receiver.target.word)
        await asyncio.gather(*self._closing)
        self.announcements.close()
        self._notes.close()

    def _decode(self, data: bytes) -> list[TrackerFrame]:
        session = None if self.reader is None else self.reader.session
        return [] if session is None else session.decode(data)

    def _answer(self, receiver: ApiReceiver, data: bytes) -> None:
        try:
            assert receiver.link.session is not None
            receiver.link.session.decode(data)
        except ValueError as error:
            self._log.note(f"VTube Studio at {receiver.link.place[0]}: {error}")

    def _look(self, now: float) -> None:
        self.announced = {
            place: announcement.window_title for place, announcement in self.announcements.look(now).items()
        }

    def _find(self, host: str, port: int) -> Endpoint:
        """Where to connect to: the place that is named, or where one has announced itself."""
        return (host, port) if host else next(iter(self.announced), (THIS_MACHINE, port))

    def _open(self, send: Callable[[bytes], None], place: Endpoint, *, sets: bool) -> ApiSession:
        program = f"VTube Studio {place[0]}:{place[1]}"
        token = self._notes.token(program)
        return ApiSession(send, lambda granted: self._notes.keep_token(program, granted), token=token, sets=sets)

    def _close(self, link: ApiLink) -> None:
        task = asyncio.get_running_loop().create_task(link.close())
        self._closing.add(task)
        task.add_done_callback(self._closing.discard)

    def _count(self) -> SourceCounts:
        reader = self.reader
        trackers = self.trackers
        fault = "" if reader is None else reader.fault or ("" if reader.session is None else reader.session.waits)
        return count_tracker(trackers, fault or advise(trackers.protocol, "", None))
