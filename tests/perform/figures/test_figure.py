"""Figures in motion: feet that stay, joints that keep to their boxes, calls without a jump."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import omote
from omote.builtin import load_figures
from omote.model.body.pose import STAND
from omote.model.body.pose_regions import POSE_REGIONS, region_bones
from omote.model.body.skeleton import SIDES
from omote.perform.figures.figure import HEAD_SHARES, pose_figure, resting_figure, skin_figure, turn_head
from omote.perform.figures.figure_axes import FACES_OWN, mixed_bodies
from omote.perform.figures.pose_mix import mix_poses

FIGURES = load_figures()
CAST = omote.load_cast()
SPACE = FIGURES.space
BONES = region_bones(SPACE.skeleton)
POSES = [*FIGURES.poses]
mixes = st.dictionaries(st.sampled_from(POSES), st.floats(0.01, 1.0), min_size=1, max_size=4).map(
    lambda mix: {name: weight / sum(mix.values()) for name, weight in mix.items()}
)


def resting(face: str, body: str):
    return resting_figure(FIGURES, {body: 1.0}, CAST.faces[face].positions.astype(np.float64))


RESTING = {body: resting("kaori", body) for body in ("generic", "child", "heavy", "gaunt")}


@given(mixes, st.sampled_from([*RESTING]))
def test_ankles_are_where_the_mix_of_poses_puts_them_and_bones_keep_their_lengths(mix: dict, body: str) -> None:
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


@given(mixes, mixes)
def test_a_mix_never_leaves_the_box_of_a_joint(one: dict, two: dict) -> None:
    mixed = mix_poses(FIGURES.poses, one, {"arm_left": two}, BONES).turns
    for region in POSE_REGIONS:
        names = two if region == "arm_left" else one
        each = np.stack([FIGURES.poses[name].turns[BONES[region]] for name in names])
        assert (mixed[BONES[region]] <= each.max(0) + 1e-9).all()
        assert (mixed[BONES[region]] >= each.min(0) - 1e-9).all()


def test_regions_part_all_bones() -> None:
    assert (np.sum([BONES[region] for region in POSE_REGIONS], axis=0) == 1).all()


@settings(max_examples=20)
@given(st.tuples(*[st.floats(-0.8, 0.8)] * 3))
def test_neck_and_spine_share_the_turn_of_the_head(head: tuple[float, float, float]) -> None:
    assert sum(HEAD_SHARES.values()) == pytest.approx(1.0)
    still = np.zeros((len(SPACE.skeleton.names), 3))
    turned = turn_head(SPACE.skeleton, still, np.array(head))
    np.testing.assert_allclose(turned.sum(axis=0), head, atol=1e-12)


def test_a_skinned_figure_has_its_head_on_its_neck() -> None:
    figure = RESTING["heavy"]
    bones = pose_figure(SPACE, figure, mix_poses(FIGURES.poses, {"bow": 1.0}, {}, BONES))
    rows = skin_figure(SPACE, figure, bones)
    edges = np.linalg.norm(np.diff(rows[SPACE.triangles[:, :2]], axis=1)[:, 0], axis=1)
    before = np.linalg.norm(np.diff(figure.rows[SPACE.triangles[:, :2]], axis=1)[:, 0], axis=1)
    rim = np.isin(SPACE.triangles, SPACE.rim_rows).any(axis=1)
    assert (edges[rim] < 1.5 * before[rim] + 1e-3).all()  # no gap opens


@given(st.dictionaries(st.sampled_from([*CAST.faces]), st.floats(0.1, 1.0), min_size=1, max_size=3))
def test_faces_bring_their_bodies_and_one_called_apart_stays(faces: dict) -> None:
    known = FIGURES.bodies
    assert mixed_bodies({FACES_OWN: 1.0}, faces, known) == pytest.approx(faces)
    assert mixed_bodies({"heavy": 1.0}, faces, known) == {"heavy": 1.0}
    assert set(mixed_bodies({FACES_OWN: 1.0}, {"unknown": 1.0}, known)) == {next(iter(known))}


def test_poses_are_called_interrupted_and_held_as_expressions_are() -> None:
    performer = omote.Performer(CAST)
    assert performer.advance(0.1).figure is None
    performer.call_pose("bow", seconds=1.0)
    before = performer.advance(0.4).figure.poses["bow"]
    rate = (performer.advance(1 / 240).figure.poses["bow"] - before) * 240
    performer.call_pose("wave", seconds=1.0)
    here = performer.advance(0.0).figure.poses["bow"]
    after = (performer.advance(1 / 240).figure.poses["bow"] - here) * 240
    assert after == pytest.approx(rate, rel=0.1)  # it goes on at its speed
    performer.call_pose("point", seconds=0.0, region="arm_right")
    figure = performer.advance(2.0).figure
    assert (figure.poses, figure.regions) == ({"wave": 1.0}, {"arm_right": {"point": 1.0}})
    restored = omote.Performer.restored(CAST, performer.snapshot())
    assert restored.advance(0.5) == performer.advance(0.5)
    performer.call_body("heavy", seconds=1.0)
    performer.call_body("own", seconds=0.0)
    assert performer.advance(0.0).figure.bodies == {FACES_OWN: 1.0}
    elsewhere = omote.Performer(CAST)
    elsewhere.call_pose("bow", seconds=0.5)
    elsewhere.call_pose("stand", seconds=0.5)
    assert elsewhere.advance(2.0).figure is None  # at rest as if nothing had been called
    performer.panic()
    still = performer.advance(1.0).figure
    assert still == performer.advance(1.0).figure
    for wrong in ({"name": "jump"}, {"name": "bow", "region": "tail"}, {"name": "bow", "seconds": -1.0}):
        with pytest.raises(ValueError, match=r"pose|region|seconds"):
            performer.call_pose(**wrong)
    with pytest.raises(ValueError, match="body"):
        performer.call_body("teapot")
