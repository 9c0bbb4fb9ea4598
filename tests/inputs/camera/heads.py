"""Heads of landmarks for tests: a face that is none of anybody's, turned and moved before a camera as one wants."""

import numpy as np

from omote.inputs.camera.head_pose import DEPTH, LENS
from omote.inputs.camera.landmark_frame import LANDMARKS, LandmarkFrame
from omote.inputs.camera.landmark_map import load_landmark_map
from omote.inputs.trackers.head_angles import HeadAngles


def mean_face() -> np.ndarray:
    """The mean face (478, 3) of all who were seen in the training."""
    return np.array(load_landmark_map().compression.rest_mean, np.float64).reshape(LANDMARKS, 3)


def rotation(head: HeadAngles) -> np.ndarray:
    """By yaw about y, then by -pitch about x, then by -roll about z."""
    yaw = head[0]
    pitch = -head[1]
    roll = -head[2]
    y = np.array([[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]])
    x = np.array([[1, 0, 0], [0, np.cos(pitch), -np.sin(pitch)], [0, np.sin(pitch), np.cos(pitch)]])
    z = np.array([[np.cos(roll), -np.sin(roll), 0], [np.sin(roll), np.cos(roll), 0], [0, 0, 1]])
    return np.asarray(y @ x @ z)


def frame_of(
    face: np.ndarray, head: HeadAngles = (0.0, 0.0, 0.0), *, scale: float = 0.12, time: float = 0.0,
    place: tuple[float, float] = (0.0, 0.0), width: int = 640, height: int = 480,
) -> LandmarkFrame:  # fmt: skip
    """A face (478, 3) as the camera page would send it: turned, so large (in widths of the picture), at a place."""
    points = scale * face @ rotation(head).T + [*place, 0.0]
    near = 1.0 - points[:, 2] / LENS
    x, y = points[:, 0] / near, points[:, 1] / near
    sent = np.stack([0.5 + x, 0.5 - y * width / height, -points[:, 2] / DEPTH], axis=1)
    return LandmarkFrame(sent.astype(np.float32), width, height, time)
