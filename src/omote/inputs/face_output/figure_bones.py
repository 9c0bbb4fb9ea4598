"""The bones of a figure on air as the humanoid of Unity and VRM, for programs that wear it on their own avatar."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points
from omote.inputs.trackers.head_angles import BoneTurn
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.avatar.vrm0_extension import THUMBS
from omote.interchange.figures.t_pose import pose_t
from omote.model.body.figures import Figures
from omote.model.body.pose import Pose
from omote.model.body.pose_regions import region_bones
from omote.perform.figures.evaluate_figure import turned_pose
from omote.perform.figures.figure import pose_figure, resting_figure, skin_figure
from omote.perform.figures.pose_mix import mix_poses
from omote.perform.frame import Head
from omote.show.objects.state import CharacterState

HIPS = "Hips"


class FigureBones:
    """Turns what is called of a figure into the bones of a humanoid, on one body: angles fit all bodies."""

    def __init__(self, figures: Figures, head: Points) -> None:
        """figures: of the cast; head (V, 3): a face at rest, metres, which its body hangs below."""
        body = next(iter(figures.bodies.values()))
        self._figures = figures
        self._skeleton = figures.space.skeleton
        self._regions = region_bones(self._skeleton)
        self._resting = resting_figure(figures, {body.name: 1.0}, head)
        rest = pose_t(self._skeleton, self._resting, body.ends + (self._resting.joints[0] - body.joints[0]))
        self._back = np.swapaxes(rest.turns, 1, 2)
        places = {unity_name(name): self._skeleton.places[bone] for name, bone in humanoid_bones().items()}
        self._bones = {name: (place, self._parent_of(place, set(places.values()))) for name, place in places.items()}
        self._floor = float(skin_figure(figures.space, self._resting, rest)[:, 1].min())

    def turns(self, character: CharacterState, poses: Mapping[str, Pose]) -> dict[str, BoneTurn]:
        """Every bone by Unity's name for it; none while nothing is called of the figure.

        character: as stages get it; poses: that can be called, by name.
        """
        called = character.figure
        if called is None:
            return {}
        mixed = mix_poses(poses, called.poses, called.regions, self._regions, character.idle)
        turned = turned_pose(self._skeleton, mixed, Head(*character.head))
        posed = pose_figure(self._figures.space, self._resting, turned)
        world = posed.turns @ self._back
        own = [world[place] if parent < 0 else world[parent].T @ world[place] for place, parent in self._bones.values()]
        hips = posed.joints[0]
        places = {HIPS: (float(hips[0]), float(hips[1]) - self._floor, float(hips[2] - self._resting.joints[0, 2]))}
        quaternions = Rotation.from_matrix(np.stack(own)).as_quat().tolist()
        return {
            name: BoneTurn(places.get(name, (0.0, 0.0, 0.0)), (x, y, z, w))
            for name, (x, y, z, w) in zip(self._bones, quaternions, strict=True)
        }

    def _parent_of(self, bone: int, known: set[int]) -> int:
        """The nearest bone above it that the humanoid has; -1 for none."""
        above = int(self._skeleton.parents[bone])
        while above >= 0 and above not in known:
            above = int(self._skeleton.parents[above])
        return above


def unity_name(bone: str) -> str:
    """Unity's name (`HumanBodyBones`, as VMC and VRM 0.x have it) for a bone of VRM 1.0: the thumb's are others."""
    name = THUMBS.get(bone, bone)
    return name[0].upper() + name[1:]
