"""Bones that move are seen; a sender whose bones stand still has no body."""

import math

import pytest

from omote.inputs.trackers.body_bones import STILL, moved_regions, region_of
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.model.body.pose_regions import POSE_REGIONS

NONE = (0.0, 0.0, 0.0, 1.0)


def about_y(degrees: float) -> tuple[float, float, float, float]:
    half = math.radians(degrees / 2.0)
    return 0.0, math.sin(half), 0.0, math.cos(half)


@pytest.mark.parametrize(
    ("bone", "region"),
    [("upperChest", "trunk"), ("hips", "stance"), ("leftToes", "stance"), ("leftThumbDistal", "arm_left"),
     ("rightShoulder", "arm_right")],
)  # fmt: skip
def test_a_bone_belongs_to_a_region(bone: str, region: str) -> None:
    assert region_of(bone) == region


def test_every_bone_of_the_humanoid_has_one() -> None:
    names = set(humanoid_bones()) - {"neck", "head"}
    assert {region_of(name) for name in names} == set(POSE_REGIONS) - {"head"}


def test_a_region_is_seen_when_a_bone_of_it_has_turned_either_way_and_under_either_sign() -> None:
    first = {"hips": NONE, "leftHand": NONE, "rightHand": NONE, "spine": NONE}
    now = {"hips": about_y(0.9 * STILL), "leftHand": about_y(1.1 * STILL), "rightHand": about_y(-1.1 * STILL)}
    negative = {"spine": (0.0, 0.0, 0.0, -1.0), "chest": about_y(90.0)}
    assert moved_regions(first, now | negative) == {"arm_left", "arm_right"}
    assert moved_regions({}, now) == set()
