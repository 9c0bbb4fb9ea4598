"""The motion of a humanoid as a clip of a show: a lane of the body, and of the face where the file moves it."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from scipy.ndimage import uniform_filter1d
from scipy.spatial.transform import Rotation

from omote.arrays import Values
from omote.interchange.avatar.humanoid_pose import HumanoidRest, rest_humanoid
from omote.interchange.avatar.preset_expressions import custom_expressions, preset_weights
from omote.interchange.avatar.read_humanoid import pose_of_humanoid
from omote.interchange.clips.humanoid_motion import HIPS, HumanoidMotion
from omote.interchange.clips.soles import above_floor, cast_soles
from omote.model.body.skeleton import SIDES
from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.perform.channels import GAZE_UNITS
from omote.perform.clips.body_columns import body_columns
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.clip_parts import ClipPart
from omote.perform.clips.cut_clip import parts_by_channel
from omote.perform.clips.motion_curve import make_curve
from omote.perform.clips.packed_motion import rounded
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS

FASTEST = 60.0
"""Frames of a second that are kept: a cubic goes between them."""
MOST_FRAMES = 36_000
"""Ten minutes of bodies, sixty times a second: each frame is solved on a body."""
FAR_START = 1.0
FAR = 2.0
"""Leg lengths from the middle of the stage: one that begins farther off begins there, one that goes farther walks on
the spot."""
ASIDE = math.radians(45.0)
"""One that begins turned farther away from ahead is turned to it."""
STEP_SECONDS = 1.0
"""Over which the way of one who walks on the spot is taken off: about two steps."""


def clip_of_motion(
    motion: HumanoidMotion, cast: Cast, *, lane: str = "", start: float = 0.0, stop: float | None = None
) -> tuple[Clip, tuple[str, ...]]:
    """The clip of a motion.

    Parameters
    ----------
    motion : HumanoidMotion
        Of a file.
    cast : Cast
        With figures; which says what its expressions are, too.
    lane : str
        What to call its lane.
    start, stop : float
        Where the clip begins and ends, seconds of the motion; at its end where none is given.

    Returns
    -------
    clip : Clip
        Of one lane, which gives the parts that the file moves. A motion without legs turns the head alone.
    notes : tuple of str
        What is otherwise than in the file, in sentences.

    Raises
    ------
    ValueError
        On motion of too many frames, where nothing of it is a body's or a face's, on a cut that is not in it, and of a
        body for a cast without figures.
    """
    length = float(motion.times[-1] - motion.times[0])
    if (start or stop is not None) and not 0.0 <= start < (length if stop is None else stop) <= length + 1e-6:
        raise ValueError(f"{start:g} s to {stop or length:g} s is no part of the motion, which is {length:.3f} s long")
    placed, notes = place_motion(_thinned(motion))
    channels, left_out = _channels(placed.weights, cast)
    if left_out:
        notes = (*notes, f"nothing here is called {', '.join(left_out)[:200]}, so that is left out")
    parts: list[ClipPart] = [*PLAY_REGIONS] if channels else []
    body = None
    head = None
    if motion.stands:
        body = _body(placed, cast)
        parts.append("body")
    elif "head" in placed.names:
        head = _head_angles(placed)
        parts.append("head")
    gaze = None
    if placed.gaze is not None:
        gaze = np.clip(placed.gaze, *(np.array([*GAZE_LIMITS.values()]) * sign for sign in (-1.0, 1.0)))
        parts.append("gaze")
    if not parts:
        raise ValueError("nothing of the motion is of a body with legs or of a head; export a whole humanoid")
    curve = make_curve(
        placed.times, channels, parts_by_channel(channels, cast), head=head, gaze=gaze, body=body
    )  # fmt: skip
    clip = Clip([Lane(rounded(curve), lane, tuple(parts))], start=start, stop=stop)
    return clip, (*motion.notes, *notes)


def _body(motion: HumanoidMotion, cast: Cast) -> dict[str, Values]:
    """The columns of the body, solved on the first body of the cast; no body's feet are in the floor."""
    if cast.figures is None:
        raise ValueError("this cast has no bodies, so nobody can move as the file does")
    if len(motion.times) > MOST_FRAMES:
        raise ValueError(
            f"the motion has {len(motion.times)} frames; expected {MOST_FRAMES} at most: cut it into parts"
        )
    name = next(iter(cast.bodies))
    face = name if name in cast.faces else next(iter(cast.faces))
    rest = rest_humanoid(cast.figures, {name: 1.0}, {name: cast.faces[face].positions})
    left, right = (cast.bones.index(f"toes.{side}") for side in SIDES)
    return body_columns(cast.bones, above_floor(_poses(motion, rest), cast_soles(cast), (left, right)))


