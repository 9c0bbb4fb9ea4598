"""Parses poses as typed on the command line: finds the faces and expressions that their words name in a cast."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import msgspec

from omote.model.known_names import NEUTRAL
from omote.perform.complexion import complexion_of
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.frame import FigureFrame, Frame
from omote.perform.lights import FIRST_LIGHT
from omote.perform.scene.scene import FIRST_LABEL
from omote.perform.scene.scene_frame import CharacterFrame, Place
from omote.perform.snapshot import refuse_no_cast
from omote.show.state import NO_OFFSET, character_state
from omote.stage_data.playing_cast import PlayingCast, labels_of
from omote.stage_data.pose_words import EVEN, PoseWords, merge_names, read_pose

if TYPE_CHECKING:
    from omote.model.cast import Cast

Pose = dict[str, Any]


def parse_pose(
    cast: Cast | PlayingCast,
    *,
    face: str = "generic",
    expression: str = "neutral",
    channel: str = "",
    turn: str = "",
    gaze: str = "",
    light: str = FIRST_LIGHT,
    pose: str = "",
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
    channel : str
        What is added, "jawOpen=0.5+eyeBlinkLeft"; a channel without a weight is full.
    turn : str
        The head's yaw, pitch and roll, degrees, "30,-5"; what is left out is 0.
    gaze : str
        The eyes' yaw and pitch, degrees: eyes turn 40 sideways and 30 up or down.
    light : str
        A light or a mix, "theatre=0.5+flat".
    pose : str
        A pose of the figure or a mix, "bow=0.5+wave"; "" where it stands.

    Returns
    -------
    Frame
        For `render`, `evaluate` and `evaluate_parts`; its angles are radians.

    Raises
    ------
    ValueError
        For text that is not understood, unknown names, angles out of range, and weights that do not sum to one.
    TypeError
        For what is no text, and no cast.

    Examples
    --------
    >>> omote.parse_pose(cast, face="kaori=0.25+old", expression="smile=0.5").expressions
    {'smile': 0.5, 'neutral': 0.5}

    References
    ----------
    docs/conventions.md for weights and angles.
    """
    refuse_no_cast(cast)
    words = {"face": face, "expression": expression, "channel": channel, "turn": turn, "gaze": gaze, "pose": pose}
    return find_pose(cast, read_pose(**words, light=light))


def find_pose(cast: Cast | PlayingCast, words: PoseWords) -> Frame:
    """The frame of a pose whose words are read; ValueError for a name that the cast has not, or that comes twice."""
    labels = labels_of(cast)
    expressions = merge_names(words.expressions, cast.expressions, "expression", labels["expression"])
    rest = 1.0 - sum(expressions.values())
    if abs(rest) > EVEN:
        expressions[NEUTRAL] = expressions.get(NEUTRAL, 0.0) + rest
    frame = Frame(
        faces=merge_names(words.faces, cast.faces, "face", labels["face"]),
        expressions=expressions,
        channels=merge_names(words.channels, cast.expressions, "channel", labels["expression"]),
        head=words.head,
        gaze=words.gaze,
        light=words.light,
        figure=_find_figure(cast, words),
    )
    return replace(frame, complexion=complexion_of(cast.expressions, frame))


def _find_figure(cast: Cast | PlayingCast, words: PoseWords) -> FigureFrame | None:
    """What the figure of a pose does, None where it stands."""
    if not words.poses:
        return None
    poses = merge_names(words.poses, cast.poses, "pose", {name: pose.label for name, pose in cast.poses.items()})
    return FigureFrame(poses, {}, {FACES_OWN: 1.0}, None, {}, None, 0.0)


def pose_of(cast: Cast | PlayingCast, frame: Frame) -> Pose:
    """The pose of a frame for a stage, as plain values.

    cast: whose expressions the frame names; frame: faces, expressions, channels, head, gaze and light.
    """
    character = character_state(cast, CharacterFrame(frame, Place(), 1.0, FIRST_LABEL), NO_OFFSET)
    return {**msgspec.to_builtins(character), "light": dict(frame.light)}
