"""A frame: everything that is on air at one instant, as the performer gives it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, NamedTuple, TypeVar, get_args

from omote.model.body.pose_regions import PoseRegion
from omote.model.known_names import GENERIC, PlayRegion
from omote.model.space.complexion import PALE, Complexion
from omote.perform.lights import FIRST_LIGHT
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS, LONGEST_CALL, check_known, check_switch, check_within


@dataclass(frozen=True)
class SpeechStatus:
    """What is said now. number: counts all that was said; text: its beginning; elapsed: seconds since its sound began,
    below 0 before that; seconds: its length; sound: the key of what the stage plays, "" for none; waiting: how many
    speeches come after it, next_sound: the key of the next one's sound. keys: what whoever said them calls this one and
    those that wait, in their order."""

    number: int
    text: str
    elapsed: float
    seconds: float
    sound: str
    waiting: int
    next_sound: str
    keys: tuple[str, ...] = ()


Frozen = TypeVar("Frozen")
MOST_SEED = 2**31 - 1
DETAILS = ("blinks", "gaze", "breath")
DETAIL_LIMIT = 2.0
"""How many times its usual amount a part of the automatic motion may have."""


def _describe_angles(whose: str, limits: Mapping[str, float]) -> dict[str, str]:
    """What error messages call angles: whoever thinks in degrees reads that these are none."""
    return {
        name: f"the {whose}'s {name} (radians; {math.degrees(limit):.0f} degrees at most)"
        for name, limit in limits.items()
    }


_HEAD_ANGLES = _describe_angles("head", HEAD_LIMITS)
_GAZE_ANGLES = _describe_angles("gaze", GAZE_LIMITS)


@dataclass(frozen=True)
class Head:
    """The head's direction in radians: + is the character's left, up, tilt to its left."""

    yaw: float = 0.0
    pitch: float = 0.0
    roll: float = 0.0

    def __post_init__(self) -> None:
        """Rejects angles beyond a head's range."""
        for name, limit in HEAD_LIMITS.items():
            value = check_within(getattr(self, name), -limit, limit, _HEAD_ANGLES[name])
            object.__setattr__(self, name, value)


@dataclass(frozen=True)
class Gaze:
    """The gaze relative to the head in radians: + is the character's left, up."""

    yaw: float = 0.0
    pitch: float = 0.0

    def __post_init__(self) -> None:
        """Rejects angles beyond an eye's range."""
        for name, limit in GAZE_LIMITS.items():
            value = check_within(getattr(self, name), -limit, limit, _GAZE_ANGLES[name])
            object.__setattr__(self, name, value)


@dataclass(frozen=True)
class Home:
    """The face that a second panic brings on air, and the seconds that it takes."""

    face: str = GENERIC
    seconds: float = 2.0

    def __post_init__(self) -> None:
        """Rejects a time that no call can take."""
        what = "the time to the home face (seconds)"
        object.__setattr__(self, "seconds", check_within(self.seconds, 0.0, LONGEST_CALL, what))


TargetKind = Literal["ahead", "direction", "point", "gaze_point", "character", "stage"]
TARGET_KINDS: tuple[TargetKind, ...] = get_args(TargetKind)
DIRECTION_LIMITS: Mapping[str, float] = {"yaw": math.pi, "pitch": math.pi / 2}
POINT_LIMITS: Mapping[str, tuple[float, float]] = {"x": (-20.0, 20.0), "y": (-10.0, 10.0), "z": (-20.0, 200.0)}
"""Metres to the picture's right, above the eyes of a head of size 1, before the front line."""
LONGEST_TARGET = 80
"""Characters of the name of what eyes look at."""


@dataclass(frozen=True)
class GazeTarget:
    """Whom or what the eyes of a character look at.

    Parameters
    ----------
    kind : {"ahead", "direction", "point", "gaze_point", "character", "stage"}
        Nothing; a direction of the house; a point of the scene; a named one; another character; a stage's camera.
    name : str
        Of the gaze point, the character or the stage; "" for any stage.
    yaw, pitch : float
        The direction, radians: + is to the picture's right, up.
    x, y, z : float
        The point, metres: to the picture's right, above the eyes, before the front line.

    Raises
    ------
    ValueError
        On a kind that there is not, a name that is too long and on numbers out of range.
    TypeError
        On what is no number.
    """

    kind: TargetKind = "ahead"
    name: str = ""
    yaw: float = 0.0
    pitch: float = 0.0
    x: float = 0.0
    y: float = 0.0
    z: float = 2.0

    def __post_init__(self) -> None:
        """Rejects what nobody can look at."""
        check_target_kind(self.kind)
        if not isinstance(self.name, str) or len(self.name) > LONGEST_TARGET:
            raise ValueError(
                f"the name of what eyes look at is {self.name!r:.100}; give {LONGEST_TARGET} letters at most"
            )
        for name, limit in DIRECTION_LIMITS.items():
            self._check(name, -limit, limit, "radians")
        for name, (low, high) in POINT_LIMITS.items():
            self._check(name, low, high, "metres")

    def _check(self, name: str, low: float, high: float, unit: str) -> None:
        object.__setattr__(
            self, name, check_within(getattr(self, name), low, high, f"the {name} of what eyes look at ({unit})")
        )


