"""Extraction says where, and by how much, others may wear what it took otherwise."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.extraction.extract import extract
from omote.model.extraction.extracted_expression import measure_uncertainty
from omote.model.transfer.compound import compound

CAST = omote.load_cast()


@pytest.mark.parametrize(("name", "unit"), [("dog", "jawOpen"), ("dog", "mouthSmileLeft")])
def test_what_is_off_on_others_is_told(name: str, unit: str) -> None:
    """The sheet is off by more than a millimetre; what is told is within a factor of two of that, and in its places."""
    face = CAST.faces[name]
    man = CAST.faces["man"]
    shape = CAST.expressions[unit]
    taken = extract(CAST.space, face, compound(CAST.space, face, shape) - face.positions)
    sheet = CAST.space.on_sheet
    off = np.linalg.norm(compound(CAST.space, man, taken) - compound(CAST.space, man, shape), axis=1)[sheet]
    told = taken.uncertainty[sheet]
    assert off.max() > 1e-3
    assert 0.5 * off.max() < told.max() < 2.0 * off.max()
    assert (told > 3e-4)[off > 3e-4].mean() > 0.75


@pytest.mark.parametrize(
    ("name", "unit"), [("generic", "eyeBlinkLeft"), ("man", "mouthSmileLeft"), ("dog", "jawForward")]
)
def test_where_nothing_is_repaired_nothing_is_uncertain(name: str, unit: str) -> None:
    taken = measure_uncertainty(CAST.space, CAST.faces[name], CAST.expressions[unit])
    assert taken[CAST.space.on_sheet].max() < 1e-3


def test_under_the_paper_s_map_nothing_is_repaired() -> None:
    paper = CAST.space.under("paper")
    shape = omote.Expression(
        CAST.expressions["jawOpen"].dtheta, CAST.expressions["jawOpen"].dh, CAST.expressions["jawOpen"].ratio,
        CAST.expressions["jawOpen"].residual, transfer="paper",
    )  # fmt: skip
    assert not measure_uncertainty(paper, CAST.faces["dog"], shape).any()
