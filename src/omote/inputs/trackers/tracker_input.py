"""Trackers at a show session: packets and times in; each tracker is a source, and drives by its newest frame."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from omote.inputs.rejection import PacketError, Rejection
from omote.inputs.trackers.arkit_names import ARKIT_NAMES, ChannelNames
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, limit_gaze, limit_head
from omote.inputs.trackers.packet_format import explain_format, is_read_by, recognize_format
from omote.inputs.trackers.tracker_frame import Decode, TrackerFrame
from omote.inputs.trackers.tracker_protocols import TrackerProtocol
from omote.model.known_names import NEUTRAL
from omote.perform.layers.layer_names import LayerName
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.show import messages as wire
from omote.show.session import ShowSession

MOST_PERFORMERS = 8
"""Performers of one protocol at a time, by host and name; the one that was silent longest makes room."""
LONGEST_NAME = 80
LAYER: LayerName = "tracker"
"""The layer that a tracker drives until it is routed elsewhere."""
MOST_BARS = 59
"""Channels of which a page is told, beside five angles."""


@dataclass(frozen=True)
class SenderCounts:
    """One performer before a tracker, for pages: its name, how many frames came, and its newest values."""

    name: str
    heard: int
    values: Mapping[str, float]


@dataclass
class Performer:
    """One performer before a tracker: a source of the session. names: its channels; values: what it sent last.

    head, gaze: its angles as far as ours turn. sent: the names of its newest frame, of which those at `taken` are, by
    their `shares`, the channels at `places`; several: names mean the same channel; cast: whose names.

    turns, looks: whether its head and its eyes have ever turned: senders that know no angles send zeros for ever.
    """

    name: str
    who: str
    names: tuple[str, ...] = ()
    values: NDArray[np.float32] = field(default_factory=lambda: np.zeros(0, np.float32))
    index: int | None = None
    newest: TrackerFrame | None = None
    turns: bool = False
    looks: bool = False
    head: HeadAngles = (0.0, 0.0, 0.0)
    gaze: GazeAngles = (0.0, 0.0)
    cast: ChannelNames | None = None
    sent: tuple[str, ...] = ()
    taken: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))
    places: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))
    shares: NDArray[np.float32] = field(default_factory=lambda: np.zeros(0, np.float32))
    several: bool = False
    heard: int = 0


class TrackerInput:
    """All trackers of one protocol. port_of: where another protocol is heard, by its name, None where it is not; heard,
    rejected: counts of packets; where: the host of the newest one."""

    def __init__(
        self,
        protocol: TrackerProtocol,
        session: Callable[[], ShowSession],
        port_of: Callable[[str], int | None] = lambda _: None,
    ) -> None:
        self.protocol, self._session, self._port_of = protocol, session, port_of
        self._decoders: dict[str, Decode] = {}
        self._performers: dict[tuple[str, str], Performer] = {}
        self._names: tuple[object, ChannelNames] | None = None
        self.heard = self.rejected = 0
        self.where = ""
        self.last_rejection: Rejection | None = None
        self._last: Performer | None = None
        self._answers: list[bytes] = []

    def receive(self, host: str, data: bytes, now: float) -> list[bytes]:
        """Reads a packet; what cannot be read is rejected and counted. Returns the packets that answer it."""
        self.heard, self.where = self.heard + 1, host
        try:
            for frame in self._decoder(host)(data):
                self.note(host, frame)
        except PacketError as error:
            self.reject(host, self._explain(data, error), now)
        answers, self._answers = self._answers, []
        return answers

    def play(self, now: float) -> None:
        """Drives the session by the newest frame of each performer."""
        for key, performer in list(self._performers.items()):
            if (frame := performer.newest) is not None:
                performer.newest = None
                for reason in self._drive(performer, frame, now):
                    self.reject(key[0], reason, now)

    def title(self, host: str, subject: str) -> str:
        """The name of the source of a performer."""
        return " ".join(part for part in (self.protocol.title, subject, host) if part)[:LONGEST_NAME]

    def client(self, host: str, subject: str) -> str | None:
        """The client by which a performer's source is at the session; None while there is no such source."""
        performer = self._performers.get((host, subject))
        return None if performer is None or performer.index is None else performer.who

    def end(self, host: str, subject: str) -> None:
        """A performer has gone, and the source with them; of one who is unknown nothing happens."""
        performer = self._performers.pop((host, subject), None)
        if performer is not None:
            self._session().leave(performer.who)

    def leave(self) -> None:
        """Takes its sources out of the session: what they drove is lost, and fades out."""
        for performer in self._performers.values():
            self._session().leave(performer.who)
        self._performers.clear()

    def values(self) -> dict[str, float]:
        """What the newest performer sent last, by channel, and its angles; as far as bars show it."""
        return {} if self._last is None else _values(self._last)

    def senders(self) -> tuple[SenderCounts, ...]:
        """All performers, the one that sent last at the end."""
        title = f"{self.protocol.title} "
        return tuple(
            SenderCounts(each.name.removeprefix(title), each.heard, _values(each)) for each in self._performers.values()
        )

    def _explain(self, data: bytes, error: PacketError) -> str:
        """Why a packet is not obeyed; of one of another protocol where that goes."""
        name = recognize_format(data)
        other = name and not is_read_by(name, self.protocol.name)
        return explain_format(name, self._port_of(name)) if other else str(error)

    def _decoder(self, host: str) -> Decode:
        if host not in self._decoders:
            if len(self._decoders) >= MOST_PERFORMERS:
                del self._decoders[next(iter(self._decoders))]
            self._decoders[host] = self.protocol.open(lambda packet: self._answers.append(packet))
        return self._decoders[host]

    def note(self, host: str, frame: TrackerFrame) -> None:
        """Takes a frame that was decoded; host: "" for a performer who is told by the subject alone."""
        key = (host, frame.subject)
        performer = self._performers.pop(key, None) or self._begin(host, frame.subject)
        performer.heard += 1
        self._performers[key] = self._last = performer  # to the end: who was silent longest stands first
        if frame.found:
            self._keep(performer, frame)
        performer.newest = frame

    def _begin(self, host: str, subject: str) -> Performer:
        while len(self._performers) >= MOST_PERFORMERS:
            oldest = next(iter(self._performers))
            self._session().leave(self._performers.pop(oldest).who)
        return Performer(self.title(host, subject), f"{self.protocol.name} {host} {subject}")

    def _keep(self, performer: Performer, frame: TrackerFrame) -> None:
        """Notes the values that a frame has; others stay as they were."""
        names = self._channel_names()
        sent = tuple(frame.weights)
        if (performer.sent, performer.cast) != (sent, names):
            _take_names(performer, sent, names)
        values = np.fromiter(frame.weights.values(), np.float32, len(sent))
        said = values[performer.taken] * performer.shares
        if performer.several:  # where names mean the same the largest counts: VRM's `Blink` is 0 beside ARKit's
            performer.values[performer.places] = -np.inf
            np.maximum.at(performer.values, performer.places, said)
        else:
            performer.values[performer.places] = said
        if frame.head is not None:
            performer.head = limit_head(frame.head)
            performer.turns = performer.turns or any(performer.head)
        if frame.gaze is not None:
            performer.gaze = limit_gaze(frame.gaze)
            performer.looks = performer.looks or any(performer.gaze)

    def _channel_names(self) -> ChannelNames:
        """The names of the cast that plays, ARKit's first."""
        cast = self._session().cast
        if self._names is None or self._names[0] is not cast:
            channels = [name for name in cast.expressions if name != NEUTRAL]
            arkit = [name for name in ARKIT_NAMES if name in cast.expressions]
            self._names = cast, ChannelNames(dict.fromkeys([*arkit, *channels]))
        return self._names[1]

    def _drive(self, performer: Performer, frame: TrackerFrame, now: float) -> list[str]:
        """Sends a frame to the session; returns the reasons of rejections."""
        session = self._session()
        if not (performer.names or performer.turns or performer.looks):
            return []
        if performer.who not in session.crew:
            session.join(performer.who, performer.name[:24])
            performer.index = None
        if performer.index is None:
            answers = session.receive(performer.who, self._source(session, performer, now), now)
            found = [answer.message for answer in answers if isinstance(answer.message, wire.SourceIs)]
            if not found:
                return [answer.message.reason for answer in answers if isinstance(answer.message, wire.Refused)]
            performer.index = found[0].index
        values = performer.values.astype("<f4").tobytes()
        head, gaze = performer.head if performer.turns else None, performer.gaze if performer.looks else None
        drive = wire.Drive(performer.index, values, head, gaze, frame.found)
        answers = session.receive(performer.who, drive, now)
        return [answer.message.reason for answer in answers if isinstance(answer.message, wire.Refused)]

    def _source(self, session: ShowSession, performer: Performer, now: float) -> wire.Source:
        """The source of a performer. One that comes for the first time drives the character of a show that has one, if
        no other drives it, from which it would take it."""
        alone = session.sources.find_alone(performer.name, session.scene, LAYER, now)
        return wire.Source(performer.name, "tracker", list(performer.names), alone)

    def reject(self, host: str, reason: str, now: float) -> None:
        """Counts what was not obeyed."""
        self.rejected += 1
        self.last_rejection = Rejection(now, f"{self.protocol.title} from {host}", reason)


