"""Figures in motion: feet that stay, joints that keep to their boxes, calls without a jump."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import omote
from omote.builtin import load_figures
from omote.geometry import mesh
from omote.model.body.correctives import HINGES
from omote.model.body.pose import STAND
from omote.model.body.pose_regions import region_bones
from omote.model.body.posed_bones import pose_bones
from omote.model.body.skeleton import SIDES
from omote.perform.figures.figure import HEAD_SHARES, RestingFigure, pose_figure, resting_figure, skin_figure, turn_head
from omote.perform.figures.pose_mix import mix_poses

FIGURES = load_figures()
CAST = omote.load_cast()
SPACE = FIGURES.space
BONES = region_bones(SPACE.skeleton)
POSES = [*FIGURES.poses]
mixes = st.dictionaries(st.sampled_from(POSES), st.floats(0.01, 1.0), min_size=1, max_size=4).map(
    lambda mix: {name: weight / sum(mix.values()) for name, weight in mix.items()}
)


def resting(face: str, body: str) -> RestingFigure:
    return resting_figure(FIGURES, {body: 1.0}, CAST.faces[face].positions.astype(np.float64))


RESTING = {body: resting("kaori", body) for body in ("generic", "child", "heavy", "gaunt")}


@given(mixes, st.sampled_from([*RESTING]))
def test_ankles_are_where_the_mix_of_poses_puts_them_and_bones_keep_their_lengths(
    mix: dict[str, float], body: str
) -> None:
    figure = RESTING[body]
    pose = mix_poses(FIGURES.poses, mix, {}, BONES)
    standing = pose_figure(SPACE, figure, mix_poses(FIGURES.poses, {STAND: 1.0}, {}, BONES))
    posed = pose_figure(SPACE, figure, pose)
    for number, side in enumerate(SIDES):
        ankle = SPACE.skeleton.places[f"foot.{side}"]
        wanted = standing.joints[ankle] + pose.feet[number] * figure.leg
        hip = posed.joints[SPACE.skeleton.places[f"upperleg01.{side}"]]
        if np.linalg.norm(wanted - hip) < 0.99 * figure.leg:
            np.testing.assert_allclose(posed.joints[ankle], wanted, atol=1e-7)
    parents = SPACE.skeleton.parents
    lengths = [np.linalg.norm(each - each[parents], axis=1)[1:] for each in (posed.joints, figure.joints)]
    np.testing.assert_allclose(lengths[0], lengths[1], atol=1e-9)


@given(st.floats(0.0, 1.0), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.sampled_from([*RESTING]))
def test_feet_stay_whatever_a_figure_that_stands_breathes_and_however_its_weight_shifts(
    breath: float, left: float, chest: float, body: str
) -> None:
    """Legs that a shift of the hips outran let the feet slide by 2 mm."""
    standing, shifted = (
        pose_figure(SPACE, RESTING[body], mix_poses(FIGURES.poses, {STAND: 1.0}, {}, BONES, idle))
        for idle in ((0.0, 0.0, 0.0), (breath, left, chest))
    )
    for side in SIDES:
        ankle = SPACE.skeleton.places[f"foot.{side}"]
        np.testing.assert_allclose(shifted.joints[ankle], standing.joints[ankle], atol=1e-4)


@settings(max_examples=20)
@given(st.tuples(*[st.floats(-0.8, 0.8)] * 3))
def test_neck_and_spine_share_the_turn_of_the_head(head: tuple[float, float, float]) -> None:
    assert sum(HEAD_SHARES.values()) == pytest.approx(1.0)
    still = np.zeros((len(SPACE.skeleton.names), 3))
    turned = turn_head(SPACE.skeleton, still, np.array(head))
    np.testing.assert_allclose(turned.sum(axis=0), head, atol=1e-12)


def test_correctives_unfold_elbows_and_knees_that_bend_as_far_as_people_do() -> None:
    """Of the triangles that skinning alone turns over in their creases a seventh at most is left."""
    limbs = SPACE.bending[SPACE.bending_hinges < len(HINGES)]
    around = SPACE.triangles[np.isin(SPACE.triangles, limbs).all(axis=1)]
    turns = np.zeros((len(SPACE.skeleton.names), 3))
    for side in SIDES:
        turns[SPACE.skeleton.places[f"lowerarm01.{side}"], 0] = -1.9
        turns[SPACE.skeleton.places[f"lowerleg01.{side}"], 0] = 2.1
    over = []
    for face in CAST.bodies:
        figure = resting(face, face)
        bones = pose_bones(SPACE.skeleton, figure.joints, figure.stand, turns, np.zeros(3))
        turned = Rotation.from_matrix(bones.turns[SPACE.bones[around[:, 0], 0]])
        expected = turned.apply(mesh.unit_normals(figure.rows[around]))
        for each in (figure, replace(figure, correctives=np.zeros_like(figure.correctives))):
            normals = mesh.unit_normals(skin_figure(SPACE, each, bones)[around].astype(np.float64))
            over.append(np.count_nonzero((normals * expected).sum(axis=1) < -0.5))
    assert sum(over[::2]) <= sum(over[1::2]) / 7
    assert min(over[1::2]) > 0


def test_a_skinned_figure_has_its_head_on_its_neck() -> None:
    figure = RESTING["heavy"]
    bones = pose_figure(SPACE, figure, mix_poses(FIGURES.poses, {"bow": 1.0}, {}, BONES))
    rows = skin_figure(SPACE, figure, bones)
    edges = np.linalg.norm(np.diff(rows[SPACE.triangles[:, :2]], axis=1)[:, 0], axis=1)
    before = np.linalg.norm(np.diff(figure.rows[SPACE.triangles[:, :2]], axis=1)[:, 0], axis=1)
    rim = np.isin(SPACE.triangles, SPACE.rim_rows).any(axis=1)
    assert (edges[rim] < 1.5 * before[rim] + 1e-3).all()  # no gap opens
