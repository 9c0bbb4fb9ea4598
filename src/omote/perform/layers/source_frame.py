"""What a source sends at one instant."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.model.body.pose_regions import POSE_REGIONS, PoseRegion
from omote.model.known_names import NEUTRAL
from omote.perform.channels import GAZE_UNITS
from omote.perform.frame import Gaze, Head, with_fields
from omote.perform.layers.layer_names import LAYER_PARTS, RANGES, RULES, WHOLE, LayerName, LayerPart
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS, check_known, check_within

LONGEST_SMOOTHING = 2.0
"""Seconds; who wants slower moves wants another performer."""
LOSS_SECONDS = 0.5
"""Seconds of silence, or of a performer who is not found, after which a source counts as lost."""


DEVICE_YAW = math.radians(35.0)
DEVICE_UP = math.radians(25.0)
DEVICE_DOWN = math.radians(35.0)
"""By what a full coefficient of ARKit's turns an eye to the side, up and down: in three takes of Live Link Face, which
sends both, angles follow their coefficients by these slopes (correlation above .98)."""
AUTOMATIC = "automatic"
SPEECH = "speech"
CLIP = "clip"
OWN_SOURCES = (AUTOMATIC, SPEECH, CLIP)
"""The sources of a character's own motion, of what it says and of the clips that it plays; no other has these names."""


@dataclass(frozen=True, eq=False)
class BodyFrame:
    """The body of a performer at one instant. numbers: of its pose (`omote.perform.figures.packed_pose`), without the
    head's own direction; regions: those that are seen."""

    numbers: Values
    regions: tuple[PoseRegion, ...] = POSE_REGIONS


@dataclass(frozen=True, eq=False)
class SourceFrame:
    """One frame of a source: the weights of its channels, float64 in the order of `names`, checked by `check_frame`.

    head, gaze: None where it sends none. found: False while it does not see its performer; all else is then ignored.
    parts: which parts of the face it may play. smoothing: seconds in which it is followed, 0 as its layer is. direct:
    it is smooth already and knows what comes, so it shows as it is. vergence: radians by which each eye turns in.
    share: of a direct one, how much of its layer it takes, 0 to 1: a voice that is silent takes none, and what lies
    below shows. route_number: of two that may play the same parts, the higher one has them. part_shares: of a direct
    one that plays expressions too, by regions, how much of each part it takes beside that, and of the whole face last;
    () for all. body: of its performer, None where it sends none.
    """

    names: tuple[str, ...]
    values: Values
    head: Head | None = None
    gaze: Gaze | None = None
    found: bool = True
    source: str = ""
    parts: tuple[LayerPart, ...] = LAYER_PARTS
    smoothing: float = 0.0
    direct: bool = False
    vergence: float = 0.0
    share: float = 1.0
    route_number: int = 0
    part_shares: tuple[float, ...] = ()
    body: BodyFrame | None = None


def check_frame(frame: SourceFrame, layer: LayerName) -> SourceFrame:
    """Returns a frame that a layer takes; ValueError for weights out of its range, with the channel's name."""
    low, high = RANGES.get(RULES[layer], (CHANNEL_LOWEST, CHANNEL_HIGHEST))
    if len(frame.values) != len(frame.names):
        raise ValueError(f"{len(frame.values)} values came for {len(frame.names)} channels; send one for each")
    check_share(frame.share)
    check_part_shares(frame.part_shares)
    if (frame.share != 1.0 or frame.part_shares) and not frame.direct:
        raise ValueError("only a source that is smooth already (direct) takes less than all of its layer")
    wrong = ~((frame.values >= low) & (frame.values <= high))
    if wrong.any():
        place = int(np.argmax(wrong))
        check_within(float(frame.values[place]), low, high, f"{frame.names[place]} of the layer {layer}")
    if RULES[layer] == "fill" and not (frame.head is None and frame.gaze is None):
        raise ValueError(f"the layer {layer} closes what is open; it takes no head and no gaze")
    return frame


