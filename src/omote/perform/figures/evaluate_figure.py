"""The vertices of a frame's figure: its face on its bodies, in its poses, the head turned."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Floats, Points, Values
from omote.model.body.correctives import hinge_bends
from omote.model.body.pose import STAND
from omote.model.body.pose_regions import POSE_REGIONS, region_bones
from omote.model.body.skeleton import Skeleton
from omote.model.cast import Cast
from omote.perform.blending.evaluate import evaluate
from omote.perform.channels import channels_of
from omote.perform.figures.figure import pose_figure, resting_figure, skin_figure, turn_head
from omote.perform.figures.figure_axes import FACES_OWN, mixed_bodies
from omote.perform.figures.limb_mix import limb_weights, wear_limb_fields
from omote.perform.figures.packed_pose import unpack_pose
from omote.perform.figures.pose_mix import MixedPose, mix_poses
from omote.perform.figures.tracked_body import with_tracked
from omote.perform.frame import Frame, Head, TrackedPose
from omote.perform.mix import combine


def evaluate_figure(cast: Cast, frame: Frame) -> Floats:
    """The skin of a frame's head and body, as stages pose and skin them.

    Parameters
    ----------
    cast : Cast
        One with figures, that has all that the frame names.
    frame : Frame
        From `Performer.advance`; a figure that nothing was called of stands, each face on its own body.

    Returns
    -------
    ndarray of float32, (V + B, 3)
        Metres, in the axes of the head: the rows of `evaluate`, then those of the body and its skirt
        (`cast.figures.space`), without cloth and shoes.

    Raises
    ------
    ValueError
        As `evaluate`, and for a cast without figures.

    Examples
    --------
    >>> performer = omote.Performer(cast)
    >>> performer.call_pose("bow", seconds=2)
    >>> omote.evaluate_figure(cast, performer.advance(1)).shape
    (14100, 3)

    References
    ----------
    docs/method.md, "Bodies and poses".
    """
    if cast.figures is None:
        raise ValueError("this cast has no bodies and poses; evaluate gives the head alone")
    space = cast.figures.space
    on = frame.figure
    head = evaluate(cast, frame).astype(np.float64)
    bodies = mixed_bodies({FACES_OWN: 1.0} if on is None else on.bodies, frame.faces, cast.bodies)
    resting = resting_figure(cast.figures, bodies, head, _mixed_faces(cast, frame))
    poses = ({STAND: 1.0}, {}) if on is None else (on.poses, on.regions)
    mixed = mix_poses(cast.poses, *poses, region_bones(space.skeleton), frame.idle)
    posed = turned_pose(space.skeleton, mixed, frame.head, None if on is None else on.tracked)
    bones = pose_figure(space, resting, posed)
    bends = hinge_bends(space.skeleton, bones.joints)
    worn = limb_weights(cast.figures.limb_fields, _called(cast, frame), bends, frame.idle[0])
    return skin_figure(space, wear_limb_fields(cast.figures, resting, worn), bones)


def _called(cast: Cast, frame: Frame) -> dict[str, float]:
    """The weights of expressions and channels on air, added up; a region of the face has no limbs."""
    return combine(((1.0, frame.expressions), (1.0, channels_of(cast.expressions, frame))))


def turned_pose(skeleton: Skeleton, pose: MixedPose, head: Head, tracked: TrackedPose | None = None) -> MixedPose:
    """A pose with a tracked body in its place, and with the head's own direction, which neck and spine share.

    skeleton: of the figure; pose: of `mix_poses`; head: its direction; tracked: as of `FigureFrame`.
    """
    trunk = 0.0
    if tracked is not None:
        bones = region_bones(skeleton)
        numbers = unpack_pose(tracked.pose, len(skeleton.names))
        pose = with_tracked(pose, tracked.shares, numbers, tuple(bones[region] for region in POSE_REGIONS))
        trunk = tracked.shares[POSE_REGIONS.index("trunk")]
    return replace(pose, turns=turn_head(skeleton, pose.turns, turn_of(head), trunk))


def turn_of(head: Head) -> Values:
    """The rotation vector (3,) of a head's direction, radians: yaw, then pitch, then roll, as stages turn it."""
    return np.asarray(Rotation.from_euler("YXZ", [head.yaw, -head.pitch, -head.roll]).as_rotvec())


def _mixed_faces(cast: Cast, frame: Frame) -> Points:
    """The faces on air at rest (V, 3), which carry the joints."""
    faces = [weight * cast.faces[name].positions.astype(np.float64) for name, weight in frame.faces.items()]
    return np.asarray(sum(faces))
