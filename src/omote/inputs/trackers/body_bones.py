"""The bones of a body as trackers send them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.inputs.trackers.head_angles import Quaternion
from omote.model.body.pose_regions import PoseRegion

STILL = 3.0
"""Degrees that a bone turns before its region counts as seen: who tracks faces alone sends bones that never move."""


@dataclass(frozen=True)
class BodyBones:
    """What a sender says of a body. turns: by VRM's name, quaternions x, y, z, w against the parent from the T-pose,
    along our axes, without neck and head, which turn as the head does; hips: where they are above the sender's floor,
    metres, None where it says no place; leg: the length of its legs, metres, 0 where it does not say that; head:
    whether it says where its head is."""

    turns: Mapping[str, Quaternion]
    hips: tuple[float, float, float] | None = None
    leg: float = 0.0
    head: bool = False


def region_of(bone: str) -> PoseRegion:
    """The region of one of VRM's bones, by its name."""
    if bone in ("spine", "chest", "upperChest"):
        return "trunk"
    if bone == "hips" or bone.endswith(("Leg", "Foot", "Toes")):
        return "stance"
    return "arm_left" if bone.startswith("left") else "arm_right"


def moved_regions(first: Mapping[str, Quaternion], now: Mapping[str, Quaternion]) -> set[PoseRegion]:
    """The regions in which a bone has turned by more than `STILL`. first, now: turns by VRM's names."""
    names = [name for name in now if name in first]
    if not names:
        return set()
    dots = np.abs((np.array([first[name] for name in names]) * np.array([now[name] for name in names])).sum(axis=1))
    least = np.cos(np.radians(STILL / 2.0))
    return {region_of(name) for name, dot in zip(names, dots.tolist(), strict=True) if dot < least}
