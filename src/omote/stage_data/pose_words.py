"""Reads the words of a pose as they are typed, weights and angles, and checks all of them that needs no cast."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from omote.perform.frame import Gaze, Head
from omote.perform.lights import LIGHTS
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS, check_within
from omote.perform.mix import HIGHEST, LOWEST
from omote.perform.name_lookup import NO_LABELS, find_names

EVEN = 1e-6
"""Tolerance of a mix's sum of one: people type three digits."""
ANGLE_DIGITS = 9

Weights = tuple[tuple[str, float], ...]
"""Names as they are typed, with their weights; a name may come twice, which only a cast can tell."""


@dataclass(frozen=True)
class PoseWords:
    """A pose whose numbers are read and right, and whose faces and expressions are still as they were typed.

    What the expressions leave of one is neutral. poses: of a figure; without any it stands.
    """

    faces: Weights
    expressions: Weights
    channels: Weights
    head: Head
    gaze: Gaze
    light: Mapping[str, float]
    poses: Weights = ()


def read_pose(
    *, face: str, expression: str, channel: str, turn: str, gaze: str, light: str, pose: str = ""
) -> PoseWords:
    """Reads the words of a pose; ValueError for what is not understood or out of range, TypeError for what is no
    text.

    face, expression, light: mixes as they are typed; channel: blendshape weights as they are typed; turn, gaze: angles
    in degrees as they are typed; pose: a mix of poses of a figure.
    """
    texts = {
        "face": face,
        "expression": expression,
        "channel": channel,
        "turn": turn,
        "gaze": gaze,
        "light": light,
        "pose": pose,
    }
    for name, text in texts.items():
        if not isinstance(text, str):
            raise TypeError(f"{name} must be text, not {text!r}; write {EXAMPLES[name]}")
    return PoseWords(
        faces=read_mix(face, "face"),
        expressions=read_expression_mix(expression),
        channels=read_channels(channel),
        head=Head(*read_angles(turn, "turn", HEAD_LIMITS)),
        gaze=Gaze(*read_angles(gaze, "gaze", GAZE_LIMITS)),
        light=merge_names(read_mix(light, "light"), LIGHTS, "light"),
        poses=read_mix(pose, "pose") if pose else (),
    )


EXAMPLES: Mapping[str, str] = {
    "face": "face='kaori=0.5+dog'", "expression": "expression='smile=0.7'", "channel": "channel='jawOpen=0.5'",
    "turn": "turn='30,-5'", "gaze": "gaze='10,-5'", "light": "light='theatre=0.5+flat'",
    "pose": "pose='bow'",
}  # fmt: skip
"""How each of them is written, for messages."""


def read_mix(text: str, what: str) -> Weights:
    """Reads a mix, `kaori=0.5+dog`, where names without a weight share what is left; ValueError where the weights do
    not sum to one.

    text: as it is typed; what: what messages call its parts, such as "face".
    """
    weights = share_rest(read_weights(text, what, (LOWEST, HIGHEST)))
    total = sum(weight for _, weight in weights)
    if abs(total - 1.0) > EVEN:
        raise ValueError(f"the {what}s in {text!r} weigh {total:g} together; give weights that sum to 1")
    return weights


def read_expression_mix(text: str) -> Weights:
    """Reads a mix of expressions, `smile=0.7`; ValueError where the weights exceed one."""
    weights = share_rest(read_weights(text, "expression", (LOWEST, HIGHEST)))
    total = sum(weight for _, weight in weights)
    if not LOWEST - EVEN <= total <= HIGHEST + EVEN:
        raise ValueError(f"the expressions {text!r} weigh {total:g} together; give weights that sum to 1 at most")
    return weights


def read_channels(text: str) -> Weights:
    """Reads channels (blendshape weights), `jawOpen=0.5+mouthSmileLeft`; one without a weight is full."""
    read = read_weights(text, "channel", (CHANNEL_LOWEST, CHANNEL_HIGHEST))
    return tuple((name, 1.0 if weight is None else weight) for name, weight in read)