def check_target_kind(kind: object) -> TargetKind:
    """The kind of what eyes look at of this name; ValueError where there is none."""
    return check_known(kind, TARGET_KINDS, "kind of what eyes look at")


NO_TARGET = GazeTarget()


@dataclass(frozen=True)
class MotionSettings:
    """How much a character moves by itself.

    Parameters
    ----------
    liveliness : float
        0 off; 0.5 as people are, by the literature; 1 lively.
    blinks, gaze, breath : float
        Each beside the others, 0 (none) to 2 (twice as much); the head that follows goes with the gaze, noise with
        the breath.
    seed : int
        Which of all ways to move, 0 to 2147483647: the same seed moves the same.
    idle : bool
        Whether it moves as people do while its tracker is lost, where the liveliness is 0 too.
    target : GazeTarget
        Whom or what the eyes look at.

    Raises
    ------
    ValueError
        On a number out of range.
    TypeError
        On what is no number.
    """

    liveliness: float = 0.0
    blinks: float = 1.0
    gaze: float = 1.0
    breath: float = 1.0
    seed: int = 0
    idle: bool = False
    target: GazeTarget = NO_TARGET

    def __post_init__(self) -> None:
        """Rejects what is out of range."""
        check_switch(self.idle, "the switch of the idle motion")
        object.__setattr__(self, "liveliness", check_within(self.liveliness, 0.0, 1.0, "the liveliness"))
        for name in DETAILS:
            value = check_within(getattr(self, name), 0.0, DETAIL_LIMIT, f"the {name} of the automatic motion")
            object.__setattr__(self, name, value)
        check_within(self.seed, 0, MOST_SEED, "the seed of the automatic motion")
        if self.seed != int(self.seed):
            raise ValueError(f"the seed of the automatic motion is {self.seed}; expected a whole number")
        object.__setattr__(self, "seed", int(self.seed))

    @property
    def blink_rate(self) -> float:
        """How often lids close, 1 as at rest; 0 never."""
        return self.blinks * (0.6 + 0.8 * self.liveliness) if self.liveliness else 0.0

    @property
    def reach(self) -> float:
        """How far eyes go elsewhere, 1 as people's do."""
        return self.gaze * 2.0 * self.liveliness

    @property
    def depth(self) -> float:
        """How much breath and noise move, 1 as they are stated."""
        return self.breath * 2.0 * self.liveliness

    def change(self, **changes: float | GazeTarget | None) -> MotionSettings:
        """The same with what is given; None leaves a setting as it is."""
        return replace(self, **{name: value for name, value in changes.items() if value is not None})  # type: ignore[arg-type]


@dataclass(frozen=True)
class CallStatus:
    """A running call: its target, its progress 0..1, the seconds that remain (None: the T-bar decides).

    `by_hand`: only the T-bar moves it. `fader`: where the T-bar stands; `pickup`: where it takes over. `start`: the mix
    that it left.
    """

    target: str
    progress: float
    remaining: float | None
    by_hand: bool
    fader: float
    pickup: float
    start: Mapping[str, float]


NO_IDLE = (0.0, 0.0, 0.0)
"""Of a figure that holds still: no breath, its weight on both feet, its chest ahead."""


class TrackedPose(NamedTuple):
    """The pose of a performer whom a source sees. shares: how much of it shows in each of `POSE_REGIONS`, 0 to 1; pose:
    its numbers, packed (`omote.perform.figures.packed_pose`)."""

    shares: tuple[float, ...]
    pose: bytes


@dataclass(frozen=True)
class FigureFrame:
    """The figure of a frame. poses: the mix, which sums to one; regions: those of the regions that show another;
    bodies: the mix of bodies, in which "own" stands for those of the faces; pose_call, region_calls, body_call: what is
    called; fader: where the T-bar of the poses stands, 0..1; tracked: the body of a performer whom a source sees, which
    shows in place of the mix."""

    poses: Mapping[str, float]
    regions: Mapping[PoseRegion, Mapping[str, float]]
    bodies: Mapping[str, float]
    pose_call: CallStatus | None
    region_calls: Mapping[PoseRegion, CallStatus]
    body_call: CallStatus | None
    fader: float
    tracked: TrackedPose | None = None


@dataclass(frozen=True)
class Held:
    """What hands hold: channels, head and gaze, each at rest where no hand does."""

    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)


class SourceStatus(NamedTuple):
    """One of the sources of a layer: how far it is trusted where it shows, 0 to 1, and the parts that it has."""

    source: str
    trust: float
    parts: tuple[str, ...]


