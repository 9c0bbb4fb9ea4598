"""The body of a clip as the motion of a humanoid, for files of other programs."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Points
from omote.interchange.avatar.humanoid_pose import HumanoidRest, humanoid_pose
from omote.interchange.clips.clip_frames import ClipFrames
from omote.interchange.clips.humanoid_motion import HIPS, HumanoidMotion, check_size
from omote.perform.clips.body_columns import BodyReader
from omote.perform.clips.clip import Clip
from omote.perform.clips.clip_parts import BODY
from omote.perform.figures.evaluate_figure import turned_pose
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.frame import Head


@dataclass(frozen=True, eq=False)
class AnimatedBody:
    """motion: what the bones do; places (b, 3): where each begins in T-pose, from its parent, of the hips above the
    floor, metres; leg: the length of one, metres."""

    motion: HumanoidMotion
    places: Points
    leg: float


def animated_body(clip: Clip, frames: ClipFrames, rest: HumanoidRest) -> AnimatedBody:
    """The motion of a clip with the figure that wears it; parameters and errors as of `motion_of_clip`.

    clip, frames, rest: as of `motion_of_clip`.
    """
    return AnimatedBody(motion_of_clip(clip, frames, rest), rest.places, rest.leg)


def motion_of_clip(clip: Clip, frames: ClipFrames, rest: HumanoidRest) -> HumanoidMotion:
    """What the bones of a humanoid do in a clip, with the turn of its head.

    Parameters
    ----------
    clip : Clip
        With a body.
    frames : ClipFrames
        Of it.
    rest : HumanoidRest
        The figure that wears it; where it takes a part of the body alone, the figure stands for the rest.

    Returns
    -------
    HumanoidMotion
        At the times of the frames.

    Raises
    ------
    ValueError
        On more frames than a motion has.
    """
    skeleton = rest.figures.space.skeleton
    check_size(len(frames.times), len(rest.names))
    reader = BodyReader(clip.layout.columns, skeleton.names)
    hips = rest.names.index(HIPS)
    turns = []
    places = []
    for time, head in zip(frames.times.tolist(), frames.head.tolist(), strict=True):
        sample = clip.sample(min(time * clip.speed, clip.seconds))
        pose = _part(reader.pose(sample.values), float(sample.shares[BODY]))
        told = humanoid_pose(rest, turned_pose(skeleton, pose, Head(*head)))
        turns.append(told.turns)
        places.append((told.places[hips] - rest.places[hips]) / rest.leg)
    return HumanoidMotion(frames.times, rest.names, np.array(turns), np.array(places))


def _part(pose: MixedPose, share: float) -> MixedPose:
    """A pose by a share, over the stand, which is zero throughout."""
    if share == 1.0:
        return pose
    return replace(pose, **{name: share * values for name, values in vars(pose).items()})