def place_motion(motion: HumanoidMotion) -> tuple[HumanoidMotion, tuple[str, ...]]:
    """A motion as it fits a stage, and what was changed of it, in sentences: it begins in the middle and ahead, and one
    that goes away walks on the spot. One that begins near there already stays as it is.

    motion: of a file.
    """
    hips = motion.hips.copy()
    turns = motion.turns
    notes = []
    place = motion.names.index(HIPS)
    ahead = Rotation.from_quat(turns[0, place]).apply([0.0, 0.0, 1.0])
    aside = math.atan2(ahead[0], ahead[2]) if math.hypot(ahead[0], ahead[2]) > 0.1 else 0.0
    if math.hypot(hips[0, 0], hips[0, 2]) > FAR_START:
        hips -= [hips[0, 0], 0.0, hips[0, 2]]
        notes.append("it begins in the middle of the stage")
    if abs(aside) > ASIDE:
        turn = Rotation.from_rotvec([0.0, -aside, 0.0])
        start = hips[0] * [1.0, 0.0, 1.0]
        hips = turn.apply(hips - start) + start
        turns = turns.copy()
        turns[:, place] = (turn * Rotation.from_quat(turns[:, place])).as_quat()
        notes.append(f"it begins ahead: it is turned by {math.degrees(-aside):.0f} degrees")
    if np.hypot(hips[:, 0], hips[:, 2]).max() > FAR:
        step = float(np.median(np.diff(motion.times))) if len(motion.times) > 1 else STEP_SECONDS
        way = uniform_filter1d(hips, max(round(STEP_SECONDS / step), 1), axis=0, mode="nearest")
        hips -= way * [1.0, 0.0, 1.0]
        notes.append("it goes farther than a stage is wide, so it moves on the spot")
    return _changed(motion, turns=turns, hips=hips), tuple(notes)


def _changed(motion: HumanoidMotion, *, turns: Values, hips: Values) -> HumanoidMotion:
    return HumanoidMotion(motion.times, motion.names, turns, hips, motion.weights, motion.gaze, motion.notes)


def _thinned(motion: HumanoidMotion) -> HumanoidMotion:
    """A motion with as many frames as are kept, from 0 s on."""
    times = motion.times - motion.times[0]
    step = float(np.median(np.diff(times))) if len(times) > 1 else 1.0
    every = max(math.floor(1.0 / FASTEST / step + 1e-3), 1)
    kept = slice(None, None, every)
    weights = {name: values[kept] for name, values in motion.weights.items()}
    gaze = None if motion.gaze is None else motion.gaze[kept]
    return HumanoidMotion(times[kept], motion.names, motion.turns[kept], motion.hips[kept], weights, gaze)


def _poses(motion: HumanoidMotion, rest: HumanoidRest) -> list[MixedPose]:
    """The pose of each frame."""
    poses = []
    for turns, hips in zip(motion.turns, motion.hips, strict=True):
        pose = pose_of_humanoid(rest, dict(zip(motion.names, turns, strict=True)), hips)
        poses.append(MixedPose(pose.turns, pose.travel, pose.feet, pose.feet_turns))
    return poses


def _head_angles(motion: HumanoidMotion) -> Values:
    """Yaw, pitch and roll of the head (n, 3), as far as heads turn."""
    yaw, pitch, roll = motion.worlds()["head"].as_euler("YXZ").T
    most = np.array([*HEAD_LIMITS.values()])
    return np.asarray(np.clip(np.column_stack([yaw, -pitch, -roll]), -most, most))


def _channels(weights: Mapping[str, Values], cast: Cast) -> tuple[dict[str, Values], list[str]]:
    """The weights of our channels, and the names of those that mean nothing here."""
    presets = preset_weights(cast)
    customs = custom_expressions(cast, ())
    channels: dict[str, Values] = {}
    left_out = []
    for name, values in weights.items():
        ours = presets.get(name)
        if ours is None:
            own = customs.get(name, name)
            ours = {own: 1.0} if own in cast.expressions else {}
            if not ours:
                left_out.append(name)
        for channel, part in ours.items():
            channels[channel] = np.clip(channels.get(channel, 0.0) + part * values, 0.0, 1.0)
    return {name: values for name, values in channels.items() if name not in GAZE_UNITS}, left_out
