"""What moves one eye leaves the lining of the other's socket at rest."""

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.socket_skin import find_socket_lining
from tests.synthetic import space as synthetic_space
from tools.baking.expressions import PERFORMED, unit_weights
from tools.baking.heads.moves import Move, compose
from tools.baking.heads.one_eye import SIDES, leave_other_socket

CAST = omote.load_cast()
ONE_EYE = [name for name in CAST.expressions if name.startswith("eye") and name.endswith(tuple(SIDES))]


def lining(side: float) -> np.ndarray:
    """The skin of a socket's lining, seams included, by the sign of its x."""
    found = find_socket_lining(CAST.space)
    assert found is not None
    return np.isin(CAST.space.welded, found.vertices) & (side * CAST.space.points[:, 0] > 0.0)


def other(unit: str) -> np.ndarray:
    return lining(next(-side for end, side in SIDES.items() if unit.endswith(end)))


@pytest.mark.parametrize("unit", ONE_EYE)
@pytest.mark.parametrize("name", ["generic", "kaori", "man", "dog"])
def test_the_other_socket_of_a_face_is_at_rest(name: str, unit: str) -> None:
    face = CAST.faces[name]
    worn = compound(CAST.space, face, CAST.expressions[unit])
    assert np.linalg.norm(worn - face.positions, axis=1)[other(unit)].max() < 1e-4


def test_only_the_other_socket_is_put_at_rest(moves: dict[str, Move]) -> None:
    left = leave_other_socket(CAST.space, moves)
    assert list(left) == list(moves)
    for unit in moves.keys() - PERFORMED.keys():
        expected = moves[unit].skin.copy()
        if unit in ONE_EYE:
            expected[other(unit)] = 0.0
        np.testing.assert_array_equal(left[unit].skin, expected)
    for name, recipe in PERFORMED.items():
        np.testing.assert_allclose(left[name].skin, compose(left, unit_weights(recipe)).skin, atol=1e-12)


def test_a_head_without_lids_keeps_its_moves() -> None:
    space = synthetic_space()
    move = Move(np.ones_like(space.points), {})
    assert leave_other_socket(space, {"eyeBlinkLeft": move})["eyeBlinkLeft"] is move
