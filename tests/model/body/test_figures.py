"""Figures of the built-in cast: how heads join bodies, and the stand that all bodies share."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.builtin import load_figures
from omote.geometry import mesh
from omote.model.body.body import Body
from omote.model.body.figure_space import hang_joints, join_head
from omote.model.body.pose import STAND, Pose
from omote.model.body.skeleton import SIDES, Skeleton
from omote.model.body.stand import FOREARM, HAND, UPPER_ARM, hanging, stand_turns

FIGURES = load_figures()
CAST = omote.load_cast()
SPACE = FIGURES.space
weights = st.lists(st.floats(0.0, 1.0), min_size=17, max_size=17).filter(lambda values: sum(values) > 0.1)


def mixed(values: list[float], what: str) -> np.ndarray:
    shares = np.array(values) / sum(values)
    each = [
        CAST.faces[name].positions if what == "face" else getattr(FIGURES.bodies[name], what) for name in CAST.faces
    ]
    return np.einsum("i,ijk->jk", shares, np.stack(each).astype(np.float64))


def figure_of(faces: list[float], bodies: list[float]) -> np.ndarray:
    head = mixed(faces, "face")
    return np.concatenate([head, join_head(SPACE, mixed(bodies, "positions"), mixed(bodies, "edge"), head)])


def test_head_and_body_are_one_closed_mesh() -> None:
    triangles = np.concatenate([CAST.space.triangles, SPACE.triangles])
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()  # no rim is left
    assert set(SPACE.rim_rows) == set(SPACE.triangles[SPACE.triangles < SPACE.head_rows])
    assert len(np.unique(mesh.components(triangles, SPACE.head_rows + SPACE.body_rows))) == 1


@given(weights, weights, st.floats(0.0, 1.0))
def test_the_join_is_linear_in_faces_and_bodies(one: list[float], two: list[float], share: float) -> None:
    between = [(1.0 - share) * a / sum(one) + share * b / sum(two) for a, b in zip(one, two, strict=True)]
    first, second = figure_of(one, one), figure_of(two, two)
    np.testing.assert_allclose(figure_of(between, between), (1.0 - share) * first + share * second, atol=1e-9)
    np.testing.assert_allclose(figure_of(one, two)[: SPACE.head_rows], mixed(one, "face"), atol=0.0)


@pytest.mark.parametrize("name", CAST.faces)
def test_no_triangle_near_the_neck_turns_over_on_any_body(name: str) -> None:
    """As the body has it by itself, whichever face stands on it."""
    body = FIGURES.bodies[name]
    near = SPACE.triangles[np.isin(SPACE.triangles, np.r_[SPACE.joined + SPACE.head_rows, SPACE.edge]).any(axis=1)]
    own = np.zeros((SPACE.head_rows + SPACE.body_rows, 3))
    own[SPACE.edge] = body.edge
    own[SPACE.head_rows :] = body.positions
    before = mesh.unit_normals(own[near])
    for face in CAST.faces.values():
        head = face.positions.astype(np.float64)
        rows = np.concatenate(
            [head, join_head(SPACE, body.positions.astype(np.float64), body.edge.astype(np.float64), head)]
        )
        assert ((mesh.unit_normals(rows[near]) * before).sum(axis=1) > 0.0).all(), face.name


@given(weights)
def test_all_bodies_stand_alike(values: list[float]) -> None:
    head = mixed(values, "face")
    joints = hang_joints(SPACE, mixed(values, "joints"), mixed(values, "edge"), head)
    ends = mixed(values, "ends")
    turns = stand_turns(SPACE.skeleton, joints, ends)
    np.testing.assert_allclose(
        np.einsum("jab,jcb->jac", turns, turns), np.broadcast_to(np.eye(3), turns.shape), atol=1e-9
    )
    at = SPACE.skeleton.places
    for side in SIDES:
        for names, wanted in (
            (("upperarm01", "lowerarm01"), UPPER_ARM),
            (("lowerarm01", "wrist"), FOREARM),
            (("wrist", "finger3-1"), HAND),
        ):
            first, second = (at[f"{name}.{side}"] for name in names)
            way = turns[first] @ (joints[second] - joints[first])
            np.testing.assert_allclose(way / np.linalg.norm(way), hanging(*wanted, side), atol=2e-2)
        hip, ankle = at[f"upperleg01.{side}"], at[f"foot.{side}"]
        thigh = turns[hip] @ (joints[at[f"lowerleg01.{side}"]] - joints[hip])
        assert abs(math.degrees(math.atan2(thigh[0], -thigh[1]))) < 1.0
        assert turns[ankle][1] @ [0.0, 1.0, 0.0] == pytest.approx(1.0)  # soles are flat


def test_what_is_no_figure_is_rejected() -> None:
    with pytest.raises(ValueError, match="parents"):
        Skeleton(("root", "spine"), np.array([-1, 1], np.int32))
    with pytest.raises(ValueError, match="radians"):
        Pose("twisted", np.full((76, 3), 4.0))
    with pytest.raises(ValueError, match="expected three for each bone"):
        Pose("flat", np.zeros(76))
    body = FIGURES.bodies["generic"]
    with pytest.raises(ValueError, match="size"):
        Body("huge", body.positions, body.edge, body.joints, body.ends, size=20.0)
    with pytest.raises(ValueError, match="turns nothing"):
        omote.model.body.figures.Figures(SPACE, FIGURES.bodies, {STAND: FIGURES.poses["bow"]})
