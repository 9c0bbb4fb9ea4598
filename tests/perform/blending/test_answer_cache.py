"""Answers: computed once per cast, face and name; bounded; what the model would compute."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import omote
from omote.model.space.gain import Gain
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.perform.blending.answer_cache import answers_of, build_answers
from omote.perform.blending.expression_tables import TableRow

PLAIN = omote.load_cast()
LOUD = PLAIN.with_faces(replace(PLAIN.faces["dog"], gains=(Gain("brows", 2.0), Gain("mouth", 0.5))))


def test_an_answer_is_computed_once_per_cast_face_and_name() -> None:
    first = answers_of(LOUD)("dog", "smile")
    assert answers_of(LOUD)("dog", "smile") is first
    assert answers_of(LOUD)("dog", "joy") is not first
    assert answers_of(PLAIN)("dog", "smile") is not first


def test_an_answer_is_the_models() -> None:
    space, wanted = LOUD.space, answer_expression(LOUD.space, LOUD.faces["dog"].gains, LOUD.expressions["smile"])
    found = answers_of(LOUD)("dog", "smile")
    np.testing.assert_array_equal(found.expression.dh, wanted.dh)
    row = TableRow.of(space, wanted)
    np.testing.assert_array_equal(found.row.field, row.field)
    np.testing.assert_array_equal(found.row.residual, row.residual)
    moved = found.source - space.points
    np.testing.assert_allclose(moved, displace_generic(space, compile_expression(space, wanted)), atol=1e-7)


def test_the_least_recently_used_goes_first() -> None:
    answers = build_answers(LOUD, 2)
    first, second = (answers("dog", name) for name in ("smile", "joy"))
    answers("dog", "fear")
    assert answers("dog", "joy") is second
    assert answers("dog", "smile") is not first