def read_weights(text: str, what: str, limits: tuple[float, float]) -> list[tuple[str, float | None]]:
    """Reads names and weights, `one=0.5+two`, None where no weight is given; ValueError for anything else.

    text: as it is typed; what: what messages call its parts; limits: the least and the largest weight.
    """
    read = list[tuple[str, float | None]]()
    for part in filter(None, (part.strip() for part in text.split("+"))):
        name, equals, weight = part.partition("=")
        if "," in weight:
            raise ValueError(explain_comma(part, what))
        if not name.strip():
            raise ValueError(f"in {text!r} {part!r} is a weight of no {what}; write a name before it, as in name=0.5")
        number = check_within(read_number(weight, part), *limits, f"the weight in {part!r}") if equals else None
        read.append((name.strip(), number))
    return read


def explain_comma(part: str, what: str) -> str:
    """What to write for a part of a mix whose weight has a comma: of a decimal number, or between two names.

    part: of the mix, as it is typed; what: what messages call it.
    """
    pieces = [piece.strip() for piece in part.split(",")]
    if all(piece.isdecimal() for piece in pieces[1:]):
        return f"in {part!r} the weight has a comma; write it with a point, {'.'.join(pieces)}"
    return f"mixes of {what}s are written with +, not with commas; write {'+'.join(pieces)} for {part!r}"


def share_rest(read: list[tuple[str, float | None]]) -> Weights:
    """Shares what is left of one among the names without a weight."""
    count = sum(weight is None for _, weight in read)
    left = 1.0 - sum(weight for _, weight in read if weight is not None)
    return tuple((name, left / count if weight is None else weight) for name, weight in read)


def merge_names(
    weights: Weights, names: Mapping[str, object], what: str, labels: Mapping[str, str] = NO_LABELS
) -> dict[str, float]:
    """The weights by the names that are meant; ValueError for an unknown one, and for one that comes twice.

    weights: names as they are typed, with weights; names: those that there are; what: what messages call them; labels:
    what people read of them, by name.
    """
    merged = dict[str, float]()
    place = " in this cast" if names is not LIGHTS else ""
    for typed, weight in weights:
        try:  # both halves of an action unit may be channels; in a mix they would share its weight
            meant = find_names(typed, names, what, labels, where=place, halves=what == "channel")
        except ValueError as error:
            raise ValueError(f"{error}; mixes are written with +, as in a+b" if "," in typed else str(error)) from None
        for name in meant:
            if name in merged:
                raise ValueError(f"the {what} {name!r} comes twice; give it one weight")
            merged[name] = weight
    return merged


def read_angles(text: str, what: str, limits: Mapping[str, float]) -> list[float]:
    """Reads angles by commas, `30,0,-5`, degrees, to radians; ValueError for anything else.

    limits: radians either way, by the names of the angles in their order; what is left out is not given.

    text: as it is typed; what: what messages call it; limits: the largest size of each angle, radians, by its name.
    """
    parts = [part.strip() for part in text.split(",")] if text.strip() else []
    if len(parts) > len(limits):
        order = ", ".join(limits)
        raise ValueError(f"{what} {text!r} has {len(parts)} angles; give {len(limits)} at most, in degrees: {order}")
    return [_read_angle(part, f"the {what}'s {name}", limits[name]) for part, name in zip(parts, limits, strict=False)]


def _read_angle(part: str, what: str, limit: float) -> float:
    most = round(math.degrees(limit), ANGLE_DIGITS)
    try:
        degrees = float(part)
    except ValueError:
        raise ValueError(f"{what} is {part!r}, which is no number; give degrees, as in 30,-5") from None
    return math.radians(check_within(degrees, -most, most, f"{what} (degrees)"))


def read_number(text: str, whole: str) -> float:
    """Reads a number; ValueError, quoting the whole text that it came in, for anything else."""
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"in {whole!r} {text!r} is no number; write for instance 0.5") from None
