"""The field of a displacement of the sheet: measured where the paper's map puts it, nothing where nothing moves."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.extraction.sheet_field import measure_field
from omote.model.space.face_fit import generic_face
from omote.model.transfer.paper_map import compile_expression, displace_generic
from tests.synthetic import cast, space


@pytest.mark.parametrize("name", ["jawOpen", "smile", "browInnerUp"])
def test_what_the_papers_map_does_to_the_generic_face_is_measured_as_a_field_that_does_the_same(name: str) -> None:
    expression = cast().expressions[name]
    before = generic_face(space()).positions.astype(np.float64)
    moved = displace_generic(space(), compile_expression(space(), expression))
    field = measure_field(space(), before, moved)
    compiled = compile_expression(space(), field)
    landed = space().on_sheet & compiled.inside & compile_expression(space(), expression).inside
    assert landed.sum() > 0.9 * space().on_sheet.sum()  # the others leave the neck's rim
    assert np.abs(displace_generic(space(), compiled) - moved)[landed].max() < 1e-6


def test_a_face_at_rest_has_the_empty_field() -> None:
    field = measure_field(space(), space().points, np.zeros_like(space().points))
    assert not any(values.any() for values in (field.dtheta, field.dh, field.residual))
    assert (field.ratio == 1.0).all()
