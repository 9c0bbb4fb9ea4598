"""The size of a head: crown and chin are found whatever its size, and measure the built-in one as it is declared."""

import pytest

from omote.builtin import load_cast
from omote.model.space.head_size import HEAD_METRES, find_chin, find_crown, head_height
from omote.model.space.parameter_space import ParameterSpace
from tests import synthetic


def test_the_built_in_head_is_as_tall_as_declared() -> None:
    assert head_height(load_cast().space) == pytest.approx(HEAD_METRES, rel=1e-6)  # stored as float32


@pytest.mark.parametrize("size", [0.7, 2.0])
def test_crown_and_chin_are_the_same_points_of_a_head_of_any_size(size: float) -> None:
    space = synthetic.space()
    sized = ParameterSpace.build(size * space.points, space.triangles)
    assert (find_crown(sized), find_chin(sized)) == (find_crown(space), find_chin(space))
    assert head_height(sized) == pytest.approx(size * head_height(space))
    brought = ParameterSpace.build(HEAD_METRES / head_height(sized) * sized.points, sized.triangles)
    assert head_height(brought) == pytest.approx(HEAD_METRES)
