"""Points of bodies as a pose model gives them, made from figures of ours."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from omote.arrays import Points
from omote.builtin import load_cast
from omote.inputs.camera.body_points import BODY_POINTS, NUMBERS, BodyPoints
from omote.inputs.camera.head_pose import LENS
from omote.inputs.camera.solve_body import EAR, ELBOW, HIP, INDEX, LITTLE, SHOULDER, WRIST
from omote.model.body.pose import Pose
from omote.perform.figures.figure import pose_figure, resting_figure
from omote.perform.figures.pose_mix import mix_poses

CAST = load_cast()
assert CAST.figures is not None
FIGURES = CAST.figures
SKELETON = FIGURES.space.skeleton
RESTING = resting_figure(FIGURES, {next(iter(FIGURES.bodies)): 1.0}, CAST.faces["generic"].positions.astype(np.float64))
BONES = {
    SHOULDER: "upperarm01", ELBOW: "lowerarm01", WRIST: "wrist", LITTLE: "finger5-1", INDEX: "finger2-1",
    HIP: "upperleg01", HIP + 2: "lowerleg01", HIP + 4: "foot",
}  # fmt: skip
"""Which bone of ours begins at a point, of the left; the right one's is the next point."""
LENS_HEIGHT = 0.75
AWAY = 4.0
"""Metres from the camera to the hips."""


def joints_of(pose: Pose) -> Points:
    """Where the bones of a figure begin in a pose (J, 3), metres, along its axes."""
    return pose_figure(FIGURES.space, RESTING, mix_poses({"it": pose}, {"it": 1.0}, {}, {})).joints


def filmed_body(joints: Points, time: float = 0.0, hidden: Iterable[int] = (), noise: float = 0.0) -> BodyPoints:
    """The points of a figure before a camera that looks at its chest.

    joints (J, 3): of `joints_of`; time: seconds; hidden: points that are not seen; noise: metres, of each number.
    """
    at = np.zeros((BODY_POINTS, 3))
    for point, bone in BONES.items():
        for number, side in enumerate("LR"):
            at[point + number] = joints[SKELETON.places[f"{bone}.{side}"]]
    head = joints[SKELETON.places["head"]]
    for number, out in enumerate((1.0, -1.0)):
        at[EAR + number] = np.add(head, (0.07 * out, 0.05, 0.01))
    at += noise * np.random.default_rng(int(1000 * time) + 7).standard_normal(at.shape)
    hips = at[[HIP, HIP + 1]].mean(axis=0)
    lens = joints[SKELETON.places["root"]] + [0.0, 0.3, AWAY]
    seen = at - lens
    values = np.zeros((BODY_POINTS, NUMBERS), np.float32)
    values[:, :3] = (at - hips) * [1.0, -1.0, -1.0]
    values[:, 3] = 0.99
    values[:, 4] = 0.5 + LENS * seen[:, 0] / -seen[:, 2]
    values[:, 5] = 0.5 - LENS / LENS_HEIGHT * seen[:, 1] / -seen[:, 2]
    values[list(hidden), 3] = 0.05
    return BodyPoints(values, 640, 480, time)
