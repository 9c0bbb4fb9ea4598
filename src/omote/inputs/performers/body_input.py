"""Bodies before cameras at a show session: each is a source beside its performer's face."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from omote.inputs.camera.body_points import BodyPoints, read_body_points
from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.source_route import SourceChoice, route_source
from omote.inputs.rejection import PacketError
from omote.inputs.trackers.body_bones import BodyBones
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TrackerProtocol
from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.show.session import ShowSession

if TYPE_CHECKING:
    from omote.inputs.camera.body_tracker import BodyReading, BodyTracker

HALF = 0.5
"""Of a region, how much of it is tracked before it plays: the show fades from there."""
MOST_WAITING = 8
"""Packets that wait for the next tick; the newest push the oldest out."""


def _decode_nothing(_: bytes) -> list[TrackerFrame]:
    """Its frames come as points, each read by its performer."""
    return []


BODY = TrackerProtocol(
    "body", "Body", None, "open the page /camera of this show in the performer's browser and switch the body on",
    lambda _: _decode_nothing,
)  # fmt: skip


def _open_tracker() -> BodyTracker:
    from omote.inputs.camera.body_tracker import BodyTracker  # SciPy, for those who have a body alone

    return BodyTracker()


@dataclass(eq=False)
class TrackedBody:
    """One performer's. follows: whether it plays whom the performer's face plays, as nobody has said whom; choice: what
    it is to play, until it is routed; heard: frames of it."""

    tracker: BodyTracker = field(default_factory=_open_tracker)
    waiting: deque[BodyPoints] = field(default_factory=lambda: deque(maxlen=MOST_WAITING))
    reading: BodyReading | None = None
    follows: bool = True
    choice: SourceChoice | None = None
    heard: int = 0


class BodyInput:
    """The bodies of all performers before cameras. session: the show that plays; faces: those of the same performers,
    whose characters a body plays until it is told whom; heard: frames of all of them."""

    def __init__(self, session: Callable[[], ShowSession], faces: TrackerInput) -> None:
        self.trackers = TrackerInput(BODY, session)
        self._session = session
        self._faces = faces
        self._bodies: dict[str, TrackedBody] = {}
        self.heard = 0

    def receive(self, name: str, packet: bytes, now: float) -> str:
        """Takes a frame, for the next tick; returns why it is none, "" where it is.

        name: the performer's; packet: the page's; now: seconds of the show's clock.
        """
        body = self._body(name)
        self.heard += 1
        body.heard += 1
        try:
            body.waiting.append(read_body_points(packet))
        except PacketError as error:
            self.trackers.reject(name, str(error), now)
            return str(error)
        return ""

    def obey(self, name: str, message: wire.BodyMessage) -> None:
        """Chooses whose figure a performer's body plays, from its first frame on, or takes the next two seconds as how
        it is at rest; ValueError for a character that there is not.

        name: the performer's; message: what is asked.
        """
        if isinstance(message, wire.RestBody):
            self._body(name).tracker.measure_again()
            return
        characters = [check_known(character, self._session().scene, "character") for character in message.characters]
        body = self._body(name)
        body.choice = SourceChoice(characters, ["body"])
        body.follows = False

    def play(self, now: float) -> None:
        """Drives the session by the newest frame of each body. now: seconds of the show's clock."""
        for name, body in self._bodies.items():
            while body.waiting:
                body.reading = body.tracker.step(body.waiting.popleft())
                self.trackers.note("", _frame(name, body.reading))
        self.trackers.play(now)
        for name, body in self._bodies.items():
            if body.follows:
                self._follow_face(name, body)
            if body.choice is not None and self.trackers.client("", name) is not None:
                if reason := route_source(self._session(), self.trackers, name, body.choice, now):
                    self.trackers.reject(name, reason, now)
                body.choice = None

    def end(self, name: str) -> None:
        """Ends the source of a performer's body; what it plays stays with the show."""
        self.trackers.end("", name)
        self._bodies.pop(name, None)

    def choice(self, name: str) -> wire.BodyChoice:
        """What a performer's body plays, or will once it is seen."""
        session = self._session()
        body = self._bodies.get(name, TrackedBody())
        route = session.sources.route(self.trackers.title("", name))
        played = list(route.characters) if body.choice is None else body.choice.characters
        choices = [
            wire.CharacterChoice(character, label, character in played or ALL in played)
            for character, label in session.scene.labels.items()
        ]
        shares = {} if body.reading is None else body.reading.shares
        return wire.BodyChoice(
            choices,
            body.tracker.rest is not None,
            body.heard,
            {region: round(share, 2) for region, share in shares.items()},
        )

    def _body(self, name: str) -> TrackedBody:
        if name not in self._bodies:
            known = self._session().sources.remembers(self.trackers.title("", name))
            self._bodies[name] = TrackedBody(follows=not known)
        return self._bodies[name]

    def _follow_face(self, name: str, body: TrackedBody) -> None:
        """Has a body that comes for the first time play whom its performer's face plays, once that plays somebody."""
        sources = self._session().sources
        if sources.route(self.trackers.title("", name)).characters:
            body.follows = False
        elif faces := sources.route(self._faces.title("", name)).characters:
            body.choice = SourceChoice(list(faces), ["body"])
            body.follows = False


def _frame(name: str, reading: BodyReading) -> TrackerFrame:
    """What a reading drives. name: the performer's."""
    seen = frozenset(region for region, share in reading.shares.items() if share > HALF)
    turns = {bone: (x, y, z, w) for bone, (x, y, z, w) in reading.bones.items()}
    bones = BodyBones(turns, seen=seen)
    return TrackerFrame(found=bool(seen), time=reading.time, subject=name, bones=bones)
