"""A right hand of the CC0 body in the pinned package: its mesh, its bones, and how it looks in a pose."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tools.baking.bodies.rig import RIG, WEIGHTS, end_rows
from tools.baking.heads.basemesh import BaseMesh, read_base_mesh, read_target
from tools.baking.package import Package

Values = NDArray[np.float64]
BASE = "mpfb2/3dobjs/base.obj"
FINGERS = (1, 2, 3, 4, 5)
"""Of the rig: the thumb, then from the index to the little finger."""
FOREARM = ("lowerarm01.R", "lowerarm02.R")
METRES = 0.1
"""A unit of the base mesh, decimetres."""
SHAPES = ("fingers-diameter", "fingers-length", "fingers-distance", "scale")
"""The proportions of a hand for which the package has targets."""

FOLLOWS = 0.8
"""By how much the middle finger curls with the index, and the ring finger with the little one."""


@dataclass(frozen=True)
class HandPose:
    """opening: of the mouth that thumb and fingers make, 0 to 1; curls: of the index with the middle finger, of the
    little with the ring finger, -1 (lifted, straight) to 1 (bent); yaw, pitch, roll: of the wrist, radians, about the
    palm's normal, its width and the fingers' direction; spread: of the fingers, radians."""

    opening: float = 0.0
    curls: tuple[float, float] = (0.0, 0.0)
    yaw: float = 0.0
    pitch: float = 0.0
    roll: float = 0.0
    spread: float = 0.0


@dataclass(frozen=True, eq=False)
class Bone:
    """name; parent: its place among the bones, -1 for none; head, tail: metres; finger: 1 to 5, 0 for none."""

    name: str
    parent: int
    head: Values
    tail: Values
    finger: int
    joint: int


class RiggedHand:
    """A hand and half a forearm, which can be posed; its axes: the columns of `frame` are the palm's width (from the
    little finger to the index), the direction of the fingers and the palm's normal, out of the palm."""

    def __init__(self, package: Package, shape: Mapping[str, float]) -> None:
        """shape: how far a proportion of `SHAPES` goes, -1 to 1, 0 where it is not named."""
        base = read_base_mesh(package.text(BASE))
        points = base.points.copy()
        for name, amount in shape.items():
            end = "incr" if amount > 0.0 else "decr"
            target = package.text(f"mpfb2/targets/hands/r-hand-{name}-{end}.target.gz")
            points += abs(amount) * read_target(target, len(points))
        points *= METRES
        rig: Mapping[str, Any] = json.loads(package.text(RIG))
        weights: Mapping[str, list[list[float]]] = json.loads(package.text(WEIGHTS))["weights"]
        self.bones = _bones(rig, points, base)
        table = np.zeros((len(points), len(self.bones)))
        for place, bone in enumerate(self.bones):
            for vertex, weight in weights.get(bone.name, ()):
                table[int(vertex), place] = weight
        body = base.groups["body"].corners
        kept = (table.sum(1)[body] > 0.5).all(1)
        used, corners = np.unique(body[kept], return_inverse=True)
        quads = corners.reshape(-1, 4).astype(np.int32)
        self.triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        self.points = points[used]
        self.weights = table[used] / table[used].sum(1, keepdims=True)
        self.frame = self._frame()
        self.wrist = self._bone("wrist.R").head

    def pose(self, pose: HandPose) -> Values:
        """The points (n, 3) of a pose, metres about the wrist, along the palm's axes."""
        turns = [self._turn(bone, pose) for bone in self.bones]
        placed: list[tuple[Values, Values]] = []
        for bone, turn in zip(self.bones, turns, strict=True):
            rotation, shift = (np.eye(3), np.zeros(3)) if bone.parent < 0 else placed[bone.parent]
            place = rotation @ bone.head + shift
            turned = rotation @ turn
            placed.append((turned, place - turned @ bone.head))
        moved = np.zeros_like(self.points)
        for (rotation, shift), weight in zip(placed, self.weights.T, strict=True):
            moved += weight[:, None] * (self.points @ rotation.T + shift)
        result: Values = (moved - self.wrist) @ self.frame
        return result

    def _bone(self, name: str) -> Bone:
        return next(bone for bone in self.bones if bone.name == name)

    def _frame(self) -> Values:
        wrist = self._bone("wrist.R").head
        along = self._bone("finger3-1.R").head - wrist
        along /= np.linalg.norm(along)
        across = self._bone("finger2-1.R").head - self._bone("finger5-1.R").head
        across -= along * (across @ along)
        across /= np.linalg.norm(across)
        return np.stack([across, along, np.cross(across, along)], 1)

    def _turn(self, bone: Bone, pose: HandPose) -> Values:
        across, along, normal = self.frame.T
        if bone.name == "wrist.R":
            return (
                rotation_about(normal, pose.yaw) @ rotation_about(across, pose.pitch) @ rotation_about(along, pose.roll)
            )
        if bone.finger == 0 or bone.joint == 0:
            return np.eye(3)
        direction = bone.tail - bone.head
        direction /= np.linalg.norm(direction)
        if bone.finger == 1:
            return self._thumb(bone, direction, pose.opening)
        bend = rotation_about(np.cross(direction, normal), _flexion(bone, pose))
        if bone.joint == 1:
            bend = bend @ rotation_about(normal, pose.spread * (3.5 - bone.finger))
        return bend

    def _thumb(self, bone: Bone, direction: Values, opening: float) -> Values:
        """The thumb goes below the palm and meets the fingers where the mouth is shut."""
        across, along, normal = self.frame.T
        axis = np.cross(direction, along)
        axis /= np.linalg.norm(axis)
        if bone.joint == 1:
            below = rotation_about(along, -np.radians(58.0))
            return rotation_about(across, np.radians(8.0 + 22.0 * opening)) @ below @ rotation_about(normal, 0.25)
        return rotation_about(axis, np.radians((14.0 if bone.joint == 2 else 8.0) - 12.0 * opening))


def _flexion(bone: Bone, pose: HandPose) -> float:
    """By how much a joint of a finger is bent, radians."""
    curl = {2: 1.0, 3: FOLLOWS, 4: FOLLOWS, 5: 1.0}[bone.finger] * pose.curls[bone.finger > 3]
    shut = 1.0 - pose.opening
    if bone.joint == 1:
        return float(np.radians(12.0 + 46.0 * shut + min(curl, 0.0) * 20.0))
    return float(np.radians(12.0 + 10.0 * shut + (40.0 * curl if curl > 0.0 else 14.0 * curl)))


def _bones(rig: Mapping[str, Any], points: Values, base: BaseMesh) -> list[Bone]:
    names = [*FOREARM, "wrist.R", *(f"metacarpal{number}.R" for number in range(1, 5))]
    names += [f"finger{finger}-{joint}.R" for finger in FINGERS for joint in (1, 2, 3)]

    def place(end: Mapping[str, Any]) -> Values:
        result: Values = points[end_rows(end, base)].mean(0)
        return result

    bones = []
    for name in names:
        parent = rig[name]["parent"]
        finger, joint = (int(part) for part in name[6:-2].split("-")) if name.startswith("finger") else (0, 0)
        above = names.index(parent) if parent in names else -1
        bones.append(Bone(name, above, place(rig[name]["head"]), place(rig[name]["tail"]), finger, joint))
    return bones


def rotation_about(axis: Values, angle: float) -> Values:
    """The rotation (3, 3) about an axis (3,), right-handed. angle: radians."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    result: Values = np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * (cross @ cross)
    return result
