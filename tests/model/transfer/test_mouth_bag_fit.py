"""The mouth bag stays inside the head: pushed behind the skin where it came out, left alone where it did not."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound, followed, on_generic
from omote.model.transfer.mouth_bag import bag_of
from omote.model.transfer.mouth_bag_fit import EXACT, depths, floor, kept, kept_inside, lack
from omote.model.transfer.paper_map import compile_expression


def built() -> omote.Cast:
    return omote.load_cast()


def lacking(space: ParameterSpace, face: omote.Face, positions: NDArray[np.float32]) -> float:
    bag = bag_of(space)
    assert bag is not None
    return float(lack(floor(space, face, bag), depths(space, bag, positions.astype(np.float64))).max())


@pytest.mark.parametrize("name", ["gaunt", "goblin", "old", "kaori"])
def test_an_open_mouth_keeps_its_bag_behind_the_cheeks(name: str) -> None:
    space, face = built().space, built().faces[name]
    compiled = compile_expression(space, built().expressions["mouth-open"])
    loose = followed(space, face, on_generic(space, compiled), compiled.residual)
    inside = kept_inside(space, face, loose)
    assert lacking(space, face, loose) > 10 * lacking(space, face, inside)
    assert np.array_equal(inside[space.on_sheet], loose[space.on_sheet])


def test_at_rest_nothing_moves() -> None:
    for face in built().faces.values():
        assert np.abs(kept_inside(built().space, face, face.positions) - face.positions).max() < EXACT, face.name


def test_the_generic_face_is_left_as_it_is_and_deep_enough_at_rest() -> None:
    space, generic = built().space, built().faces["generic"]
    bag = bag_of(space)
    assert bag is not None
    assert lack(kept(space, bag), depths(space, bag, space.points)).max() == 0
    positions = (generic.positions + 0.01 * ~space.on_sheet[:, None]).astype(np.float32)
    assert kept_inside(space, generic, positions) is positions


def test_the_bag_follows_the_weight_without_a_jump() -> None:
    space, face, jaw = built().space, built().faces["gaunt"], built().expressions["mouth-open"]
    bag = bag_of(space)
    assert bag is not None
    worn = [compound(space, face, jaw, weight)[bag.vertices] for weight in (0.799, 0.8, 0.801)]
    assert np.abs(worn[1] - worn[0]).max() < 5e-4
    assert np.abs(worn[2] - worn[1]).max() < 5e-4
