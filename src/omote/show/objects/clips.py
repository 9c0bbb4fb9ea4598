"""Motion clips: what is kept of them, who plays them, and who records and edits their lanes."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar

import msgspec

from omote.model.known_names import NEUTRAL, PLAY_REGIONS
from omote.perform.clips.clip import LONGEST_LANE_NAME, LONGEST_SOUND_KEY, Clip, Lane, Span
from omote.perform.clips.clip_parts import CLIP_PARTS, ClipPart
from omote.perform.clips.clip_runs import LONGEST_CLIP_NAME
from omote.perform.clips.motion_curve import MotionCurve
from omote.perform.clips.outline import outline_lane
from omote.perform.clips.packed_motion import PackedMotion, pack_motion, unpack_motion
from omote.perform.clips.sample import CHANNEL
from omote.perform.performer import Performer
from omote.show.access.access_role import AccessRole
from omote.show.declaration import (
    CallId,
    CharacterCommand,
    CharacterName,
    ClientMessage,
    Outgoing,
    RequestId,
    ServerMessage,
    Session,
    characters_of,
)
from omote.show.objects.documents import NAMES_OF, READ_ROUTES, Document, DocumentNames, address_of
from omote.show.osc import PRESS, Value, osc

CLIP_OUTLINE_PATH = "/clip_outlines/{name}"
ClipName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_CLIP_NAME), Value("text")]
LaneName = Annotated[str, msgspec.Meta(max_length=LONGEST_LANE_NAME)]
SoundKey = Annotated[str, msgspec.Meta(max_length=LONGEST_SOUND_KEY)]
MOST_CLIPS = 256


# --- what is stored ---


@dataclass(frozen=True)
class StoredSpan:
    """What replaces a lane from `start` to `stop`, seconds of its own time."""

    start: float
    stop: float
    motion: PackedMotion


@dataclass(frozen=True)
class StoredLane:
    """A lane of a clip, as of `Lane`."""

    motion: PackedMotion
    name: str = ""
    parts: tuple[ClipPart, ...] = CLIP_PARTS
    weight: float = 1.0
    muted: bool = False
    shift: float = 0.0
    spans: tuple[StoredSpan, ...] = ()


class StoredClip(Document, frozen=True):
    """A motion clip, under its name."""

    kind: ClassVar[str] = "clip"
    read_by: ClassVar[AccessRole | None] = "view"
    most: ClassVar[int] = MOST_CLIPS

    lanes: tuple[StoredLane, ...]
    start: float = 0.0
    stop: float | None = None
    blend_in: float = 0.3
    blend_out: float = 0.3
    loop: bool = False
    speed: float = 1.0
    sound: str = ""
    sound_at: float = 0.0

    def names(self) -> Iterable[str]:
        """The expressions and channels that it moves."""
        motions = [motion for lane in self.lanes for motion in (lane.motion, *(span.motion for span in lane.spans))]
        named = {column.partition("/")[::2] for motion in motions for column in motion.columns}
        return sorted({name for part, name in named if part in (CHANNEL, *PLAY_REGIONS)} - {NEUTRAL})


CLIP_SETTINGS = tuple(each.name for each in dataclasses.fields(Clip) if each.init and each.name != "lanes")
"""What is set of a clip beside its lanes."""


def stored_clip(clip: Clip) -> StoredClip:
    """A clip as the show file keeps it."""
    packed = dict[MotionCurve, PackedMotion]()

    def pack(curve: MotionCurve) -> PackedMotion:
        if curve not in packed:
            packed[curve] = pack_motion(curve)
        return packed[curve]

    lanes = tuple(
        StoredLane(
            pack(lane.curve),
            lane.name,
            lane.parts,
            lane.weight,
            lane.muted,
            lane.shift,
            tuple(StoredSpan(span.start, span.stop, pack(span.curve)) for span in lane.spans),
        )
        for lane in clip.lanes
    )
    return StoredClip(lanes, **{name: getattr(clip, name) for name in CLIP_SETTINGS})


def clip_of(stored: StoredClip) -> Clip:
    """The clip that the show file keeps; ValueError where it is damaged, or none."""
    lanes = [
        Lane(
            unpack_motion(lane.motion),
            lane.name,
            lane.parts,
            lane.weight,
            lane.muted,
            lane.shift,
            tuple(Span(span.start, span.stop, unpack_motion(span.motion)) for span in lane.spans),
        )
        for lane in stored.lanes
    ]
    return Clip(lanes, **{name: getattr(stored, name) for name in CLIP_SETTINGS})


class Clips(DocumentNames, frozen=True):
    """The names of all clips in the show file, sorted: complete, to consoles after the welcome and with each change.
    `GET /clips/NAME` gives one, its lanes with all that is set of them."""

    of = StoredClip


NAMES_OF[StoredClip.kind] = Clips
READ_ROUTES[address_of(StoredClip.kind)] = "view"


# --- what pages are told of them ---


class ClipPass(msgspec.Struct, frozen=True):
    """A pass that is recorded. `name`: of the clip; `parts`, `lane`: of the new lane; `by`: who records it. It began at
    `began`, of `State.time`, where the time of the clip was `start`, and a second of the show is `speed` of it."""

    character: str
    name: str
    parts: list[ClipPart]
    lane: str
    by: str
    began: float
    start: float
    speed: float = 1.0


class ClipWork(ServerMessage, frozen=True):
    """What is done with clips: complete, to consoles after the welcome and with each change. `passes`: those that are
    recorded; `edits`: changes with each edit of a clip, and `/clip_outlines/NAME` has it."""

    passes: list[ClipPass]
    edits: int


class LaneOutline(msgspec.Struct, frozen=True):
    """A lane to be drawn: `start`, `stop`: seconds of the clip, with its shift; `spans`: from where to where another
    pass replaces it; `moves`: the few columns that it moves most, each at equal steps from start to stop, weights and
    parts of the most that head or gaze turn."""

    name: str
    parts: list[ClipPart]
    weight: float
    muted: bool
    shift: float
    start: float
    stop: float
    spans: list[tuple[float, float]]
    moves: dict[str, list[float]]


class ClipOutline(msgspec.Struct, frozen=True):
    """A clip to be drawn, as `/clip_outlines/NAME` returns it (JSON): as of `StoredClip`, but its lanes without their
    motion; `stop`: where it ends in any case, with its last lane where it is not `trimmed`. `edits`: as of
    `clip_work`."""

    name: str
    start: float
    stop: float
    trimmed: bool
    blend_in: float
    blend_out: float
    loop: bool
    speed: float
    sound: str
    sound_at: float
    lanes: list[LaneOutline]
    edits: int


def outline_clip(name: str, clip: Clip, edits: int) -> ClipOutline:
    """A clip to be drawn. name: of the clip; edits: how many there were of clips."""
    lanes = [
        LaneOutline(
            lane.name,
            list(lane.parts),
            lane.weight,
            lane.muted,
            lane.shift,
            lane.start,
            lane.stop,
            [(span.start + lane.shift, span.stop + lane.shift) for span in lane.spans],
            outline_lane(lane),
        )
        for lane in clip.lanes
    ]
    trimmed = clip.stop is not None
    shown = (clip.start, clip.end, trimmed, clip.blend_in, clip.blend_out, clip.loop, clip.speed)
    return ClipOutline(name, *shown, clip.sound, clip.sound_at, lanes, edits)


# --- what plays them ---


class PlayClip(CharacterCommand, frozen=True):
    """A character plays a clip on the layer playback, from whatever shows, in `seconds` (`None`: as the clip says). It
    begins `start` seconds from its start; `speed` and `loop`: `None` as the clip says. `weights`: how much of it shows
    in brows, eyes, mouth, rest, head and gaze, 0..1; what is not named is left alone; all of it where none is. An `id`
    executes once. A clip that plays already makes way, and a panic ends it."""

    osc = (
        osc("clip", "plays the clip of this name", "name", Value("time", high=3600.0, unit="s", name="seconds")),
        osc(
            "clip/{name}",
            "the same for a button, when it is pressed",
            PRESS,
            Value("time", high=3600.0, unit="s", name="seconds"),
        ),
    )

    id: CallId
    name: ClipName
    seconds: Annotated[float | None, Value("time", high=3600.0, unit="s")] = None
    start: float = 0.0
    speed: float | None = None
    loop: bool | None = None
    weights: dict[str, float] = {}

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it: the scene knows the clip of a name. session: the show; who: the client; now: seconds, monotonic."""
        for character in characters_of(session.scene, self.character):
            session.scene.play_clip(
                character,
                self.name,
                seconds=self.seconds,
                start=self.start,
                speed=self.speed,
                loop=self.loop,
                weights=self.weights or None,
            )
        return ()


