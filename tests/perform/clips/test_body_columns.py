"""A body as columns: what went in comes out, round and round, and only what moves has columns."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import omote
from omote.perform.clips.body_columns import TRAVEL_COLUMNS, BodyReader, body_columns, range_of
from omote.perform.figures.pose_mix import MixedPose

CAST = omote.load_cast()
BONES = CAST.bones


def poses(seed: int, count: int = 40) -> list[MixedPose]:
    """One who turns round twice on its feet while its bones swing."""
    random = np.random.default_rng(seed)
    swings = random.uniform(-1.0, 1.0, (len(BONES), 3))
    made = []
    for part in np.linspace(0.0, 1.0, count):
        turns = part * swings
        round_and_round = Rotation.from_rotvec([0.0, 4.0 * np.pi * part, 0.0])
        turns[0] = round_and_round.as_rotvec()
        feet_turns = np.tile(round_and_round.as_rotvec(), (2, 1))
        made.append(MixedPose(turns, part * swings[1], part * swings[2:4], feet_turns))
    return made


@pytest.mark.parametrize("seed", range(3))
def test_what_went_in_comes_out(seed: int) -> None:
    given = poses(seed)
    columns = body_columns(BONES, given)
    reader = BodyReader([*columns], BONES)
    table = np.array([*columns.values()]).T
    feet = [BONES.index("foot.L"), BONES.index("foot.R")]  # whose own turns count against the house
    for pose, values in zip(given, table, strict=True):
        back = reader.pose(values)
        apart = Rotation.from_rotvec(np.delete(pose.turns, feet, 0)).inv() * Rotation.from_rotvec(
            np.delete(back.turns, feet, 0)
        )
        assert apart.magnitude().max() < 1e-9
        assert (
            Rotation.from_rotvec(pose.feet_turns).inv() * Rotation.from_rotvec(back.feet_turns)
        ).magnitude().max() < 1e-7
        assert np.abs(back.travel - pose.travel).max() < 1e-12
        assert np.abs(back.feet - pose.feet).max() < 1e-12


def test_who_turns_round_and_round_has_no_jump_in_any_column() -> None:
    columns = body_columns(BONES, poses(1, count=120))
    assert max(np.abs(np.diff(values)).max() for values in columns.values()) < 0.25


def test_who_stands_has_the_columns_of_the_hips_alone() -> None:
    zeros = np.zeros((2, 3))
    columns = body_columns(BONES, [MixedPose(np.zeros((len(BONES), 3)), np.zeros(3), zeros, zeros)] * 3)
    assert tuple(columns) == TRAVEL_COLUMNS


def test_half_a_blend_is_half_a_turn_and_opposite_ways_are_none() -> None:
    quarter = Rotation.from_rotvec([0.0, np.pi / 2.0, 0.0]).as_rotvec()
    zeros = np.zeros((2, 3))
    turns = np.zeros((len(BONES), 3))
    turns[0] = quarter
    columns = body_columns(BONES, [MixedPose(turns, np.zeros(3), zeros, zeros)])
    reader = BodyReader([*columns], BONES)
    half = reader.pose(0.5 * np.array([values[0] for values in columns.values()]))
    assert half.turns[0] == pytest.approx(quarter / 2.0, abs=1e-9)


def test_columns_have_ranges_and_other_names_none() -> None:
    assert range_of("root/xx") == 2.0
    assert range_of("ankle.L/y") == 3.0
    assert range_of("spine05/x") == 3.5
    for name in ("root/x", "travel/xx", "spine05/w", "spine05", "/x"):
        assert range_of(name) is None
