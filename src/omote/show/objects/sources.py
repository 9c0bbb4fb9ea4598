"""Sources: trackers, microphones and programs that send values all the time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec

from omote.model.body.pose_regions import PoseRegion
from omote.perform.layers.layer_names import LayerName, RoutePart
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.show.declaration import (
    MOST_NAMES,
    CallId,
    CharacterName,
    ClientMessage,
    Name,
    Outgoing,
    RequestId,
    ServerMessage,
    Session,
)

StreamKind = Literal["tracker", "lips", "playback", "program", "breath", "gaze", "blink"]
CalibrationStep = Literal["neutral", "range", "done", "reset"]


class Source(ClientMessage, frozen=True):
    """Something that sends values all the time: a tracker, a microphone, a program. `names`: the expressions (channels)
    that each of its frames has a value for. `characters`: whom it drives, where it says so; else the route that was
    made for its name the last time. `performer`: whose face it sees, by whose calibration it is read; "" for one of its
    own. `smoothing`: seconds, to 2, in which its steps are followed, 0 as its layer is. `direct`: its frames are smooth
    already and show as they are. Answered with `source_is`; the end of its link is its end."""

    access = "operate"
    once = False

    name: Name
    kind: StreamKind
    names: Annotated[list[Name], msgspec.Meta(max_length=MOST_NAMES)]
    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)] = []
    performer: Annotated[str, msgspec.Meta(max_length=80)] = ""
    id: RequestId = ""
    smoothing: float = 0.0
    direct: bool = False

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Opens it, and answers with its index. session: the show; who: the client; now: seconds, monotonic."""
        return [Outgoing(who, session.sources.begin(who, self, session.scene, session.cast))]


class Drive(ClientMessage, frozen=True):
    """One frame of a source, the newest wins: `values` as float32, little-endian, in the order of its names, -0.5..1.5;
    `head` (yaw, pitch, roll) and `gaze` (yaw, pitch) in radians, or `None`. `found`: false while it does not see its
    performer. Half a second without one that is found, and its layers fade out. `share`, of a direct source: how much
    of its layer it takes, 0..1; none while a voice is silent, so that what lies below shows. `body`: what the
    performer's body does, beside where the head looks, as `pose` of the state has it, `b""` for none; `seen`: which
    regions of it."""

    access = "operate"

    index: int
    values: Annotated[bytes, msgspec.Meta(max_length=4 * MOST_NAMES)]
    head: tuple[float, float, float] | None = None
    gaze: tuple[float, float] | None = None
    found: bool = True
    share: float = 1.0
    body: Annotated[bytes, msgspec.Meta(max_length=2048)] = b""
    seen: Annotated[list[PoseRegion], msgspec.Meta(max_length=5)] = []

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.drive(who, self, session.scene)
        return ()


class LeaveSource(ClientMessage, frozen=True):
    """A source of this link ends; its layers fade out."""

    access = "operate"

    index: int

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.end(who, self.index, session.scene)
        return ()


class SourceSetting(ClientMessage, frozen=True):
    """Sets how a source is read, or whom it plays, by its name. An `id` executes once."""

    access = "operate"

    id: CallId
    source: Name


class RouteSource(SourceSetting, frozen=True):
    """Which characters a source drives, on which layer, in which regions (none named: all). It stays with the show
    under the source's name. An `id` executes once, as of the two below."""

    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)]
    layer: LayerName
    regions: Annotated[list[RoutePart], msgspec.Meta(max_length=7)] = []

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.reroute(self, session.scene)
        return ()


class CalibrateSource(SourceSetting, frozen=True):
    """Measures the performer before a source: `neutral` takes what it sends now as the face at rest, `range` listens to
    the performer's largest moves until `done`, `reset` forgets both. `channels`: those that a range is of; none named:
    all. It stays with the show under the performer."""

    step: CalibrationStep
    channels: Annotated[list[Name], msgspec.Meta(max_length=MOST_NAMES)] = []

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.calibrate(self, session.scene)
        return ()


class MeasureSource(SourceSetting, frozen=True):
    """Sets what was measured of the performer before a source, by channel: the face at rest and the largest moves, as
    `SourceState` tells them. So a measure is taken back, or comes from a program."""

    method = ""

    neutral: dict[str, float]
    highest: dict[str, float]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.measure(self, session.scene)
        return ()


class TuneSource(SourceSetting, frozen=True):
    """How a source is read: `mirror` swaps left and right; less than `dead_zone` (0..0.5) is nothing; `curve` -1..1:
    above 0 small moves grow, below they shrink; `gain` 0..4 of all channels, `lids` 0..4 beside it of those that shut
    the eyes; `smoothing` 0..2: seconds in which a step is followed, 0 as the source asks or its layer is."""

    method = ""

    mirror: bool = False
    dead_zone: float = 0.0
    curve: float = 0.0
    gain: float = 1.0
    smoothing: float = 0.0
    lids: float = 1.0

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.tune(self, session.scene)
        return ()


class WatchSource(ClientMessage, frozen=True):
    """Asks for what a source sends, as it comes (`SourceValues`): for a page that shows it; "" ends it."""

    access = "operate"
    recorded = False

    source: Annotated[str, msgspec.Meta(max_length=80)]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Tells the sources of the session. session: the show; who: the client; now: seconds, monotonic."""
        session.sources.watch(who, self.source)
        return ()


class SourceIs(ServerMessage, frozen=True):
    """Answers source: the index by which this link's frames name it."""

    index: int
    name: str


class SourceState(msgspec.Struct, frozen=True):
    """A source that sends: `console` is the name of the link that it comes by; its route; `rate`: frames in the last
    second; `found`: whether it sees its performer. `ranging`: it listens to the performer's largest moves. `neutral`,
    `highest`: what was measured, by channel. `body`: it sees a body."""

    name: str
    kind: StreamKind
    console: str
    characters: list[str]
    layer: LayerName
    regions: list[RoutePart]
    performer: str
    rate: int
    found: bool
    calibrated: bool
    ranging: bool
    mirror: bool
    dead_zone: float
    curve: float
    gain: float
    smoothing: float = 0.0
    lids: float = 1.0
    neutral: dict[str, float] = {}
    highest: dict[str, float] = {}
    body: bool = False


class Sources(ServerMessage, frozen=True):
    """All sources that send: complete, to consoles once a second and with each change."""

    sources: list[SourceState]


class SourceValues(ServerMessage, frozen=True):
    """What a source that is watched sends now, and what its measure makes of it: `sent` and `weights` as float32,
    little-endian, in the order of `names`; up to twenty times a second."""

    source: str
    names: list[str]
    sent: bytes
    weights: bytes
