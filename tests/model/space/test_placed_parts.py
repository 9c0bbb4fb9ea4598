"""Parts of faces that bring none: they follow the face."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.geometry.proximity import winding_numbers
from omote.model.space.face import Face
from omote.model.space.face_fit import fit

CAST = load_cast()
MOUTH = ("teeth_upper", "teeth_lower", "tongue")


@pytest.mark.parametrize("name", ["dog", "cat", "man", "doll"])
def test_what_is_in_the_mouth_stays_inside_of_the_face(name: str) -> None:
    """A dog's teeth lay 20 mm before its muzzle: a similarity of the lips knows nothing of how long that is."""
    space = CAST.space
    placed = fit(space, Face("bare", CAST.faces[name].positions))
    skin = placed.positions.astype(np.float64)[space.location_triangles]
    for part in MOUTH:
        assert (winding_numbers(skin, placed.parts[part].astype(np.float64)[::2]) > 0.5).all(), part


def test_parts_turn_and_grow_with_their_face() -> None:
    space = CAST.space
    dog = CAST.faces["dog"].positions.astype(np.float64)
    still, moved = (fit(space, Face("bare", points)).parts for points in (dog, 1.25 * dog))
    for part in MOUTH:
        np.testing.assert_allclose(moved[part], 1.25 * still[part], atol=2e-5)
    generic = fit(space, Face("bare", space.points)).parts
    for name, bound in space.parts.items():
        np.testing.assert_allclose(generic[name], bound.points, atol=1e-6)
