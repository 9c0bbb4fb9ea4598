"""A frame: everything that is on air at one instant, as the performer gives it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from omote.model.known_names import GENERIC, PlayRegion
from omote.perform.lights import FIRST_LIGHT
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS, LONGEST_CALL, check_within

Frozen = TypeVar("Frozen")
MOST_SEED = 2**31 - 1
DETAILS = ("blinks", "gaze", "breath")
DETAIL_LIMIT = 2.0


def _describe_angles(whose: str, limits: Mapping[str, float]) -> dict[str, str]:
    """What error messages call angles: whoever thinks in degrees reads that these are none."""
    return {
        name: f"the {whose}'s {name} (radians; {math.degrees(limit):.0f} degrees at most)"
        for name, limit in limits.items()
    }


_HEAD_ANGLES, _GAZE_ANGLES = _describe_angles("head", HEAD_LIMITS), _describe_angles("gaze", GAZE_LIMITS)


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

    def __post_init__(self) -> None:
        """Rejects what is out of range."""
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

    def change(self, **given: float | None) -> MotionSettings:
        """The same with what is given; None leaves a setting as it is."""
        return replace(self, **{name: value for name, value in given.items() if value is not None})  # type: ignore[arg-type]


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


@dataclass(frozen=True)
class Held:
    """What hands hold: channels, head and gaze, each at rest where no hand does."""

    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)


@dataclass(frozen=True)
class LayerStatus:
    """A layer now: its influence by `LAYER_PARTS` and whether it is on, as set; its source and how far that is trusted;
    share: how much of it is on air where it plays most, 0 to 1; strongest: what it does now, by channel."""

    influence: tuple[float, ...]
    on: bool
    trust: float
    source: str
    share: float
    strongest: Mapping[str, float]


@dataclass(frozen=True)
class SpeechStatus:
    """What is said now. number: counts all that was said; text: its beginning; elapsed: seconds since its sound began,
    below 0 before that; seconds: its length; sound: the key of what the stage plays, "" for none; waiting: how many
    speeches come after it, next_sound: the key of the next one's sound."""

    number: int
    text: str
    elapsed: float
    seconds: float
    sound: str
    waiting: int
    next_sound: str


@dataclass(frozen=True)
class Frame:
    """The mixes of faces, expressions and lights (each sums to one), the channels, head and gaze, at `time` seconds.

    Names that weigh nothing are absent. `face_fader`, `expression_fader`: where the T-bars stand, 0..1. `panics` counts
    them; `home_next`: the next one brings the face of `home`. `regions`: the mixes of expressions of the regions that
    show another than the rest of the face does, each sums to one; `region_calls`: their own calls. `held`: what hands
    hold where layers mix it with what sources send, None where `channels`, `head` and `gaze` are theirs alone; layers
    mix the gaze as the channels that turn the eyes. `layers`: those that a source drives or that are set otherwise than
    at first. `motion`: what is set of the automatic motion, None where nothing is. `speech`: what is said, None where
    nothing is.
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


def with_fields(frozen: Frozen, **changes: Any) -> Frozen:
    """A frozen dataclass that checks nothing when it is made, with some fields changed: what `dataclasses.replace`
    gives, which asks each field about itself and takes ten times as long; frames are made sixty times a second."""
    made: Frozen = object.__new__(type(frozen))
    made.__dict__.update(frozen.__dict__, **changes)
    return made
