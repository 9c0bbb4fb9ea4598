"""The mix as faces answer it: the plain one without gains, else each face's own fields by the weight of both."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.model.cast import Cast
from omote.model.space.face_fit import fit
from omote.model.space.gain import Gain
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import apply_paper_map, compile_expression, displace_generic
from omote.perform.blending.answered_mix import answered_mix, answers_of
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.blending.expression_tables import ExpressionTables, TableRow
from omote.perform.frame import Frame

PLAIN = omote.load_cast()
LOUD = PLAIN.with_faces(replace(PLAIN.faces["dog"], gains=(Gain("brows", 2.0), Gain("mouth", 0.5), Gain("ears", 2.0))))
MIX = {"surprise": 0.6, "smile": 0.4}


def test_without_gains_the_mix_is_the_casts_own() -> None:
    mix = answered_mix(LOUD, {"kaori": 0.5, "old": 0.5}, MIX)
    assert mix.plain == MIX
    assert not mix.own
    assert not mix.ears.any()


def test_faces_with_gains_bring_their_own_fields_by_their_weight() -> None:
    mix = answered_mix(LOUD, {"dog": 0.25, "kaori": 0.75}, MIX)
    assert mix.plain == pytest.approx({"surprise": 0.45, "smile": 0.3})
    assert [weight for _, weight in mix.own] == pytest.approx([0.15, 0.1])
    assert mix.ears.any()
    alone = answered_mix(LOUD, {"dog": 1.0}, MIX)
    assert not alone.plain
    assert sum(weight for _, weight in alone.own) == pytest.approx(1.0)


def test_the_mix_of_answers_is_one_expression_located_once() -> None:
    """What tables and rows add up is what the expressions add up, as a table of them alone would."""
    mix = answered_mix(LOUD, {"dog": 0.25, "kaori": 0.75}, MIX)
    alone = {str(place): expression for place, (expression, _) in enumerate(mix.expressions())}
    weights = {str(place): weight for place, (_, weight) in enumerate(mix.expressions())}
    wanted = ExpressionTables(LOUD.space, alone).mix(weights)
    found = mix.compile()
    np.testing.assert_allclose(found.ratios, wanted.ratios, atol=1e-6)
    np.testing.assert_allclose(found.residual, wanted.residual, atol=1e-8)
    fitted = fit(LOUD.space, LOUD.faces["kaori"])
    worn = [apply_paper_map(LOUD.space, fitted, compiled) for compiled in (found, wanted)]
    np.testing.assert_allclose(worn[0], worn[1], atol=1e-6)


@pytest.mark.parametrize("cast", [LOUD, LOUD.under("paper")], ids=["smooth", "paper"])
def test_both_evaluators_agree_where_one_face_wears_one_expression(cast: Cast) -> None:
    frame = Frame({"dog": 1.0}, {"surprise": 1.0})
    exact = evaluate(cast, frame, "exact")
    bilinear = evaluate(cast, frame, "bilinear")
    assert np.abs(exact - bilinear).max() < 2e-6
    parts = evaluate_parts(cast, frame, "exact"), evaluate_parts(cast, frame, "bilinear")
    assert all(np.abs(parts[0][name] - parts[1][name]).max() < 2e-6 for name in parts[0])


@pytest.mark.parametrize("cast", [LOUD, LOUD.under("paper")], ids=["smooth", "paper"])
def test_evaluators_stay_near_each_other_along_a_mix(cast: Cast) -> None:
    """The approximation error of the paper stays millimetres: gains change what is worn, not how it mixes."""
    frame = Frame({"dog": 0.5, "kaori": 0.5}, MIX, {"jawOpen": 0.3})
    assert np.abs(evaluate(cast, frame, "exact") - evaluate(cast, frame, "bilinear")).max() < 0.012


def test_a_mixed_face_is_the_weighted_mean_of_what_each_answers() -> None:
    mixed = evaluate(LOUD, Frame({"dog": 0.5, "kaori": 0.5}, {"surprise": 1.0}))
    alone = [evaluate(LOUD, Frame({face: 1.0}, {"surprise": 1.0})) for face in ("dog", "kaori")]
    np.testing.assert_allclose(mixed, (alone[0] + alone[1]) / 2, atol=3e-5)  # correctives


def test_an_answer_is_computed_once_per_cast_face_and_name() -> None:
    first = answers_of(LOUD)("dog", "smile")
    assert answers_of(LOUD)("dog", "smile") is first
    assert answers_of(LOUD)("dog", "joy") is not first
    assert answers_of(PLAIN)("dog", "smile") is not first


def test_an_answer_is_the_models() -> None:
    space = LOUD.space
    wanted = answer_expression(LOUD.space, LOUD.faces["dog"].gains, LOUD.expressions["smile"])
    answer = answers_of(LOUD)("dog", "smile")
    np.testing.assert_array_equal(answer.expression.dh, wanted.dh)
    row = TableRow.of(space, wanted)
    np.testing.assert_array_equal(answer.row.field, row.field)
    np.testing.assert_array_equal(answer.row.residual, row.residual)
    moved = answer.source - space.points
    np.testing.assert_allclose(moved, displace_generic(space, compile_expression(space, wanted)), atol=1e-7)


def test_the_least_recently_used_answer_goes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.perform.blending.answered_mix.CAPACITY", 2)
    answers = answers_of(replace(LOUD))
    first, second = (answers("dog", name) for name in ("smile", "joy"))
    answers("dog", "fear")
    assert answers("dog", "joy") is second
    assert answers("dog", "smile") is not first
