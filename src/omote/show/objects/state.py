"""All that is on air, as stages and consoles get it sixty times a second."""

from __future__ import annotations

import math
from collections.abc import Mapping

import msgspec

from omote.model.body.pose_regions import PoseRegion
from omote.model.known_names import PlayRegion
from omote.perform.complexion import SkinFader
from omote.perform.frame import NO_IDLE, TargetKind
from omote.perform.layers.layer_names import LayerName
from omote.perform.springs.cast_springs import SpringName
from omote.show.declaration import ServerMessage
from omote.show.objects.cues import CueName, CueStatus
from omote.show.objects.link import Bus


class CallState(msgspec.Struct, frozen=True):
    """A running call: `progress` 0..1, `remaining` seconds (`None`: the T-bar decides).

    `fader`: where its T-bar stands; `pickup`: where that takes over. Both 0..1. `start`: the mix that it left.
    """

    target: str
    progress: float
    remaining: float | None
    by_hand: bool
    fader: float
    pickup: float
    start: dict[str, float]


class Place(msgspec.Struct, frozen=True):
    """Where a character is, in the eyes of the audience: `x` metres to the picture's right, `depth` metres behind the
    front line, `size` a factor, `turn` radians about the vertical, + to the character's own left, as the head's yaw."""

    x: float = 0.0
    depth: float = 0.0
    size: float = 1.0
    turn: float = 0.0


class LayerSource(msgspec.Struct, frozen=True):
    """One of the sources of a layer: how far it is trusted, and the parts that it has."""

    source: str
    trust: float
    parts: list[str]


class LayerState(msgspec.Struct, frozen=True):
    """A layer: its influence on brows, eyes, mouth, rest, head and gaze, and its switch, as set. `source`: what drives
    it, of several the one with the most parts, "" for nothing; `trust`: 0 lost, 1 followed. `share`: how much of it is
    on air where it shows most, 0..1; `strongest`: the few channels that it moves most now. `sources`: all of them where
    there are several, the newest first."""

    influence: list[float]
    on: bool
    trust: float
    source: str
    share: float
    strongest: dict[str, float]
    sources: list[LayerSource] = []


class HeldState(msgspec.Struct, frozen=True):
    """What hands hold, where layers mix it with what sources send: channels, head and gaze as faders stand."""

    channels: dict[str, float]
    head: tuple[float, float, float]
    gaze: tuple[float, float]


class GazeTargetState(msgspec.Struct, frozen=True):
    """Whom or what a character looks at, as of `look_at`."""

    kind: TargetKind = "ahead"
    name: str = ""
    yaw: float = 0.0
    pitch: float = 0.0
    x: float = 0.0
    y: float = 0.0
    z: float = 2.0


class MotionState(msgspec.Struct, frozen=True):
    """What is set of a character's automatic motion, as of `set_motion` and `look_at`."""

    liveliness: float
    blinks: float
    gaze: float
    breath: float
    seed: int
    idle: bool = False
    target: GazeTargetState = GazeTargetState()


class SpeechState(msgspec.Struct, frozen=True):
    """What a character says. `number`: counts all that it has said; `text`: its first 120 characters; `elapsed`:
    seconds since its sound began, below 0 before; `seconds`: its length. `sound`: the key of what a stage plays, ""
    for none; `waiting`: how many speeches follow, `next_sound`: the key of the next one's. `keys`: what
    programs call this one and those that follow, in their order."""

    number: int
    text: str
    elapsed: float
    seconds: float
    sound: str = ""
    waiting: int = 0
    next_sound: str = ""
    keys: list[str] = []


class ClipState(msgspec.Struct, frozen=True):
    """A clip that a character plays: `elapsed` seconds from its start, of `seconds`; `share`: how much of it shows,
    0..1; `loop`: whether it begins again; `missing`: expressions and channels of it that the cast does not have.
    `number` counts what the character has played, `turn` how often this has begun again. `sound`: the key of what is
    heard with it, "" for nothing, `heard` seconds since the sound began (below 0: until then); `silent`: why a clip
    that has a sound is not heard."""

    name: str
    elapsed: float
    seconds: float
    share: float
    loop: bool = False
    missing: list[str] = []
    number: int = 0
    sound: str = ""
    heard: float = 0.0
    turn: int = 0
    silent: str = ""


class MacroState(msgspec.Struct, frozen=True):
    """A macro: `value` -1..1, where its hand has it; `share`: how much of it shows, 0..1, by its condition, 0 until a
    hand moves it after a panic."""

    value: float
    share: float


class PadPointState(msgspec.Struct, frozen=True):
    """The point of a pad on a character: its `place`, -1..1 for each dimension; `plays`: what shows follows it, and
    nothing else has taken over since."""

    place: list[float]
    plays: bool = True


class TrackedState(msgspec.Struct, frozen=True):
    """The body of a performer whom a source sees. `shares`: how much of it shows in the head, the trunk, the left arm,
    the right arm and the stance, 0..1; `pose`: 16 bits a number, little-endian: the turns of the bones (a step of
    3.5 / 32767 radians), where the hips and both feet are (3 / 32767 leg lengths), the turns of the feet."""

    shares: list[float]
    pose: bytes