class StopClip(CharacterCommand, frozen=True):
    """A character ends a clip (`name`; "": all that it plays) in `seconds` (`None`: as the clip says)."""

    osc = (osc("stop_clip", "ends the clips that it plays", Value("time", high=3600.0, unit="s", name="seconds")),)

    name: Annotated[str, msgspec.Meta(max_length=LONGEST_CLIP_NAME)] = ""
    seconds: Annotated[float | None, Value("time", high=3600.0, unit="s")] = None
    id: RequestId = ""

    def play(self, performer: Performer) -> None:
        """Ends it."""
        performer.stop_clip(self.name, seconds=self.seconds)


# --- what records and edits them ---


class ClipCommand(ClientMessage, frozen=True):
    """An edit of clips: what plays goes on as it was called. An `id` executes once, as of all that follow; answered
    with `clips` where their names change."""

    access = "edit"
    recorded = False
    method: ClassVar[str | None] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Edits the clips. session: the show; who: the client; now: seconds, monotonic."""
        return session.clips.edit(self, session.members[who].name)  # type: ignore[no-any-return]


class RecordClip(ClipCommand, frozen=True):
    """Records a pass of what shows of a character from now on: some `parts` of it (none: all), as a new lane of a clip
    (`name`), which is made where there is none. What else the clip has plays meanwhile, from its start, or from
    `start`, seconds of the clip; and its sound without lips. It ends by `keep_pass`, and by itself after ten minutes.
    `lane`: what to call it. `sound`: the key of one that the clip has from this pass on, as of `edit_clip`; it begins
    in .4 s. `speed`: .25 to 1 seconds of the clip a second; what it has plays so, what is recorded is kept in the
    clip's own time, and below 1 no sound is heard."""

    osc = (osc("record_clip", "records what shows as a pass of the clip of this name", "name"),)

    id: CallId
    character: CharacterName
    name: ClipName
    parts: list[ClipPart] = []
    lane: LaneName = ""
    sound: SoundKey = ""
    start: float | None = None
    speed: float = 1.0


