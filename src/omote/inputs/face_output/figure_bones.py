"""The bones of a figure on air as the humanoid of Unity and VRM, for programs that wear it on their own avatar."""

from __future__ import annotations

from collections.abc import Mapping

from omote.arrays import Floats
from omote.inputs.trackers.head_angles import BoneTurn
from omote.interchange.avatar.humanoid_pose import HIPS, humanoid_pose, rest_humanoid
from omote.interchange.avatar.vrm0_extension import unity_name
from omote.model.body.figures import Figures
from omote.model.body.pose import Pose
from omote.model.body.pose_regions import region_bones
from omote.perform.figures.evaluate_figure import turned_pose
from omote.perform.figures.pose_mix import mix_poses
from omote.perform.frame import Head, TrackedPose
from omote.show.objects.state import CharacterState


class FigureBones:
    """Turns what is called of a figure into the bones of a humanoid, on one body: angles fit all bodies."""

    def __init__(self, figures: Figures, head: Floats) -> None:
        """figures: of the cast; head (V, 3): a face at rest, metres, which its body hangs below."""
        body = next(iter(figures.bodies))
        self._rest = rest_humanoid(figures, {body: 1.0}, {body: head})
        self._ahead = self._rest.places[0] * [1.0, 0.0, 1.0]
        self._skeleton = figures.space.skeleton
        self._regions = region_bones(self._skeleton)

    def turns(self, character: CharacterState, poses: Mapping[str, Pose]) -> dict[str, BoneTurn]:
        """Every bone by Unity's name for it; none while nothing is called of the figure.

        character: as stages get it; poses: that can be called, by name.
        """
        called = character.figure
        if called is None:
            return {}
        sees = called.tracked
        tracked = None if sees is None else TrackedPose(tuple(sees.shares), sees.pose)
        mixed = mix_poses(poses, called.poses, called.regions, self._regions, character.idle)
        told = humanoid_pose(self._rest, turned_pose(self._skeleton, mixed, Head(*character.head), tracked))
        x, y, z = (told.places[0] - self._ahead).tolist()
        return {
            unity_name(name): BoneTurn((x, y, z) if name == HIPS else (0.0, 0.0, 0.0), (qx, qy, qz, qw))
            for name, (qx, qy, qz, qw) in zip(told.names, told.turns.tolist(), strict=True)
        }
