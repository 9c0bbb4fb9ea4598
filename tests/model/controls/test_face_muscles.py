"""The face's muscles: found by feature, symmetric, working on every face."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.controls.face_muscles import muscle_fields, muscles
from omote.model.controls.mirror import mirror_rows
from omote.model.recipes.compose_expression import add_field
from omote.model.space.face_fit import generic_face
from omote.model.space.lid_lip_lines import chains
from omote.model.transfer.compound import compound
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.smooth_map import prepare_smooth_map
from tests import synthetic

CAST = omote.load_cast()


def test_ten_muscles_and_more_in_pairs_that_mirror_each_other() -> None:
    found = muscles(CAST.space)
    fields = muscle_fields(CAST.space)
    assert len(found) >= 10
    rows = mirror_rows(CAST.space)
    for name, muscle in found.items():
        if name.endswith("_left"):
            other = name.replace("_left", "_right")
            assert np.abs(fields[name][rows] * [-1, 1, 1] - fields[other]).max() < 1e-3
            assert [int(rows[row]) for row in muscle.rows] == list(found[other].rows)
    assert {muscle.kind for muscle in found.values()} == {"linear", "sheet", "sphincter"}
    assert len({muscle.label for muscle in found.values()}) == len(found)


def test_lines_lie_on_the_sheet_and_every_muscle_moves_something() -> None:
    for name, muscle in muscles(CAST.space).items():
        assert CAST.space.on_sheet[list(muscle.rows)].all()
        assert len(muscle.rows) > 3
        assert 0.003 < np.abs(muscle_fields(CAST.space)[name][:, 1]).max() < 0.02 or name == "orbicularis_oris"


@pytest.mark.parametrize("name", sorted(CAST.faces))
def test_no_muscle_folds_a_face_and_a_smile_goes_up_and_out(name: str) -> None:
    face = CAST.faces[name]
    for muscle in muscles(CAST.space):
        worn = add_field(CAST.space, None, muscle_fields(CAST.space)[muscle])
        positions = compound(CAST.space, face, worn).astype(np.float64)
        moved = generic_face(CAST.space).positions + displace_generic(CAST.space, compile_expression(CAST.space, worn))
        assert find_folds(prepare_smooth_map(CAST.space, face).geometry, positions, moved).sum() == 0, muscle
        if muscle == "zygomaticus_left":
            lips = next(line for line in CAST.space.lines if line.kind == "lips")
            corner = chains(CAST.space.points, lips.loop)[0][-1]
            way = positions[corner] - face.positions[corner]
            assert way[0] > 0.002
            assert way[1] > 0.003


def test_a_head_without_lids_and_lips_has_no_muscles() -> None:
    assert not muscles(synthetic.space())
    assert not muscle_fields(synthetic.space())
