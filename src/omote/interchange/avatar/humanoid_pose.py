"""A figure's pose as the bones of VRM: rotations of each against its parent, counted from the T-pose.

VRM Consortium, VRMC_vrm-1.0, "T-pose" and "Humanoid bones":
https://github.com/vrm-c/vrm-specification/blob/master/specification/VRMC_vrm-1.0
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Floats, Points, Values
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.figures.t_pose import pose_t
from omote.model.body.figures import Figures
from omote.model.body.skeleton import Skeleton
from omote.model.body.stand import shortest_turn, unit
from omote.perform.figures.figure import RestingFigure, pose_figure, resting_figure, skin_figure
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.mix import Weights

HIPS = "hips"


@dataclass(frozen=True, eq=False)
class HumanoidRest:
    """A figure in T-pose, of which its poses are told, and against which bones of other programs are read.

    names: of VRM's n bones, parents first; bones (n,): the place of each among ours; parents (n,): of its parent among
    VRM's, -1 for the hips; figures: of the cast; resting: as modelled; frames (J, 3, 3): rotations from the stand to
    the T-pose; places (n, 3): where each of VRM's bones begins, from its parent, true metres, of the hips above the
    ground, on which the T-pose stands; ground (3,): the point between the feet, on the floor of the stand, metres;
    size: by how much the figure is drawn larger than its person.
    """

    names: tuple[str, ...]
    bones: Values
    parents: Values
    figures: Figures
    resting: RestingFigure
    frames: Values
    places: Points
    ground: Points
    size: float

    @cached_property
    def leg(self) -> float:
        """The length of a leg, thigh and shin, true metres."""
        return self.resting.leg / self.size


@dataclass(frozen=True, eq=False)
class HumanoidPose:
    """names: of n bones, as VRM writes them, parents first; turns (n, 4): quaternions x, y, z, w against the parent
    from the T-pose; places (n, 3): where each begins from its parent, metres; all along our axes (x to the character's
    left, y up, z ahead)."""

    names: tuple[str, ...]
    turns: Values
    places: Points


def rest_humanoid(figures: Figures, bodies: Weights, faces: Mapping[str, Floats], /) -> HumanoidRest:
    """The T-pose of a mix of bodies, each below the face of its own.

    figures: of the cast; bodies: weights by name, sum one; faces: the rows (V, 3) of the face of each, metres.
    """
    skeleton = figures.space.skeleton
    head = sum(weight * faces[name].astype(np.float64) for name, weight in bodies.items())
    resting = resting_figure(figures, bodies, np.asarray(head))
    parts = [(weight, figures.bodies[name]) for name, weight in bodies.items()]
    joints, ends = (
        sum(weight * getattr(body, what).astype(np.float64) for weight, body in parts) for what in ("joints", "ends")
    )
    size = sum(weight * body.size for weight, body in parts)
    t_pose = pose_t(skeleton, resting, ends + (resting.joints[0] - joints[0]))
    ground = resting.ankles.mean(axis=0)
    ankles = t_pose.joints[[skeleton.places[f"foot.{side}"] for side in "LR"], 1].mean()
    ground[1] += skin_figure(figures.space, resting, t_pose)[:, 1].min() - ankles
    names = tuple(humanoid_bones())
    bones, parents = _places(skeleton)
    under = np.array([ground[0], ground[1] + ankles - resting.ankles[:, 1].mean(), ground[2]])
    places = t_pose.joints[bones] - np.where(parents[:, None] < 0, under, t_pose.joints[bones[parents]])
    return HumanoidRest(names, bones, parents, figures, resting, t_pose.frames, places / size, ground, size)


def humanoid_pose(rest: HumanoidRest, pose: MixedPose, /) -> HumanoidPose:
    """The bones of VRM in a pose; feet are where the pose puts them.

    What lies between two of VRM's bones (twists, upper necks, the lower spine) turns the next one below.

    rest: of `rest_humanoid`; pose: of `mix_poses`, the head's turn shared out.
    """
    bones = pose_figure(rest.figures.space, rest.resting, pose)
    turns = bones.frames[rest.bones] @ rest.frames[rest.bones].transpose(0, 2, 1)
    for side in ("left", "right"):  # VRM's forearm is one bone, from the elbow to where the hand is
        fore, hand = (rest.names.index(f"{side}{bone}") for bone in ("LowerArm", "Hand"))
        way = bones.joints[rest.bones[hand]] - bones.joints[rest.bones[fore]]
        turns[fore] = shortest_turn(unit(turns[fore] @ rest.places[hand]), unit(way)) @ turns[fore]
    above = np.where(rest.parents[:, None, None] < 0, np.eye(3), turns[rest.parents])
    own = Rotation.from_matrix(above.transpose(0, 2, 1) @ turns).as_quat(canonical=True)
    places = rest.places.copy()
    hips = rest.names.index(HIPS)
    places[hips] = (bones.joints[rest.bones[hips]] - rest.ground) / rest.size
    return HumanoidPose(rest.names, own, places)


def _places(skeleton: Skeleton) -> tuple[Values, Values]:
    """Of each of VRM's bones the place among ours (n,), and of its parent among VRM's (n,); -1 for the hips."""
    ours = [skeleton.places[bone] for bone in humanoid_bones().values()]
    at = {place: number for number, place in enumerate(ours)}
    parents = []
    for place in ours:
        above = int(skeleton.parents[place])
        while above >= 0 and above not in at:
            above = int(skeleton.parents[above])
        parents.append(at.get(above, -1))
    return np.array(ours, np.intp), np.array(parents, np.intp)
