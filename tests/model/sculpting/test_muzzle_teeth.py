"""Teeth that follow a muzzle's lips: as far behind them all along, symmetric, behind the skin, and no skin moves."""

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.model.sculpting.sculpt import Sculpt, sculpted
from omote.model.space.face_fit import fit
from omote.model.space.lid_lip_lines import chains
from omote.model.space.teeth_cage import cage_columns
from omote.model.transfer.gum_line import GUMS, find_gum_line, measure_gums
from omote.model.transfer.teeth_clearance import are_teeth_inside
from tools.baking.sculpts import read_sculpts

CAST = load_cast()
SPACE = CAST.space
ANIMALS = [sculpt for sculpt in read_sculpts() if sculpt.name in ("dog", "cat")]
each_animal = pytest.mark.parametrize("sculpt", ANIMALS, ids=lambda sculpt: sculpt.name)


@each_animal
def test_rows_bend_and_no_skin_moves(sculpt: Sculpt) -> None:
    bent, straight = (sculpted(SPACE, replace(sculpt, teeth_behind=behind)) for behind in (0.008, None))
    assert np.abs(bent.positions - straight.positions)[SPACE.on_sheet].max() < 1e-6
    for name, way in GUMS.items():
        columns = cage_columns(SPACE.parts[name].points, upper=way > 0.0)
        assert columns is not None
        moved = bent.parts[name] - straight.parts[name]
        assert np.abs(moved[:, 1]).max() < 1e-9, "seen from above alone"
        assert np.abs(moved[columns[[0, -1]]]).max() < 1e-9, "a row's ends stay"
        edges = bent.parts[name][columns[:, 2]]
        assert edges[::-1] * [-1.0, 1.0, 1.0] == pytest.approx(edges, abs=1e-6)


@pytest.mark.parametrize("name", ["dog", "cat"])
def test_front_teeth_stand_as_near_to_the_lips_as_peoples(name: str) -> None:
    """Those of dog and cat stood 21 and 22 mm behind: a muzzle grows more than what is in it."""
    face = CAST.faces[name]
    line = next(line for line in SPACE.lines if line.kind == "lips")
    lower = face.positions[chains(SPACE.points, SPACE.welded[line.loop])[1]]
    for row, way in GUMS.items():
        columns = cage_columns(SPACE.parts[row].points, upper=way > 0.0)
        assert columns is not None
        edges = face.parts[row][columns[:, 2]]
        assert 0.006 < lower[:, 2].max() - edges[:, 2].max() < 0.012
    gums = find_gum_line(SPACE)
    assert gums is not None
    assert measure_gums(gums, face.positions.astype(np.float64), face.parts)[1].min() > 0.0, "no crown in the lining"
    assert are_teeth_inside(SPACE, fit(SPACE, face))


def test_a_distance_that_no_mouth_has_is_refused() -> None:
    with pytest.raises(ValueError, match=r"stand 0.2 m behind its lip; expected 0.003 to 0.03 m"):
        replace(ANIMALS[0], teeth_behind=0.2)
