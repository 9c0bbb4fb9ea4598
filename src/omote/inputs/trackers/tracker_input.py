"""Trackers at a show session: packets and times in; each tracker is a source, and drives by its newest frame."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from omote.inputs.rejection import PacketError, Rejection
from omote.inputs.source_client import SourceClient, refusals
from omote.inputs.trackers.arkit_names import ARKIT_NAMES, ChannelNames
from omote.inputs.trackers.body_bones import BodyBones, moved_regions
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, Quaternion, limit_gaze, limit_head
from omote.inputs.trackers.packet_format import explain_format, is_read_by, recognize_format
from omote.inputs.trackers.tracker_frame import ANGLES, Decode, TrackerFrame
from omote.inputs.trackers.tracker_protocols import TrackerProtocol
from omote.model.body.pose_regions import PoseRegion
from omote.model.known_names import NEUTRAL
from omote.perform.figures.packed_pose import pack_pose
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.show.objects.sources import Drive
from omote.show.session import ShowSession

MOST_FACES = 8
"""Faces of one protocol at a time, by host and name; the one that was silent longest makes room."""
LONGEST_NAME = 80
MOST_BARS = 59
"""Channels of which a page is told, beside five angles."""
MOST_SAID = 256
"""Names of one face of which is remembered that something was said of them; what comes then is left out in silence."""
MOST_LISTED = 4
"""Of what is said at once."""


@dataclass(frozen=True)
class SenderCounts:
    """One face before a tracker, for pages: its name, how many frames came, and its newest values."""

    name: str
    heard: int
    values: Mapping[str, float]


@dataclass
class TrackedFace(SourceClient):
    """One face before a tracker: a source of the session. names: its channels; values: what it sent last.

    head, gaze: its angles as far as ours turn. sent: the names of its newest frame, of which those at `taken` are, by
    their `shares`, the channels at `places`; several: names mean the same channel; cast: whose names.

    turns, looks: whether its head and its eyes have ever turned: senders that know no angles send zeros for ever.

    bones: of its body as it sent them last; first: as they came first; seen: regions of it that have moved since.

    strange: names of its newest frame that no channel has; said: what was said to be left out of it, or strange.
    """

    names: tuple[str, ...] = ()
    values: NDArray[np.float32] = field(default_factory=lambda: np.zeros(0, np.float32))
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
    strange: tuple[str, ...] = ()
    said: set[str] = field(default_factory=set)
    bones: BodyBones | None = None
    first: Mapping[str, Quaternion] = field(default_factory=dict)
    seen: set[PoseRegion] = field(default_factory=set)


class TrackerInput:
    """All trackers of one protocol. port_of: where another protocol is heard, by its name, None where it is not; heard,
    rejected: counts of packets; where: the host of the newest one; remark: what was said last of names that the cast
    has no channel for, and remarks: how often."""

    def __init__(
        self,
        protocol: TrackerProtocol,
        session: Callable[[], ShowSession],
        port_of: Callable[[str], int | None] = lambda _: None,
    ) -> None:
        self.protocol = protocol
        self._session = session
        self._port_of = port_of
        self._decoders: dict[str, Decode] = {}
        self._faces: dict[tuple[str, str], TrackedFace] = {}
        self._names: tuple[object, ChannelNames] | None = None
        self.heard = self.rejected = 0
        self.where = ""
        self.last_rejection: Rejection | None = None
        self.remarks = 0
        self.remark: Rejection | None = None
        self._last: TrackedFace | None = None
        self._answers: list[bytes] = []

    def receive(self, host: str, data: bytes, now: float) -> list[bytes]:
        """Reads a packet; what cannot be read is rejected and counted. Returns the packets that answer it.

        host: the sender's; data: as it came; now: seconds of the show's clock.
        """
        self.heard = self.heard + 1
        self.where = host
        try:
            for frame in self._decoder(host)(data):
                face = self.note(host, frame)
                if frame.left_out or face.strange:
                    self._tell(host, face, frame, now)
        except PacketError as error:
            self.reject(host, self._explain(data, error), now)
        answers = self._answers
        self._answers = []
        return answers

    def play(self, now: float) -> None:
        """Drives the session by the newest frame of each face."""
        for key, face in list(self._faces.items()):
            if (frame := face.newest) is not None:
                face.newest = None
                for reason in self._drive(face, frame, now):
                    self.reject(key[0], reason, now)

    def title(self, host: str, subject: str) -> str:
        """The name of the source of a face. host: the sender's; subject: whose face it is."""
        return " ".join(part for part in (self.protocol.title, subject, host) if part)[:LONGEST_NAME]

    def client(self, host: str, subject: str) -> str | None:
        """The client by which a face's source is at the session; None while there is no such source.

        host: the sender's; subject: whose face it is.
        """
        face = self._faces.get((host, subject))
        return None if face is None or face.index is None else face.who

    def end(self, host: str, subject: str) -> None:
        """Ends the source of a face, by the host that sends it and its subject; of one that is unknown nothing
        happens."""
        face = self._faces.pop((host, subject), None)
        if face is not None:
            self._session().leave(face.who)

    def leave(self) -> None:
        """Takes its sources out of the session: what they drove is lost, and fades out."""
        for face in self._faces.values():
            self._session().leave(face.who)
        self._faces.clear()

    def values(self) -> dict[str, float]:
        """What the newest face sent last, by channel, and its angles; as far as bars show it."""
        return {} if self._last is None else _values(self._last)

    def senders(self) -> tuple[SenderCounts, ...]:
        """All performers, the one that sent last at the end."""
        title = f"{self.protocol.title} "
        return tuple(
            SenderCounts(face.name.removeprefix(title), face.heard, _values(face)) for face in self._faces.values()
        )

    def _explain(self, data: bytes, error: PacketError) -> str:
        """Why a packet is not obeyed; of one of another protocol where that goes."""
        name = recognize_format(data)
        other = name and not is_read_by(name, self.protocol.name)
        return explain_format(name, self._port_of(name)) if other else str(error)

    def _decoder(self, host: str) -> Decode:
        if host not in self._decoders:
            if len(self._decoders) >= MOST_FACES:
                del self._decoders[next(iter(self._decoders))]
            self._decoders[host] = self.protocol.open(lambda packet: self._answers.append(packet))
        return self._decoders[host]

    def note(self, host: str, frame: TrackerFrame) -> TrackedFace:
        """Takes a frame that was decoded; returns whose it is. host: "" for one that its subject alone tells."""
        key = (host, frame.subject)
        face = self._faces.pop(key, None) or self._begin(host, frame.subject)
        face.heard += 1
        self._faces[key] = self._last = face  # to the end: who was silent longest stands first
        if frame.found:
            self._keep(face, frame)
        face.newest = frame
        return face

    def _tell(self, host: str, face: TrackedFace, frame: TrackerFrame, now: float) -> None:
        """Says, once for each name, what of a frame is not played as it came, and which names no channel has."""
        strange = _unsaid(face, dict.fromkeys(face.strange, ""))
        if strange:
            self.remarks += 1
            self.remark = Rejection(
                now, self._sender(host), f"{_list(strange)}: the cast has no such channel, so that is left out"
            )
        face.strange = ()
        names = self._channel_names()
        wrong = {
            name or reason: reason for name, reason in frame.left_out if name in ANGLES or not name or names.find(name)
        }
        if reasons := [wrong[name] for name in _unsaid(face, wrong)]:
            self.reject(host, _list(reasons), now)

    def _sender(self, host: str) -> str:
        return f"{self.protocol.title} from {host}"

    def _begin(self, host: str, subject: str) -> TrackedFace:
        while len(self._faces) >= MOST_FACES:
            oldest = next(iter(self._faces))
            self._session().leave(self._faces.pop(oldest).who)
        return TrackedFace(self.title(host, subject), f"{self.protocol.name} {host} {subject}")

    def _keep(self, face: TrackedFace, frame: TrackerFrame) -> None:
        """Notes the values that a frame has; others stay as they were."""
        names = self._channel_names()
        sent = tuple(frame.weights)
        if (face.sent, face.cast) != (sent, names):
            _take_names(face, sent, names)
        values = np.fromiter(frame.weights.values(), np.float32, len(sent))
        said = values[face.taken] * face.shares
        if face.several:  # where names mean the same the largest counts: VRM's `Blink` is 0 beside ARKit's
            face.values[face.places] = -np.inf
            np.maximum.at(face.values, face.places, said)
        else:
            face.values[face.places] = said
        if frame.head is not None:
            face.head = limit_head(frame.head)
            face.turns = face.turns or any(face.head)
        if frame.bones is not None:
            face.first = {**frame.bones.turns, **face.first}
            face.bones = frame.bones
            face.seen |= moved_regions(face.first, frame.bones.turns) - face.seen
        if frame.gaze is not None:
            face.gaze = limit_gaze(frame.gaze)
            face.looks = face.looks or any(face.gaze)

    def _channel_names(self) -> ChannelNames:
        """The names of the cast that plays, ARKit's first."""
        cast = self._session().cast
        if self._names is None or self._names[0] is not cast:
            channels = [name for name in cast.expressions if name != NEUTRAL]
            arkit = [name for name in ARKIT_NAMES if name in cast.expressions]
            self._names = cast, ChannelNames(dict.fromkeys([*arkit, *channels]))
        return self._names[1]

    def _drive(self, face: TrackedFace, frame: TrackerFrame, now: float) -> list[str]:
        """Sends a frame to the session; returns the reasons of rejections."""
        session = self._session()
        if not (face.names or face.turns or face.looks or face.seen):
            return []
        face.join(session)
        refused = face.open(session, "tracker", face.names, now) if face.index is None else []
        if face.index is None:
            return refused
        values = face.values.astype("<f4").tobytes()
        head = face.head if face.turns else None
        gaze = face.gaze if face.looks else None
        body, seen = _body(face)
        drive = Drive(face.index, values, head, gaze, frame.found, body=body, seen=seen)
        return refusals(session.receive(face.who, drive, now))

    def reject(self, host: str, reason: str, now: float) -> None:
        """Counts what was not obeyed. host: the sender's; reason: why; now: seconds of the show's clock."""
        self.rejected += 1
        self.last_rejection = Rejection(now, self._sender(host), reason)


