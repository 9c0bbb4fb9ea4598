"""What extraction gives is an expression, with its uncertainty in millimetres and in words."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.extraction.extract import extract
from omote.model.extraction.extracted_expression import LEAST_SAID, ExtractedExpression, describe_uncertainty
from omote.model.transfer.compound import compound

CAST = omote.load_cast()
DOG = CAST.faces["dog"]
JAW = CAST.expressions["jawOpen"]
MOVED = compound(CAST.space, DOG, JAW) - DOG.positions


def test_a_sum_of_known_expressions_is_certain() -> None:
    taken = extract(CAST.space, DOG, MOVED, known=[JAW, CAST.expressions["mouthFunnel"]])
    assert isinstance(taken, omote.Expression)
    assert taken.uncertainty.shape == (CAST.space.vertex_count,)
    assert not taken.uncertainty.any()
    assert describe_uncertainty(CAST.space, taken) == ""


def test_what_the_face_does_not_say_is_told_in_words() -> None:
    taken = extract(CAST.space, DOG, MOVED)
    assert taken.uncertainty.max() > LEAST_SAID
    words = describe_uncertainty(CAST.space, taken)
    assert words.startswith("several expressions give this shape on this face; on others it may be some ")
    assert f"{1000 * taken.uncertainty.max():.1f} mm off at the " in words


def test_what_is_least_is_not_told() -> None:
    for worst, told in ((0.9 * LEAST_SAID, False), (1.1 * LEAST_SAID, True)):
        uncertainty = np.zeros(CAST.space.vertex_count)
        uncertainty[np.flatnonzero(~CAST.space.on_sheet)[0]] = worst
        taken = ExtractedExpression(JAW.dtheta, JAW.dh, JAW.ratio, JAW.residual, uncertainty=uncertainty)
        assert bool(describe_uncertainty(CAST.space, taken)) == told
