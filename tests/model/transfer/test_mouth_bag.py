"""The mouth bag: found behind the lips, whole, with its neighbours."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.transfer.mouth_bag import find_mouth_bag
from tests.synthetic import space


def test_the_bag_is_the_inner_skin_behind_the_lips() -> None:
    built = omote.load_cast().space
    bag = find_mouth_bag(built)
    assert bag is not None
    assert not built.on_sheet[bag.vertices].any()
    points = built.points[bag.vertices]
    teeth = built.parts["teeth_lower"].points
    for axis in range(3):
        assert points[:, axis].min() < teeth[:, axis].mean() < points[:, axis].max()
    assert not any((points[:, 1] > part.points[:, 1].mean()).any() for part in built.parts.values() if part.eye)


def test_every_copy_of_a_bag_vertex_has_its_row() -> None:
    built = omote.load_cast().space
    bag = find_mouth_bag(built)
    assert bag is not None
    known = bag.rows >= 0
    assert np.array_equal(bag.vertices[bag.rows[known]], built.welded[built.inner.vertices[known]])
    assert np.array_equal(np.unique(bag.rows[known]), np.arange(len(bag.vertices)))


def test_neighbours_are_mutual_and_joined_to_the_skin() -> None:
    bag = find_mouth_bag(omote.load_cast().space)
    assert bag is not None
    assert all(row in bag.neighbours[other] for row, others in enumerate(bag.neighbours) for other in others)
    assert np.isfinite(bag.distance).all()
    assert (bag.distance > 0).all()


def test_a_space_without_lips_has_none() -> None:
    assert find_mouth_bag(type(space()).build(space().points, space().triangles)) is None
