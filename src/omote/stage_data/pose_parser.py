"""Parses poses as typed on the command line: mixes, channels and angles."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import msgspec

from omote.perform.frame import Frame, Gaze, Head
from omote.perform.lights import FIRST_LIGHT, LIGHTS
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_within
from omote.perform.mix import HIGHEST, LOWEST
from omote.perform.name_lookup import NO_LABELS, find_name
from omote.show.state import state_of
from omote.stage_data.playing_cast import PlayingCast, labels_of

if TYPE_CHECKING:
    from omote.model.cast import Cast

Pose = dict[str, Any]
EVEN = 1e-6
"""Tolerance of a mix's sum of one: people type three digits."""


def parse_pose(
    cast: Cast | PlayingCast,
    *,
    face: str = "generic",
    expression: str = "neutral",
    channels: str = "",
    turn: str = "",
    gaze: str = "",
    light: str = FIRST_LIGHT,
) -> Frame:
    """The frame of a pose that is written in words, as `omote render` takes it.

    Parameters
    ----------
    cast : Cast
        The faces and expressions that the words may name, in any case and by their labels.
    face : str
        A face or a mix, "kaori=0.5+dog"; names without a weight share what is left of one.
    expression : str
        An expression or a mix, "smile=0.7"; what is left of one is neutral.
    channels : str
        What is added, "jawOpen=0.5+eyeBlinkLeft"; a channel without a weight is full.
    turn : str
        The head's yaw, pitch and roll, degrees, "30,-5"; what is left out is 0.
    gaze : str
        The eyes' yaw and pitch, degrees.
    light : str
        A light or a mix, "theatre=0.5+flat".

    Returns
    -------
    Frame
        For `render`, `evaluate` and `evaluate_parts`; its angles are radians.

    Raises
    ------
    ValueError
        For text that is not understood, unknown names, and weights that do not sum to one.

    Examples
    --------
    >>> omote.parse_pose(cast, face="kaori=0.25+old", expression="smile=0.5").expressions
    {'smile': 0.5, 'neutral': 0.5}

    References
    ----------
    docs/conventions.md for weights and angles.
    """
    labels = labels_of(cast)
    return Frame(
        faces=parse_mix(face, cast.faces, "face", labels["face"]),
        expressions=parse_expression_mix(expression, cast.expressions, labels["expression"]),
        channels=parse_channels(channels, cast.expressions, labels["expression"]),
        head=Head(*parse_angles(turn, 3, "turn")),
        gaze=Gaze(*parse_angles(gaze, 2, "gaze")),
        light=parse_mix(light, LIGHTS, "light"),
    )


def pose_of(cast: Cast | PlayingCast, frame: Frame) -> Pose:
    """The pose of a frame for a stage, as plain values."""
    pose: Pose = msgspec.to_builtins(state_of(cast, frame, epoch=0, number=0, revision=0))
    return pose


def parse_mix(text: str, names: Iterable[str], what: str, labels: Mapping[str, str] = NO_LABELS) -> dict[str, float]:
    """Parses a mix, `kaori=0.5+dog`; ValueError where the weights do not sum to one."""
    weights = share_rest(parse_weights(text, names, what, (LOWEST, HIGHEST), labels))
    total = sum(weights.values())
    if abs(total - 1.0) > EVEN:
        raise ValueError(f"the {what}s in {text!r} weigh {total:g} together; give weights that sum to 1")
    return weights


def parse_expression_mix(text: str, names: Iterable[str], labels: Mapping[str, str] = NO_LABELS) -> dict[str, float]:
    """Parses a mix of expressions, `smile=0.7`, the rest neutral; ValueError where the weights exceed one."""
    weights = share_rest(parse_weights(text, names, "expression", (LOWEST, HIGHEST), labels))
    rest = 1.0 - sum(weights.values())
    if not LOWEST - EVEN <= rest <= HIGHEST + EVEN:
        raise ValueError(f"the expressions {text!r} weigh {1.0 - rest:g} together; give weights that sum to 1 at most")
    if abs(rest) > EVEN:
        weights["neutral"] = weights.get("neutral", 0.0) + rest
    return weights


def parse_channels(text: str, names: Iterable[str], labels: Mapping[str, str] = NO_LABELS) -> dict[str, float]:
    """Parses channels (blendshape weights), `jawOpen=0.5+mouthSmileLeft`; one without a weight is full."""
    read = parse_weights(text, names, "channel", (CHANNEL_LOWEST, CHANNEL_HIGHEST), labels)
    return {name: 1.0 if weight is None else weight for name, weight in read.items()}


def parse_weights(
    text: str, names: Iterable[str], what: str, limits: tuple[float, float], labels: Mapping[str, str] = NO_LABELS
) -> dict[str, float | None]:
    """Parses names and weights, `one=0.5+two`, None where no weight is given; ValueError for anything else."""
    choices, read = list(names), dict[str, float | None]()
    for part in filter(None, (part.strip() for part in text.split("+"))):
        name, given, weight = part.partition("=")
        name = find_name(name.strip(), choices, what, labels)
        if name in read:
            raise ValueError(f"the {what} {name!r} comes twice in {text!r}; give it one weight")
        read[name] = check_within(parse_number(weight, part), *limits, f"the weight in {part!r}") if given else None
    return read


def share_rest(read: dict[str, float | None]) -> dict[str, float]:
    """Shares what is left of one among the names without a weight."""
    open_names = [name for name, weight in read.items() if weight is None]
    left = 1.0 - sum(weight for weight in read.values() if weight is not None)
    return {name: left / len(open_names) if weight is None else weight for name, weight in read.items()}


def parse_angles(text: str, count: int, what: str) -> list[float]:
    """Parses up to `count` angles, `30,0,-5`, degrees, to radians; ValueError for anything else."""
    parts = [part.strip() for part in text.split(",")] if text.strip() else []
    if len(parts) > count:
        raise ValueError(f"{what} {text!r} has {len(parts)} angles; give {count} at most, in degrees, as in 30,-5")
    return [math.radians(check_within(parse_number(part, text), -90.0, 90.0, f"{what} (degrees)")) for part in parts]


def parse_number(text: str, whole: str) -> float:
    """Parses a number; ValueError, quoting the whole text that it came in, for anything else."""
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"in {whole!r} {text!r} is no number; write for instance 0.5") from None
