"""The recording of a show that is always on: moments are marked, and what was played is kept under a name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import msgspec

from omote.perform.clips.clip import LONGEST_LANE_NAME
from omote.perform.layers.layer_names import LayerPart
from omote.perform.limits import check_known, check_within
from omote.show.declaration import (
    CallId,
    CharacterName,
    ClientMessage,
    KeepRequest,
    Name,
    Outgoing,
    ServerMessage,
    Session,
)
from omote.show.osc import Value, osc

RECORDINGS_PATH = "/recordings"
LONGEST_KEPT_CLIP = 600.0
"""Seconds."""
LONGEST_KEPT = 100.0
"""Minutes that are recorded: a night."""


class MarkMoment(ClientMessage, frozen=True):
    """Marks this moment of the recording by a name, for whoever looks at it later. An `id` executes once, as of all
    that follow."""

    access = "operate"
    method = ""
    osc = (osc("mark", "marks this moment of the recording", "text", of_show=True),)

    id: CallId
    text: Annotated[str, msgspec.Meta(min_length=1, max_length=80), Value("text")]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Does nothing else: the recording holds the message. session: the show; who: the client; now: seconds,
        monotonic."""
        if session.recorder is None:
            raise ValueError("this show is not recorded, so no moment of it can be marked")
        return ()


class RecordingRequest(ClientMessage, frozen=True):
    """What a console asks of the recording; the server carries it out."""

    recorded = False

    id: CallId
    name: Name

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps the request for the server. session: the show; who: the client; now: seconds, monotonic."""
        if session.recorder is None:
            raise ValueError("this show is not recorded")
        session.recording_requests.append(KeepRequest(who, self))
        return ()


class KeepRecording(RecordingRequest, frozen=True):
    """Keeps what was played in the last `minutes` under a name, which the ring of 100 minutes would lose. Answered with
    `recording_kept`."""

    access = "operate"
    method = ""

    minutes: float = 10.0

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps the request; ValueError for no time. session: the show; who: the client; now: seconds, monotonic."""
        check_within(self.minutes, 0.01, LONGEST_KEPT, "minutes")
        return super().act(session, who, now)


class KeepClip(RecordingRequest, frozen=True):
    """Keeps what showed of a character in the last `seconds` as a motion clip; one of that name gets one more lane, of
    `parts` (none: all), called `lane`. Answered with `recording_kept`, once it is cut."""

    access = "edit"
    method = ""
    osc = (osc("keep_clip", "keeps what showed of it in the last seconds as a clip", "name", "seconds"),)

    character: CharacterName
    name: Annotated[Name, Value("text")]
    seconds: Annotated[float, Value("time", low=0.1, high=LONGEST_KEPT_CLIP, unit="s", default=10.0)] = 10.0
    parts: list[LayerPart] = []
    lane: Annotated[str, msgspec.Meta(max_length=LONGEST_LANE_NAME)] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps the request; ValueError where nobody is called so. session: the show; who: the client; now: seconds,
        monotonic."""
        check_known(self.character, session.scene, "character")
        return super().act(session, who, now)


class DeleteRecording(RecordingRequest, frozen=True):
    """Keeps a recording no longer. Answered with `recording_kept`."""

    access = "admin"
    method = ""


class RecordingKept(ServerMessage, frozen=True):
    """Answers keep_recording, keep_clip and delete_recording: it is done. `name`: of the recording, or of the clip."""

    id: str
    name: str


class RecordedSpan(msgspec.Struct, frozen=True):
    """What was recorded without a break: from when, seconds since 1970, and how long, seconds. `start`: which start of
    the show; `first`: seconds of its clock; `name`: of one that is kept."""

    start: int
    first: float
    written: float
    seconds: float
    name: str = ""


class MarkedMoment(msgspec.Struct, frozen=True):
    """A moment that somebody marked: when, seconds since 1970, and seconds of the clock of a start of the show."""

    start: int
    at: float
    written: float
    name: str
    who: str


class RecordingsDocument(msgspec.Struct, frozen=True):
    """What is recorded, as `/recordings` returns it (JSON): the ring, what is kept of it, and markers; the oldest
    first."""

    spans: list[RecordedSpan]
    kept: list[RecordedSpan]
    markers: list[MarkedMoment]
