"""Gains give way where the generic face would fold, and only there; whoever wears the answer then folds nowhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import omote
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import generic_face
from omote.model.space.gain import FIELD_REGIONS, Gain, answer, field_gain
from omote.model.transfer.compound import compound
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.gain_limit import answer_expression, find_harm, limit_gain
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.smooth_map import prepare_smooth_map

CAST = omote.load_cast()
SPACE = CAST.space
READY = prepare_smooth_map(SPACE, generic_face(SPACE))
WORN = ("angry", "disgust", "joy", "eyeBlinkLeft", "mouthFunnel", "mouthPressLeft", "browDownRight")
some_gains = st.lists(
    st.builds(Gain, st.sampled_from(FIELD_REGIONS), st.floats(0.0, 3.0)), unique_by=lambda gain: gain.region, min_size=1
)


def wear(expression: Expression) -> NDArray[np.float64]:
    return READY.generic + displace_generic(SPACE, compile_expression(SPACE, expression))


def harm(gains: list[Gain], name: str, limited: bool) -> int:
    expression = CAST.expressions[name]
    answered = (answer_expression if limited else answer)(SPACE, gains, expression)
    return int(find_harm(READY, wear(expression), wear(answered)).sum())


@settings(max_examples=15)
@given(some_gains, st.sampled_from(WORN))
def test_an_answer_harms_the_generic_face_nowhere(gains: list[Gain], name: str) -> None:
    assert harm(gains, name, limited=True) == 0


@pytest.mark.parametrize(("name", "gain"), [("disgust", Gain("nose", 3.0)), ("eyeBlinkLeft", Gain("eyes", 1.5))])
def test_what_is_limited_would_have_harmed(name: str, gain: Gain) -> None:
    assert harm([gain], name, limited=False) > 0


@settings(max_examples=15)
@given(some_gains, st.sampled_from(WORN))
def test_a_limited_gain_lies_between_one_and_the_gain_and_gives_way_only_where_it_must(
    gains: list[Gain], name: str
) -> None:
    gain = field_gain(SPACE, gains, name)
    if gain is None:
        return
    limited = limit_gain(SPACE, gain, CAST.expressions[name])
    if harm(gains, name, limited=False) == 0:
        assert limited is gain
    for given_, kept in ((gain.skin, limited.skin), *((gain.parts[part], limited.parts[part]) for part in SPACE.parts)):
        assert (kept >= np.minimum(given_, 1.0) - 1e-12).all()
        assert (kept <= np.maximum(given_, 1.0) + 1e-12).all()


def test_far_from_where_a_gain_harms_it_stays_as_it_is() -> None:
    gain = field_gain(SPACE, [Gain("nose", 3.0), Gain("jaw", 2.0)], "disgust")
    assert gain is not None
    limited = limit_gain(SPACE, gain, CAST.expressions["disgust"])
    chin = SPACE.points[:, 1] < -0.09
    assert (gain.skin[chin] > 1.1).any()
    np.testing.assert_array_equal(limited.skin[chin], gain.skin[chin])
    assert (limited.skin < gain.skin - 0.1).any()


def test_the_papers_map_repairs_nothing_so_gains_stay() -> None:
    paper = CAST.under("paper")
    gains = [Gain("nose", 3.0)]
    got, wanted = (make(paper.space, gains, paper.expressions["disgust"]) for make in (answer_expression, answer))
    np.testing.assert_array_equal(got.dh, wanted.dh)


def folds_of(face: Face, expression: Expression) -> int:
    """Triangles turned over on a face, and not on the generic face that wears the expression without gains."""
    geometry = prepare_smooth_map(SPACE, face).geometry
    still = replace(expression, ears=np.zeros((2, 3)))
    return int(find_folds(geometry, compound(SPACE, face, still).astype(np.float64), wear(still)).sum())


@pytest.mark.parametrize("name", ["dog", "cat"])
def test_animals_fold_in_no_emotion(name: str) -> None:
    performed = [each for each, title in CAST.titles.items() if title.kind == "performed"]
    assert {each: folds_of(CAST.faces[name], CAST.expressions[each]) for each in performed} == dict.fromkeys(
        performed, 0
    )


@pytest.mark.parametrize("seed", range(3))
def test_a_face_that_nobody_tuned_folds_nowhere(seed: int) -> None:
    draw = np.random.default_rng(seed)
    faces = draw.choice(list(CAST.faces), 3, replace=False)
    shape = sum(
        share * CAST.faces[face].positions for face, share in zip(faces, draw.dirichlet(np.ones(3)), strict=True)
    )
    gains = [Gain(region, float(draw.uniform(0.0, 2.0))) for region in FIELD_REGIONS]
    worn = [*WORN, "asleep", "mouth-corner-puller"]
    face = Face("drawn", np.asarray(shape), gains=tuple(gains))
    assert {name: folds_of(face, CAST.expressions[name]) for name in worn} == dict.fromkeys(worn, 0)