def _body(face: TrackedFace) -> tuple[bytes, list[PoseRegion]]:
    """What a frame says of a performer's body; nothing until a region of it has moved."""
    if face.bones is None or not face.seen:
        return b"", []
    from omote.inputs.trackers.body_pose import body_frame, builtin_rest  # SciPy, for those who have a body alone

    frame = body_frame(builtin_rest(), face.bones, face.seen)
    return pack_pose(frame.numbers), list(frame.regions)


def _unsaid(face: TrackedFace, names: Mapping[str, str]) -> list[str]:
    """The names of which nothing was said yet; from now on it is."""
    unsaid = [name for name in names if name[:LONGEST_NAME] not in face.said][: MOST_SAID - len(face.said)]
    face.said.update(name[:LONGEST_NAME] for name in unsaid)
    return unsaid


def _list(words: list[str]) -> str:
    more = f" and {len(words) - MOST_LISTED} more" if len(words) > MOST_LISTED else ""
    return ", ".join(word[:LONGEST_NAME] for word in words[:MOST_LISTED]) + more


def _values(face: TrackedFace) -> dict[str, float]:
    """What a face sent last, by channel, and its angles; as far as bars show it."""
    weights = dict(islice(zip(face.names, face.values.tolist(), strict=True), MOST_BARS))
    turned = zip(HEAD_LIMITS.items(), face.head, strict=True) if face.turns else ()
    looks = zip(GAZE_LIMITS.items(), face.gaze, strict=True) if face.looks else ()
    angles = {f"head {name}": 0.5 + 0.5 * angle / most for (name, most), angle in turned}
    return {**weights, **angles, **{f"gaze {name}": 0.5 + 0.5 * angle / most for (name, most), angle in looks}}


def _take_names(face: TrackedFace, sent: tuple[str, ...], names: ChannelNames) -> None:
    """Finds the channels of the names that a frame has; with other channels it is another source."""
    shares = [names.shares(name) for name in sent]
    places = [(index, *channel_share) for index, meant in enumerate(shares) for channel_share in meant.items()]
    face.strange = tuple(name for name, meant in zip(sent, shares, strict=True) if not meant)
    earlier = face.names if face.cast is names else ()
    channels = tuple(name for name in names.channels if name in {*earlier, *(channel for _, channel, _ in places)})
    if channels != face.names:
        before = dict(zip(face.names, face.values.tolist(), strict=True))
        face.names = channels
        face.index = None
        face.values = np.array([before.get(name, 0.0) for name in channels], np.float32)
    order = {name: place for place, name in enumerate(channels)}
    face.sent = sent
    face.cast = names
    face.taken = np.array([index for index, _, _ in places], np.intp)
    face.places = np.array([order[channel] for _, channel, _ in places], np.intp)
    face.shares = np.array([share for _, _, share in places], np.float32)
    face.several = len({*face.places.tolist()}) < len(places)