class FigureState(msgspec.Struct, frozen=True, omit_defaults=True):
    """What a figure does. `poses`: the mix, which sums to one, as those of `regions` that do another; `bodies`: the mix
    of bodies, in which "own" stands for those of the faces. `pose_call`, `region_calls`, `body_call`: what is called;
    `fader`: where the T-bar of the poses stands, 0..1. `tracked`: a performer's body, which shows in place of the mix;
    it is left out while there is none."""

    poses: dict[str, float]
    regions: dict[PoseRegion, dict[str, float]]
    bodies: dict[str, float]
    pose_call: CallState | None
    region_calls: dict[PoseRegion, CallState]
    body_call: CallState | None
    fader: float
    tracked: TrackedState | None = None


class CharacterState(msgspec.Struct, frozen=True):
    """All that a character has on air.

    `head`: yaw, pitch, roll; `gaze`: yaw, pitch; `eyes`: left yaw, pitch, right yaw, pitch (radians), as the eyeballs
    stand. `added`: to the channels, by name: what the gaze makes of lids, and below 0 what
    other expressions open or shut already. `face_fader`, `expression_fader`: where the T-bars stand, 0..1,
    with or without a call. `panics` counts them: when it rises, hands are off. `home_next`: the next one brings
    `home_face` in `home_seconds`. `place`: as it is now, on its way; `presence`: 0 off stage, 1 on it. `leaves`: it has
    been removed and will be gone. `regions`: the mixes of the regions that show another expression than the face does;
    `region_calls`: their own calls. `layers`: those that a source drives or that are set otherwise than at first, the
    lowest first; all else is what they make together. `held`: what hands hold, `None` where that is what is on air.
    `motion`: what is set of its automatic motion, `None` where nothing was. `speech`: what it says, `None` while it
    says nothing; `spoken`: the key of what it said to its end last. `clips`: those that it plays, the newest last.
    `macros`: all that it has. `pads`: where the points of pads are, by name, of those that have been moved since the
    last panic. `springs`: how much of each is set, of those that are not 1. `complexion`: the blood that shows in
    cheeks, nose, forehead, around the eyes and in the whole face, tears, sweat, and the metres that these have run;
    empty where the skin is as ever. `folds`: how much of its folds shows; `skin`: its faders as set, of those that are
    not 1.
    `figure`: its poses and its body, `None` while it stands and each face has its own; `idle`: how much of a breath is
    in its chest, how far its weight is on the left foot, and how far its chest has followed the head to its left, both
    -1..1.
    """

    faces: dict[str, float]
    expressions: dict[str, float]
    channels: dict[str, float]
    head: tuple[float, float, float]
    gaze: tuple[float, float]
    eyes: tuple[float, float, float, float]
    added: dict[str, float]
    face_call: CallState | None
    expression_call: CallState | None
    face_fader: float
    expression_fader: float
    panics: int
    home_face: str
    home_seconds: float
    home_next: bool
    label: str
    place: Place
    presence: float
    leaves: bool = False
    regions: dict[PlayRegion, dict[str, float]] = {}
    region_calls: dict[PlayRegion, CallState] = {}
    layers: dict[LayerName, LayerState] = {}
    held: HeldState | None = None
    motion: MotionState | None = None
    speech: SpeechState | None = None
    spoken: str = ""
    clips: list[ClipState] = []
    macros: dict[str, MacroState] = {}
    pads: dict[str, PadPointState] = {}
    springs: dict[SpringName, float] = {}
    complexion: list[float] = []
    folds: float = 1.0
    skin: dict[SkinFader, float] = {}
    figure: FigureState | None = None
    idle: tuple[float, float, float] = NO_IDLE


class State(ServerMessage, frozen=True):
    """All that is on air: complete and absolute; the highest (epoch, number) wins, any may be lost.

    `time`: the show's clock, seconds. `characters`: at least one, in the order in which they were added. `light` sums
    to one, and so does `framing`: a framing is `*`, all that are on the stage, or names joined by `+`, sorted; behind a
    `:` the size of its shot, where that is no portrait. `gaze_points`: the named points that eyes may look at, metres
    as of `look_at`. `black`: how far stages fade their picture to black, 0..1; `black_goal`: where that goes. A record
    without them has the picture up. `memories`: the names of the looks that were kept, in the order in which they were
    kept first. `note`: the line of notes of the crew; `began`: when the show began, of `time`. `cues`: how far its
    lists of cues are, `None` where it has had none. `bus`: whose state it is; that of the preview has panics and homes
    of air. `looked_at`: the cue that is looked at in preview.
    """

    epoch: int
    number: int
    time: float
    revision: int
    characters: dict[str, CharacterState]
    light: dict[str, float]
    light_call: CallState | None
    framing: dict[str, float]
    framing_call: CallState | None
    gaze_points: dict[str, tuple[float, float, float]] = {}
    black: float = 0.0
    black_goal: float = 0.0
    memories: list[str] = []
    note: str = ""
    began: float = 0.0
    cues: CueStatus | None = None
    bus: Bus = "air"
    looked_at: CueName | None = None


def named_most(mix: Mapping[str, float], call: CallState | None) -> str:
    """The name that a call brings, else, where `call` is None, the one that weighs most in a mix."""
    return call.target if call is not None else max(mix, key=lambda name: mix[name])


def held_by_hands(state: CharacterState) -> CharacterState | HeldState:
    """What holds channels, head and gaze as hands do."""
    return state if state.held is None else state.held


def in_degrees(*angles: float) -> tuple[float, ...]:
    """Angles as addresses of OSC have them."""
    return tuple(round(math.degrees(angle), 4) for angle in angles)
