"""Ears that turn: rigid beyond their border, the way that is said, whatever way they hang; people's stay."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import omote
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.space.ears import ear_weights, find_ear, rotate_ears, rotations, turn_ears
from omote.model.space.gain import Gain
from omote.model.transfer.compound import compound
from tests.synthetic import space as egg

CAST = omote.load_cast()
ANIMALS = ("dog", "cat")
TURN = np.radians(30.0)


def tips(points: NDArray[np.floating]) -> NDArray[np.float64]:
    """The middles of the left and of the right ear, (2, 3) metres."""
    weights = ear_weights(CAST.space) >= 1.0
    return np.stack([points[rows].astype(np.float64).mean(axis=0) for rows in weights])


def turned(name: str, back: float = 0.0, up: float = 0.0, out: float = 0.0) -> NDArray[np.float32]:
    rest = CAST.faces[name].positions
    return turn_ears(CAST.space, rest, rest, np.array([[back, up, out]] * 2))


def test_each_ear_is_on_its_side_and_no_skin_ahead_belongs_to_any() -> None:
    left, right = ear_weights(CAST.space)
    assert (left >= 1.0).sum() > 100
    assert (left >= 1.0).sum() == (right >= 1.0).sum()
    assert (CAST.space.points[left > 0, 0] > 0.02).all()
    assert (CAST.space.points[right > 0, 0] < -0.02).all()
    assert (CAST.space.points[left > 0, 2] < 0.1).all()


@pytest.mark.parametrize("name", ANIMALS)
def test_ears_go_the_way_that_is_said(name: str) -> None:
    rest = tips(CAST.faces[name].positions)
    ways = {"back": (2, -1.0), "up": (1, 1.0), "out": (0, 1.0)}
    for way, (axis, sign) in ways.items():
        ear = find_ear(ear_weights(CAST.space)[0], CAST.faces[name].positions.astype(np.float64))
        assert ear is not None
        moved = sign * (tips(turned(name, **{way: TURN})) - rest)[0, axis]
        assert moved > 0.2 * TURN * np.linalg.norm(rest[0] - ear.root) * (1.0 - ear.direction[axis] ** 2)


@pytest.mark.parametrize("name", ANIMALS)
def test_an_ear_turns_as_one_and_leaves_the_rest_of_the_skin(name: str) -> None:
    rest = CAST.faces[name].positions.astype(np.float64)
    moved = turned(name, back=TURN, out=0.2).astype(np.float64)
    weights = ear_weights(CAST.space)
    np.testing.assert_array_equal(moved[(weights == 0).all(axis=0)], rest[(weights == 0).all(axis=0)])
    whole = np.flatnonzero(weights[0] >= 1.0)
    distances = [np.linalg.norm(points[whole, None] - points[whole], axis=2) for points in (rest, moved)]
    np.testing.assert_allclose(distances[1], distances[0], atol=1e-6)


@pytest.mark.parametrize("name", ANIMALS)
def test_turning_an_ear_folds_no_triangle(name: str) -> None:
    """Seen along their normals at rest, turned as far as their corners are in the mean."""
    rest = CAST.faces[name].positions
    turns = np.array([[1.4, 0.6, 0.2]] * 2)
    corners = CAST.space.sheet_triangles
    folded = []
    for moved in (rotate_ears(CAST.space, rest, rest, turns), turn_ears(CAST.space, rest, rest, turns)):
        normals, sizes = rest_normals(rest.astype(np.float64), corners)
        for weights, (_, axis) in rotations(CAST.space, rest, turns):
            normals = Rotation.from_rotvec(weights[corners].mean(axis=1)[:, None] * axis).apply(normals)
        folded.append(int((area_shares(moved.astype(np.float64), normals, sizes, corners) < 0).sum()))
    assert folded[0] > 0
    assert folded[1] == 0


def test_rotated_ears_rotate_back() -> None:
    rest = CAST.faces["dog"].positions
    turns = np.array([[0.4, -0.5, 0.4], [0.1, 0.2, 0.0]])
    there = rotate_ears(CAST.space, rest, rest, turns)
    np.testing.assert_allclose(rotate_ears(CAST.space, rest, there, -turns), rest, atol=1e-6)


def test_left_and_right_are_mirror_images() -> None:
    left, right = tips(turned("cat", back=0.3, up=-0.2, out=0.4))
    np.testing.assert_allclose(left, right * [-1.0, 1.0, 1.0], atol=1e-5)


def test_only_a_face_with_a_gain_for_ears_turns_them_and_by_as_much() -> None:
    fear = CAST.expressions["fear"]
    dog = replace(CAST.faces["dog"], gains=())
    still = compound(CAST.space, dog, fear)
    dogs = [replace(dog, gains=(Gain("ears", gain),)) for gain in (0.0, 0.5, 1.0)]
    away = [np.linalg.norm(tips(compound(CAST.space, one, fear)) - tips(still), axis=1) for one in dogs]
    assert not away[0].any()
    np.testing.assert_allclose(away[1], away[2] / 2, rtol=0.1)
    assert (away[2] > 0.01).all()


def test_a_head_without_ears_has_none_to_turn() -> None:
    rest = egg().points.astype(np.float32)
    assert find_ear(np.zeros(len(rest)), rest.astype(np.float64)) is None
    assert turn_ears(egg(), rest, rest, np.ones((2, 3))).shape == rest.shape


def test_ears_lie_in_few_turned_over_triangles() -> None:
    """A border that is too narrow would fold the skin around the root."""
    for name in ANIMALS:
        rest = CAST.faces[name].positions.astype(np.float64)
        moved = turned(name, back=TURN).astype(np.float64)
        sheet = CAST.space.skin_triangles
        a, b, c = sheet.T
        before, after = (np.cross(points[b] - points[a], points[c] - points[a]) for points in (rest, moved))
        assert ((before * after).sum(axis=1) < 0.0).sum() <= 12
