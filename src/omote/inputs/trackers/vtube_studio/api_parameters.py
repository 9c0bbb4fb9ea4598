"""VTube Studio's tracking parameters as coefficients of ARKit with head and gaze, and ours as its parameters.

Its own trackers make parameters from coefficients; what these hold is read back: lids and brows rest at one half, a
mouth that smiles lies above it. Angles are degrees: + is up, and to the right of a mirror, as Live2D counts them
(docs.live2d.com, standard parameter list; DenchiSoft/VTubeStudio, wiki), which is the performer's own right.
Parameters that other programs have added are read by the names of coefficients, which count more.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS, ARKIT_NAMES
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles
from omote.inputs.trackers.tracker_frame import LeftOut, TrackerFrame
from omote.perform.limits import GAZE_LIMITS

PREFIX = "Omote"
"""Before the names of the parameters that we add, which we do not read."""
HEAD = ("FaceAngleX", "FaceAngleY", "FaceAngleZ")
EYES_X = ("EyeLeftX", "EyeRightX")
EYES_Y = ("EyeLeftY", "EyeRightY")
Weights = dict[str, float]


def _both(name: str, value: float) -> Weights:
    return {f"{name}Left": value, f"{name}Right": value}


def _above(value: float) -> float:
    """The part of a value above one half, as 0 to 1."""
    return max(0.0, 2.0 * value - 1.0)


def _below(value: float) -> float:
    return max(0.0, 1.0 - 2.0 * value)


def _read_lid(side: str) -> Callable[[float], Weights]:
    return lambda value: {f"eyeBlink{side}": _below(value), f"eyeWide{side}": _above(value)}


def _read_brow(side: str) -> Callable[[float], Weights]:
    return lambda value: {f"browDown{side}": _below(value), f"browOuterUp{side}": _above(value)}


READ: Mapping[str, Callable[[float], Weights]] = {
    "Brows": lambda value: {"browInnerUp": _above(value)},
    "BrowLeftY": _read_brow("Left"),
    "BrowRightY": _read_brow("Right"),
    "EyeOpenLeft": _read_lid("Left"),
    "EyeOpenRight": _read_lid("Right"),
    "MouthOpen": lambda value: {"jawOpen": value},
    "JawOpen": lambda value: {"jawOpen": value},
    "MouthSmile": lambda value: {**_both("mouthSmile", _above(value)), **_both("mouthFrown", _below(value))},
    "MouthX": lambda value: {"mouthLeft": max(0.0, value), "mouthRight": max(0.0, -value)},
    "MouthPucker": lambda value: {"mouthPucker": max(0.0, -value)},
    "MouthFunnel": lambda value: {"mouthFunnel": value},
    "MouthShrug": lambda value: {"mouthShrugUpper": value, "mouthShrugLower": value},
    "CheekPuff": lambda value: {"cheekPuff": value},
    "TongueOut": lambda value: {"tongueOut": value},
}
"""What a parameter of its own says of coefficients; those above 1 are at 1."""
_OF_A_FACE = frozenset({*READ, *HEAD, *EYES_X, *EYES_Y})


def read_parameters(values: Mapping[str, float], *, found: bool = True) -> TrackerFrame:
    """The frame of its parameters. values: by name; others than a face's are left out; found: whether it sees a
    face."""
    finite = {name: value for name, value in values.items() if math.isfinite(value)}
    wrong = [name for name in values if name not in finite and (name in _OF_A_FACE or ARKIT_CHANNELS.find(name))]
    weights: Weights = {}
    for name, read in READ.items():
        if name in finite:
            for unit, weight in read(finite[name]).items():
                weights[unit] = max(weights.get(unit, 0.0), weight)
    for name, value in finite.items():
        if name not in READ and not name.startswith(PREFIX):
            weights |= dict.fromkeys(ARKIT_CHANNELS.find(name), value)
    weights = {name: min(1.0, max(0.0, weight)) for name, weight in weights.items()}
    left_out = tuple(LeftOut("", f"{name[:40]} is no number") for name in wrong)
    head = None if {*HEAD} & {*wrong} else _read_head(finite)
    return TrackerFrame(weights, head, _read_gaze(finite), found=found, left_out=left_out)


def write_parameters(weights: Mapping[str, float], head: HeadAngles, gaze: GazeAngles) -> Weights:
    """Its own parameters for all of ARKit's units, head and gaze (radians, ours): those that any model listens to.

    weights: of all units, 0 to 1.
    """
    unit = weights.__getitem__
    yaw, pitch, roll = (math.degrees(angle) for angle in head)
    gaze_x = -gaze[0] / GAZE_LIMITS["yaw"]
    gaze_y = gaze[1] / GAZE_LIMITS["pitch"]
    smile = unit("mouthSmileLeft") + unit("mouthSmileRight") - unit("mouthFrownLeft") - unit("mouthFrownRight")
    return {
        **dict(zip(HEAD, (-yaw, pitch, -roll), strict=True)),
        **dict.fromkeys(EYES_X, gaze_x),
        **dict.fromkeys(EYES_Y, gaze_y),
        "Brows": 0.5 + 0.5 * unit("browInnerUp"),
        **{f"Brow{side}Y": _rest(unit(f"browOuterUp{side}"), unit(f"browDown{side}")) for side in ("Left", "Right")},
        **{f"EyeOpen{side}": _rest(unit(f"eyeWide{side}"), unit(f"eyeBlink{side}")) for side in ("Left", "Right")},
        "MouthOpen": max(0.0, unit("jawOpen") - unit("mouthClose")),
        "JawOpen": unit("jawOpen"),
        "MouthSmile": 0.5 + 0.25 * smile,
        "MouthX": unit("mouthLeft") - unit("mouthRight"),
        "MouthPucker": -unit("mouthPucker"),
        "MouthFunnel": unit("mouthFunnel"),
        "MouthShrug": 0.5 * (unit("mouthShrugUpper") + unit("mouthShrugLower")),
        "CheekPuff": unit("cheekPuff"),
        "TongueOut": unit("tongueOut"),
    }


def custom_name(unit: str) -> str:
    """The parameter that we add for a unit."""
    return f"{PREFIX}{unit[0].upper()}{unit[1:]}"


def write_custom(weights: Mapping[str, float]) -> Weights:
    """The parameters that we add: all of ARKit's units, for models made for them."""
    return {custom_name(name): weights[name] for name in ARKIT_NAMES}


def _rest(up: float, down: float) -> float:
    return min(1.0, max(0.0, 0.5 + 0.5 * up - 0.5 * down))


def _read_head(values: Mapping[str, float]) -> HeadAngles | None:
    if not any(name in values for name in HEAD):
        return None
    x, y, z = (math.radians(values.get(name, 0.0)) for name in HEAD)
    return -x, y, -z


def _read_gaze(values: Mapping[str, float]) -> GazeAngles | None:
    """Both eyes' mean; 1 is as far as ours turn."""
    across, up = ([values[name] for name in names if name in values] for names in (EYES_X, EYES_Y))
    if not across and not up:
        return None
    yaw, pitch = (sum(sides) / len(sides) if sides else 0.0 for sides in (across, up))
    return -yaw * GAZE_LIMITS["yaw"], pitch * GAZE_LIMITS["pitch"]
