"""Forward kinematics: where the bones of a body are in a pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.model.body.skeleton import Skeleton


@dataclass(frozen=True, eq=False)
class PosedBones:
    """turns (J, 3, 3): the rotation of each bone from the modelled pose; joints (J, 3): where it begins, metres;
    frames (J, 3, 3): its rotation from the stand."""

    turns: Values
    joints: Points
    frames: Values

    def shifts(self, rest: Points) -> Points:
        """Where each bone moves the origin, (J, 3) metres. rest (J, 3): where bones begin as modelled."""
        return np.asarray(self.joints - np.einsum("jab,jb->ja", self.turns, rest))


def pose_bones(skeleton: Skeleton, rest: Points, stand: Values, turns: Values, travel: Values) -> PosedBones:
    """The bones of a body in a pose.

    skeleton: of the body; rest (J, 3): where bones begin as modelled, metres; stand (J, 3, 3): of `stand_turns`;
    turns (J, 3): rotation vectors, radians, each against its parent from the stand, along the head's axes;
    travel (3,): of the first bone, metres.
    """
    own = Rotation.from_rotvec(turns).as_matrix()
    frames = np.empty_like(own)
    for bone, parent in enumerate(skeleton.parents):
        frames[bone] = own[bone] if parent < 0 else frames[parent] @ own[bone]
    return place_bones(skeleton, rest, stand, frames, travel)


def place_bones(skeleton: Skeleton, rest: Points, stand: Values, frames: Values, travel: Values) -> PosedBones:
    """The bones of a body whose rotations are known, each at the end of its parent.

    skeleton, rest, stand, travel: as of `pose_bones`; frames (J, 3, 3): the rotation of each bone from the stand.
    """
    turns = frames @ stand
    joints = np.empty_like(rest)
    for bone, parent in enumerate(skeleton.parents):
        if parent < 0:
            joints[bone] = rest[bone] + travel
        else:
            joints[bone] = joints[parent] + turns[parent] @ (rest[bone] - rest[parent])
    return PosedBones(turns, joints, frames)