class LayerStatus(NamedTuple):
    """A layer now: its influence by `LAYER_PARTS` and whether it is on, as set; its source, of several the one with the
    most parts, and how far that is trusted; share: how much of it is on air where it plays most, 0 to 1; strongest:
    what it does now, by channel; sources: all of them where there are several, the newest first."""

    influence: tuple[float, ...]
    on: bool
    trust: float
    source: str
    share: float
    strongest: Mapping[str, float]
    sources: tuple[SourceStatus, ...] = ()


class MacroStatus(NamedTuple):
    """A macro now: where hands have it, -1 to 1, and how much of it shows, 0 to 1: its condition, and whether a hand
    has moved it since the last panic."""

    value: float
    share: float


@dataclass(frozen=True)
class ClipStatus:
    """A clip that a character plays, for those who look on. name: of the clip; elapsed: seconds from its start, of
    `seconds`; share: how much of it shows, 0 to 1; loop: whether it begins again; missing: expressions and channels of
    it that the cast does not have, which are left out; number: counts what the character has played; sound, heard,
    turn, silent: as of `RunSound`."""

    name: str
    elapsed: float
    seconds: float
    share: float
    loop: bool
    missing: tuple[str, ...] = ()
    number: int = 0
    sound: str = ""
    heard: float = 0.0
    turn: int = 0
    silent: str = ""


@dataclass(frozen=True)
class PadStatus:
    """The point of a pad on a character. place: where it is, or was when another took over; plays: whether what shows
    follows it."""

    place: tuple[float, ...]
    plays: bool


@dataclass(frozen=True)
class Frame:
    """The mixes of faces, expressions and lights (each sums to one), the channels, head and gaze, at `time` seconds.

    Names that weigh nothing are absent. `face_fader`, `expression_fader`: where the T-bars stand, 0..1. `panics` counts
    them; `home_next`: the next one brings the face of `home`. `regions`: the mixes of expressions of the regions that
    show another than the rest of the face does, each sums to one; `region_calls`: their own calls. `held`: what hands
    hold where layers mix it with what sources send, None where `channels`, `head` and `gaze` are theirs alone; layers
    mix the gaze as the channels that turn the eyes. `layers`: those that a source drives or that are set otherwise than
    at first. `motion`: what is set of the automatic motion, None where nothing is. `speech`: what is said, None where
    nothing is; `spoken`: the key of what was said to its end last. `clips`: those that play, the newest last. `macros`:
    all that the character has. `pads`: those whose points have been moved since the last panic. `springs`: how much of
    each is set, of those that are not 1. `complexion`: blood, tears and sweat as they show now; `drops`:
    the metres that these two have run; `folds`: how much of the skin's folds shows; `skin`: its faders as set, of those
    that are not 1.
    `figure`: poses and bodies, None while the figure stands and each face has its own body; `idle`: how much of a
    breath is in the chest, how far the weight is on the left foot, and how far the chest has followed the head to its
    left, each 0 at rest.
    """

    faces: Mapping[str, float]
    expressions: Mapping[str, float]
    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    time: float = 0.0
    face_call: CallStatus | None = None
    expression_call: CallStatus | None = None
    face_fader: float = 0.0
    expression_fader: float = 0.0
    light: Mapping[str, float] = field(default_factory=lambda: {FIRST_LIGHT: 1.0})
    light_call: CallStatus | None = None
    home: Home = field(default_factory=Home)
    home_next: bool = False
    panics: int = 0
    regions: Mapping[PlayRegion, Mapping[str, float]] = field(default_factory=dict)
    region_calls: Mapping[PlayRegion, CallStatus] = field(default_factory=dict)
    layers: Mapping[str, LayerStatus] = field(default_factory=dict)
    held: Held | None = None
    motion: MotionSettings | None = None
    speech: SpeechStatus | None = None
    spoken: str = ""
    clips: tuple[ClipStatus, ...] = ()
    macros: Mapping[str, MacroStatus] = field(default_factory=dict)
    pads: Mapping[str, PadStatus] = field(default_factory=dict)
    springs: Mapping[str, float] = field(default_factory=dict)
    complexion: Complexion = PALE
    drops: float = 0.0
    folds: float = 1.0
    skin: Mapping[str, float] = field(default_factory=dict)
    figure: FigureFrame | None = None
    idle: tuple[float, float, float] = NO_IDLE


def with_fields(frozen: Frozen, **changes: Any) -> Frozen:
    """A frozen dataclass that checks nothing when it is made, with some fields changed: what `dataclasses.replace`
    gives, which asks each field about itself and takes ten times as long; frames are made sixty times a second.

    changes: the new values, by field.
    """
    changed: Frozen = object.__new__(type(frozen))
    object.__setattr__(changed, "__dict__", frozen.__dict__ | changes)
    return changed
