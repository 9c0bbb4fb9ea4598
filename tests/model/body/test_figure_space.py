"""The space of figures: heads join bodies without a gap, linearly, and nothing turns over."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.builtin import load_figures
from omote.geometry import mesh
from omote.model.body.figure_space import hang_joints, join_head

FIGURES = load_figures()
CAST = omote.load_cast()
SPACE = FIGURES.space
weights = st.lists(st.floats(0.0, 1.0), min_size=17, max_size=17).filter(lambda values: sum(values) > 0.1)


def mixed(values: list[float], what: str) -> np.ndarray:
    shares = np.array(values) / sum(values)
    each = [
        CAST.faces[name].positions if what == "face" else getattr(FIGURES.bodies[name], what) for name in CAST.faces
    ]
    return np.asarray(np.einsum("i,ijk->jk", shares, np.stack(each).astype(np.float64)))


def figure_of(faces: list[float], bodies: list[float]) -> np.ndarray:
    head = mixed(faces, "face")
    return np.concatenate([head, join_head(SPACE, mixed(bodies, "positions"), mixed(bodies, "edge"), head)])


def test_head_and_body_are_one_closed_mesh() -> None:
    triangles = np.concatenate([CAST.space.triangles, SPACE.triangles])
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()  # no rim is left
    assert set(SPACE.rim_rows) == set(SPACE.triangles[SPACE.triangles < SPACE.head_rows])
    assert len(np.unique(mesh.components(triangles, SPACE.first_of_skirt))) == 1


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


@given(weights, weights)
def test_joints_hang_with_the_body_and_the_head_turns_where_its_face_has_it(
    faces: list[float], bodies: list[float]
) -> None:
    head = mixed(faces, "face")
    edge = mixed(bodies, "edge")
    joints = mixed(bodies, "joints")
    hung = hang_joints(SPACE, joints, edge, head)
    others = np.arange(len(joints)) != SPACE.skeleton.places["head"]
    shift = (head[SPACE.rim_rows] - edge[: SPACE.rim]).mean(axis=0)
    np.testing.assert_allclose(hung[others], joints[others] + shift, atol=1e-12)
    inside = np.abs(head[SPACE.head_joint] - hung[SPACE.skeleton.places["head"]]).min(axis=0)
    assert (inside < 0.02).all()  # metres