class KeepPass(ClipCommand, frozen=True):
    """Ends the pass of a character and keeps it; `keep`: or forgets it."""

    osc = (osc("keep_pass", "ends the pass that is recorded, and keeps it", PRESS),)

    id: CallId
    character: CharacterName
    keep: bool = True


class EditClip(ClipCommand, frozen=True):
    """Changes what is given of a clip: where it begins and ends (seconds of its lanes), in how many seconds it comes
    and goes, whether it begins again at its end, and its speed. `sound`: the key of one that was sent to `/sounds`,
    which is heard with it, without lips, from `sound_at` on (seconds of its lanes); "": none. At another speed than 1
    nothing is heard; the state's `clips` say why."""

    id: CallId
    name: ClipName
    start: float | None = None
    stop: float | None = None
    blend_in: float | None = None
    blend_out: float | None = None
    loop: bool | None = None
    speed: float | None = None
    sound: SoundKey | None = None
    sound_at: float | None = None


class EditLane(ClipCommand, frozen=True):
    """Changes what is given of a lane of a clip (`lane`: its name, or its number from 1): its name, its parts, how much
    of it shows, whether it is muted, and by how many seconds it comes later."""

    id: CallId
    name: ClipName
    lane: LaneName
    to: LaneName | None = None
    parts: list[ClipPart] | None = None
    weight: float | None = None
    muted: bool | None = None
    shift: float | None = None


class ReplaceSpan(ClipCommand, frozen=True):
    """Replaces a lane of a clip from `start` to `stop`, seconds of the clip, by another lane of it (`by`), which is no
    lane of its own any more."""

    id: CallId
    name: ClipName
    lane: LaneName
    by: LaneName
    start: float
    stop: float


class DropLane(ClipCommand, frozen=True):
    """Takes a lane out of a clip; the last one stays."""

    id: CallId
    name: ClipName
    lane: LaneName


class RenameClip(ClipCommand, frozen=True):
    """Gives a clip another name, which none has yet. Cues call it by its name: they are to be changed too."""

    id: CallId
    name: ClipName
    to: ClipName


class CopyClip(ClipCommand, frozen=True):
    """Copies a clip under another name, which none has yet."""

    id: CallId
    name: ClipName
    to: ClipName


class DropClip(ClipCommand, frozen=True):
    """Takes a clip out of the show; `restore_clip` brings it back until the server restarts."""

    id: CallId
    name: ClipName


class RestoreClip(ClipCommand, frozen=True):
    """Brings back the clip that was dropped last under a name."""

    id: CallId
    name: ClipName


def read_clips(documents: Mapping[str, bytes]) -> tuple[dict[str, Clip], list[str]]:
    """The clips that a show file keeps, and which cannot be read, in sentences: one costs itself.

    documents: those (JSON) of the kind, by name.
    """
    clips = dict[str, Clip]()
    lost = list[str]()
    for name, body in documents.items():
        try:
            clips[name] = clip_of(msgspec.json.decode(body, type=StoredClip))
        except (ValueError, TypeError, RecursionError) as error:
            lost.append(f"the clip {name} cannot be read ({error}) and is left out.")
    return clips, lost
