"""The motion of a whole body as files have it: rotations of VRM's humanoid bones, which fit bodies of all proportions.

VRM Consortium, VRMC_vrm-1.0, "Humanoid" and "T-pose":
https://github.com/vrm-c/vrm-specification/blob/master/specification/VRMC_vrm-1.0
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Values
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.perform.clips.motion_curve import LONGEST_CURVE, NEAR

HIPS = "hips"
MOST_TURNS = 2**22
"""Frames times bones: twenty minutes of all bones, sixty times a second."""
FARTHEST_HIPS = 1000.0
"""Leg lengths: who walks farther has walked out of any hall."""
LEG_BONES = ("UpperLeg", "LowerLeg", "Foot")
LEGS = tuple(f"{side}{bone}" for side in ("left", "right") for bone in LEG_BONES)
"""Without these bones a motion is of a head or of arms, and of no body that stands."""


def _parents() -> dict[str, str]:
    """The parent of each bone among VRM's, nothing for the hips."""
    trunk = ("", HIPS, "spine", "chest", "upperChest", "neck", "head")
    parents = dict(zip(trunk[1:], trunk, strict=False))
    for side in ("left", "right"):
        arm = ("upperChest", *(f"{side}{name}" for name in ("Shoulder", "UpperArm", "LowerArm", "Hand")))
        leg = (HIPS, *(f"{side}{name}" for name in (*LEG_BONES, "Toes")))
        parents |= dict(zip(arm[1:], arm, strict=False)) | dict(zip(leg[1:], leg, strict=False))
        for finger in ("Thumb", "Index", "Middle", "Ring", "Little"):
            joints = (name for name in humanoid_bones() if name.startswith(f"{side}{finger}"))
            above = f"{side}Hand"
            for joint in joints:
                parents[joint] = above
                above = joint
    return parents


PARENTS: Mapping[str, str] = MappingProxyType(_parents())
"""The parent of each of VRM's bones, "" of the hips: parents come before their children."""


def parent_among(bone: str, names: Iterable[str]) -> str:
    """The nearest bone above another that is among some; "" where there is none. bone: of VRM; names: those there
    are."""
    there = frozenset(names)
    above = PARENTS[bone]
    while above and above not in there:
        above = PARENTS[above]
    return above


@dataclass(frozen=True, eq=False)
class HumanoidMotion:
    """What a humanoid did, frame by frame.

    Parameters
    ----------
    times : array_like, (n,)
        Seconds of each frame, rising.
    names : tuple of str
        Of b bones as VRM 1.0 names them, with the hips.
    turns : array_like, (n, b, 4)
        Quaternions x, y, z, w of each against the nearest bone above it that is named, counted from the T-pose: x to
        the character's left, y up, z ahead.
    hips : array_like, (n, 3)
        Where the hips are from where they are in the T-pose on the floor, in lengths of a leg (thigh and shin).
    weights : mapping of array_like, (n,)
        Of expressions, by the names that the file has for them.
    gaze : array_like, (n, 2), optional
        Yaw and pitch of the eyes against the head, radians.
    notes : tuple of str
        What of the file is read otherwise than it says, in sentences.

    Raises
    ------
    ValueError
        On arrays that do not belong together, on bones that there are not, on numbers that are not finite or out of
        reach, and on motion that is longer than an hour or has too many numbers.
    """

    times: Values
    names: tuple[str, ...]
    turns: Values
    hips: Values
    weights: Mapping[str, Values] = field(default_factory=dict)
    gaze: Values | None = None
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        count = len(self.times)
        check_size(count, len(self.names))
        unknown = [name for name in self.names if name not in PARENTS]
        if unknown or HIPS not in self.names or len(set(self.names)) != len(self.names):
            raise ValueError(f"a motion has the bones {', '.join(self.names)[:200]}; expected those of VRM with hips")
        shapes = {"times": (count,), "turns": (count, len(self.names), 4), "hips": (count, 3)}
        gaze = {} if self.gaze is None else {"gaze": (count, 2)}
        for name, shape in {**shapes, **gaze}.items():
            object.__setattr__(self, name, _checked(getattr(self, name), shape, f"the {name} of a motion"))
        kept = {
            name: _checked(values, (count,), f"the weight of {name[:80]!r}") for name, values in self.weights.items()
        }
        object.__setattr__(self, "weights", kept)
        if not (np.diff(self.times) > NEAR).all() or self.times[-1] - self.times[0] > LONGEST_CURVE:
            raise ValueError(f"the times of a motion do not rise, or last more than {LONGEST_CURVE:g} s: cut it")
        if np.abs(self.hips).max() > FARTHEST_HIPS:
            raise ValueError(f"the hips go farther than {FARTHEST_HIPS:g} lengths of a leg; export it in one unit")
        lengths = np.linalg.norm(self.turns, axis=2, keepdims=True)
        if lengths.min() < 1e-3:
            raise ValueError("a bone has a rotation of length 0, which turns nothing; export it anew")
        object.__setattr__(self, "turns", self.turns / lengths)

    @property
    def stands(self) -> bool:
        """Whether it moves a body with legs; else it is of a head, or of arms."""
        return set(LEGS) <= set(self.names)

    def worlds(self) -> dict[str, Rotation]:
        """The rotations of each bone along the axes of the house, by name: parents before children."""
        found: dict[str, Rotation] = {}
        places = {name: place for place, name in enumerate(self.names)}
        for name in (bone for bone in PARENTS if bone in places):
            own = Rotation.from_quat(self.turns[:, places[name]])
            above = parent_among(name, places)
            found[name] = found[above] * own if above else own
        return found


def check_size(frames: int, bones: int) -> None:
    """Raises ValueError where motion has no frame, or too many, before memory is taken for it.

    frames: how many there are; bones: or other numbers of each.
    """
    if not frames or frames * max(bones, 1) > MOST_TURNS:
        raise ValueError(
            f"the motion has {frames} frames of {bones} bones; expected some, {MOST_TURNS // max(bones, 1)} at most: "
            "cut it into parts"
        )


def turns_of_worlds(worlds: Mapping[str, Rotation]) -> tuple[tuple[str, ...], Values]:
    """The names of bones, parents first, and their rotations (n, b, 4) against each other.

    worlds: of each bone along the axes of the house from the T-pose, (n,) rotations, by VRM's names.
    """
    names = tuple(bone for bone in PARENTS if bone in worlds)
    own = []
    for name in names:
        above = parent_among(name, worlds)
        own.append((worlds[above].inv() * worlds[name] if above else worlds[name]).as_quat(canonical=True))
    return names, np.stack(own, axis=1)


def _checked(values: object, shape: tuple[int, ...], what: str) -> Values:
    array = np.asarray(values, np.float64)
    if array.shape != shape:
        raise ValueError(f"{what} is {array.shape}; expected {shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{what} holds what is no finite number; export it anew")
    return array