def with_gaze_of_units(frame: SourceFrame) -> SourceFrame:
    """The frame with the gaze that its coefficients of the eyes mean, where it has all of them and sends no angles: the
    mean of both eyes, as far as a gaze goes. Rejects nothing."""
    places = _eye_places(frame.names)
    if frame.gaze is not None or places is None:
        return frame
    out_left, in_left, up_left, down_left, out_right, in_right, up_right, down_right = frame.values[places].tolist()
    yaw = DEVICE_YAW * (out_left - in_left + in_right - out_right) / 2.0
    pitch = (DEVICE_UP * (up_left + up_right) - DEVICE_DOWN * (down_left + down_right)) / 2.0
    widest = GAZE_LIMITS["yaw"]
    highest = GAZE_LIMITS["pitch"]
    gaze = Gaze(min(max(yaw, -widest), widest), min(max(pitch, -highest), highest))
    return with_fields(frame, gaze=gaze)


@lru_cache(maxsize=64)
def _eye_places(names: tuple[str, ...]) -> NDArray[np.intp] | None:
    if not GAZE_UNITS.keys() <= set(names):
        return None
    return np.array([names.index(unit) for unit in GAZE_UNITS], np.intp)


def source_frame(
    expressions: Mapping[str, object],
    channels: Mapping[str, float],
    head: tuple[float, float, float] | None,
    gaze: tuple[float, float] | None,
    *,
    found: bool = True,
    smoothing: float = 0.0,
) -> SourceFrame:
    """The frame of a mapping of weights; ValueError and TypeError for names and numbers that cannot be played.

    expressions: those of the cast, by name; channels: weights by name, -0.5 to 1.5; head: yaw, pitch and roll, radians;
    gaze: yaw and pitch, radians; found: False while the source does not see whom it follows; smoothing: seconds in
    which it is followed.
    """
    if not isinstance(channels, Mapping):
        raise TypeError(f"the channels are a {type(channels).__name__}; give weights by name, as {{'jawOpen': 0.4}}")
    names = check_names(channels, expressions)
    values = [check_within(channels[name], CHANNEL_LOWEST, CHANNEL_HIGHEST, f"the channel {name}") for name in names]
    turned = None if head is None else Head(*_angles(head, HEAD_LIMITS, "head"))
    looks = None if gaze is None else Gaze(*_angles(gaze, GAZE_LIMITS, "gaze"))
    return SourceFrame(names, np.array(values, np.float64), turned, looks, found, smoothing=check_smoothing(smoothing))


def _angles(value: object, limits: Mapping[str, float], what: str) -> tuple[float, ...]:
    """The angles of a head or a gaze, as many as it has; Head and Gaze look at each of them."""
    angles = tuple(value) if isinstance(value, Iterable) and not isinstance(value, str) else ()
    if len(angles) != len(limits):
        raise ValueError(f"the {what} is {value!s:.80}; give {', '.join(limits)}, radians")
    return angles


def check_smoothing(seconds: object) -> float:
    """Returns the seconds in which a source is followed; ValueError and TypeError for what cannot be."""
    return check_within(seconds, 0.0, LONGEST_SMOOTHING, "the smoothing of a source (seconds)")


def check_share(share: object) -> float:
    """Returns how much of its layer a source takes; ValueError and TypeError for what cannot be."""
    return check_within(share, 0.0, 1.0, "the share of its layer that a source takes")


def check_part_shares(shares: tuple[float, ...]) -> None:
    """Rejects shares by part that no source takes."""
    if len(shares) not in (0, WHOLE + 1):
        raise ValueError(f"a source takes {len(shares)} shares by part; expected {WHOLE + 1} or none")
    for share in shares:
        check_share(share)


def check_names(names: Iterable[str], expressions: Mapping[str, object]) -> tuple[str, ...]:
    """The channels of a source, each once; ValueError for one that there is not, and for `neutral`.

    names: as they were sent; expressions: those that there are.
    """
    choices = [name for name in expressions if name != NEUTRAL]
    checked = tuple(
        name if name in expressions and name != NEUTRAL else check_known(name, choices, "channel") for name in names
    )
    if len(set(checked)) != len(checked):
        raise ValueError(f"a source names a channel twice among {', '.join(checked)[:200]}; name each once")
    return checked
