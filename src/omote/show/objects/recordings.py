"""The recording of a show that is always on: moments are marked, and what was played is kept under a name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import msgspec

from omote.perform.clips.clip import LONGEST_LANE_NAME
from omote.perform.layers.layer_names import LayerPart
from omote.perform.limits import check_known, check_within
from omote.show.access.access_role import AccessRole
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
CURVES_PATH = "/curves"
MARKERS_PATH = "/markers"
MARKER_PATH = "/markers/{id}"
LONGEST_MARK = 400
"""Letters of what a marker says: a note of a director."""
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
    text: Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_MARK), Value("text")]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Does nothing else: the recording holds the message. session: the show; who: the client; now: seconds,
        monotonic."""
        if not session.recorder.records:
            raise ValueError("this show is not recorded, so no moment of it can be marked")
        return ()


class RecordingRequest(ClientMessage, frozen=True):
    """What a console asks of the recording; the server carries it out."""

    recorded = False

    id: CallId
    name: Name

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps the request for the server. session: the show; who: the client; now: seconds, monotonic."""
        if not session.recorder.records:
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
    """A moment that somebody (`who`) marked: when, seconds since 1970, and seconds of the clock of a start of the show;
    `name`: what it says; `cue`: the number of the cue that was called last then, "" for none. `id`: of the marker."""

    id: int
    start: int
    at: float
    written: float
    name: str
    who: str
    cue: str = ""


class RecordingsDocument(msgspec.Struct, frozen=True):
    """What is recorded, as `/recordings` returns it (JSON): the ring, what is kept of it, and markers; the oldest
    first. `files`: the names of the show files; `?file=1` asks for what is recorded of the second. `name`: of who asks,
    as the show knows it; `role`: what it may do; `now`: seconds since 1970, where the show plays; `cue`: the one
    that was called last of all."""

    spans: list[RecordedSpan]
    kept: list[RecordedSpan]
    markers: list[MarkedMoment]
    files: list[str] = []
    name: str = ""
    role: AccessRole = "view"
    now: float | None = None
    cue: str = ""


class MarkerRequest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a page asks of markers, as `/markers` takes it (JSON): a new one (POST), or other words for one that is
    there (POST to `/markers/ID`). `start` and `at`: when, as of `MarkedMoment`; left out, while the show plays, it
    is now, or `before` so many seconds. `who`: who marks it, where the show asks nobody for a token."""

    name: Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_MARK)]
    before: Annotated[float, msgspec.Meta(ge=0, le=3600)] = 0.0
    start: int = 0
    at: float = 0.0
    who: Annotated[str, msgspec.Meta(max_length=40)] = ""


class CalledCue(msgspec.Struct, frozen=True):
    """A cue that was called: when, seconds from the beginning of the run, of which list, by number."""

    at: float
    cue_list: str
    number: str


class RunDocument(msgspec.Struct, frozen=True):
    """What showed in a part of a recording, as `/curves?start=1&first=12.5&last=90` returns it (MessagePack): `start`,
    `first`, `seconds` as of `RecordedSpan`; the cues that were called; and the curves as they are kept, a piece a
    minute, which may have more than was asked for. None: it was recorded without.

    A piece is deflated (zlib), MessagePack, a list: seconds of its first sample; milliseconds between samples (unsigned
    32 bits, little endian, the first 0); names; by character the steps between samples (16 bits, little endian, which
    wrap; the first from 0), column by column: those of `quantities`, which says how many steps are one, then two places
    in the names, of the face and of the expression that showed most. A sum of -32768: it was not there. Weights are
    those of `face`, `expression`, and of the strongest expression or channel of a region; head and gaze are in degrees,
    `x` and `depth` in metres.
    """

    start: int
    first: float
    seconds: float
    quantities: dict[str, float]
    pieces: list[bytes]
    cues: list[CalledCue]