def _values(performer: Performer) -> dict[str, float]:
    """What a performer sent last, by channel, and its angles; as far as bars show it."""
    weights = dict(islice(zip(performer.names, performer.values.tolist(), strict=True), MOST_BARS))
    turned = zip(HEAD_LIMITS.items(), performer.head, strict=True) if performer.turns else ()
    looks = zip(GAZE_LIMITS.items(), performer.gaze, strict=True) if performer.looks else ()
    angles = {f"head {name}": 0.5 + 0.5 * angle / most for (name, most), angle in turned}
    return {**weights, **angles, **{f"gaze {name}": 0.5 + 0.5 * angle / most for (name, most), angle in looks}}


def _take_names(performer: Performer, sent: tuple[str, ...], names: ChannelNames) -> None:
    """Finds the channels of the names that a frame has; with other channels it is another source."""
    found = [(index, *each) for index, name in enumerate(sent) for each in names.shares(name).items()]
    known = performer.names if performer.cast is names else ()
    channels = tuple(name for name in names.channels if name in {*known, *(channel for _, channel, _ in found)})
    if channels != performer.names:
        before = dict(zip(performer.names, performer.values.tolist(), strict=True))
        performer.names, performer.index = channels, None
        performer.values = np.array([before.get(name, 0.0) for name in channels], np.float32)
    order = {name: place for place, name in enumerate(channels)}
    performer.sent, performer.cast = sent, names
    performer.taken = np.array([index for index, _, _ in found], np.intp)
    performer.places = np.array([order[channel] for _, channel, _ in found], np.intp)
    performer.shares = np.array([share for _, _, share in found], np.float32)
    performer.several = len({*performer.places.tolist()}) < len(found)
