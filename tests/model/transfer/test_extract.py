"""Extraction: under the smooth map too, what is taken from a face is given back; parts and turns are read."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.extract import extract
from tests.synthetic import cast, space

UNITS = ("jawOpen", "eyeBlinkLeft", "mouthSmileRight", "mouthFunnel")


@pytest.mark.parametrize("unit", UNITS)
def test_extract_then_apply_on_another_face_gives_its_compound_back(unit: str) -> None:
    """Within 0.01 mm; a mouth bag pushed behind the skin within 0.1, the lids of a blink within 0.5."""
    built = omote.load_cast()
    for name in ("kaori", "baby", "doll"):
        face = built.faces[name]
        worn = compound(built.space, face, built.expressions[unit])
        error = np.abs(compound(built.space, face, extract(built.space, face, worn - face.positions)) - worn)
        assert np.quantile(error, 0.98) < 1e-5, name
        assert error[built.space.on_sheet].max() < (5e-4 if unit == "eyeBlinkLeft" else 1e-5), name
        assert error.max() < (5e-4 if unit == "eyeBlinkLeft" else 1e-4), name


def test_a_displacement_that_asks_for_no_unfolding_comes_back() -> None:
    built = omote.load_cast()
    for name in ("kaori", "baby", "doll", "alien"):
        face = built.faces[name]
        lift = np.zeros((built.space.vertex_count, 3))
        chin = face.positions[built.space.points[:, 2].argmax()] - [0.0, 0.05, 0.0]  # far from eyeballs
        lift[:, 1] = 0.004 * np.exp(-(((face.positions - chin) / 0.02) ** 2).sum(axis=1))
        error = np.abs(compound(built.space, face, extract(built.space, face, lift)) - face.positions - lift)
        assert error[built.space.on_sheet].max() < 1e-5, name


def test_what_is_taken_from_the_generic_face_is_the_same_field_under_both_rules() -> None:
    face, jaw = cast().faces["generic"], cast().expressions["jawOpen"]
    moved = compound(space(), face, jaw) - face.positions
    smooth, paper = extract(space(), face, moved), extract(space().under("paper"), face, moved)
    assert smooth.dtheta == pytest.approx(paper.dtheta, abs=1e-9)
    assert smooth.dh == pytest.approx(paper.dh, abs=1e-9)
    assert smooth.ratio == pytest.approx(paper.ratio, abs=1e-9)
    assert (smooth.transfer, paper.transfer) == ("smooth", "paper")
