"""How far the lids of a scan are apart is what somebody ahead of the eye sees."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.fitting.lids.lid_motion import lid_pairs
from omote.model.fitting.lids.scan_slits import Slit, find_slit
from omote.model.space.face import Face
from omote.model.space.face_fit import generic_face

CAST = omote.load_cast()
SPACE = CAST.space
GENERIC = generic_face(SPACE)
REST = GENERIC.positions.astype(np.float64)
LEFT = lid_pairs(SPACE)[0].line
LONG = slice(4, -4)  # where rungs are no shorter than lids are thick


def moves_of(face: Face, name: str, weight: float = 1.0) -> NDArray[np.float64]:
    """What a unit of the cast does to a face."""
    worn = omote.compound(SPACE, face, CAST.expressions[name])
    return weight * (worn.astype(np.float64) - face.positions)


def slit_of(face: Face) -> Slit:
    """The left opening of a face's own skin."""
    skin = face.positions.astype(np.float64)
    return find_slit(LEFT, skin, skin, SPACE.triangles)


@pytest.mark.parametrize("face", ["kaori", "old", "baby", "dog"])
def test_a_blink_shuts_and_the_upper_lid_does_most_of_it(face: str) -> None:
    worn = CAST.faces[face]
    upper = slit_of(worn).shut_by(worn.positions.astype(np.float64), moves_of(worn, "eyeBlinkLeft"))
    assert upper is not None
    assert 0.5 < upper[LONG].min() <= upper[LONG].max() <= 1.0


@pytest.mark.parametrize(
    ("name", "weight"), [("eyeSquintLeft", 1.0), ("eyeWideLeft", 1.0), ("eyeBlinkLeft", 0.5), ("eyeBlinkRight", 1.0)]
)
def test_what_leaves_lids_apart_shuts_none(name: str, weight: float) -> None:
    slit = slit_of(CAST.faces["old"])
    assert slit.known
    assert (
        slit.shut_by(CAST.faces["old"].positions.astype(np.float64), moves_of(CAST.faces["old"], name, weight)) is None
    )


def test_eyes_that_are_shut_at_rest_show_no_opening() -> None:
    shut = REST + moves_of(GENERIC, "eyeBlinkLeft")
    assert not find_slit(LEFT, REST, shut, SPACE.triangles).known
