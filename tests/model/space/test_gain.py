"""Gains: neutral ones change nothing, a face's answer is linear in the field, each region alone answers, extraction
undoes it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import omote
from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.gain import (
    FIELD_REGIONS,
    GAIN_REGIONS,
    MOST_GAIN,
    NEUTRAL_GAINS,
    Gain,
    GainRegion,
    answer,
    ask,
    field_gain,
    gain_of,
    mix_gains,
    override_gains,
    regional_gains,
    validate_gains,
)
from omote.model.space.head_regions import region_mask
from omote.model.transfer.compound import compound, compound_parts

CAST = omote.load_cast()
DOG = replace(CAST.faces["dog"], gains=())
values = st.floats(0.0, MOST_GAIN)
gains_of_a_face = st.lists(
    st.builds(Gain, st.sampled_from(GAIN_REGIONS), values, st.sampled_from([None, "smile", "angry"])),
    unique_by=lambda gain: (gain.region, gain.expression),
    max_size=8,
)


def face(*gains: Gain) -> Face:
    return replace(DOG, gains=gains)


def neutral() -> list[Gain]:
    return [Gain(region, NEUTRAL_GAINS[region]) for region in GAIN_REGIONS]


def test_neutral_gains_are_none_and_leave_every_array_alone() -> None:
    assert face(*neutral()).gains == ()
    for expression in CAST.expressions.values():
        answered = answer(CAST.space, neutral(), expression)
        for field in ("dtheta", "dh", "ratio", "residual", "eyes"):
            np.testing.assert_array_equal(getattr(answered, field), getattr(expression, field))
        assert not answered.ears.any()
        assert not answered.head.any()
    smile = replace(CAST.expressions["smile"], ears=np.zeros((2, 3)), head=np.zeros(3))
    assert answer(CAST.space, (), smile) is smile


def test_neutral_gains_leave_compounds_bit_for_bit() -> None:
    for name in ("surprise", "jawOpen", "browInnerUp"):
        still = replace(CAST.expressions[name], ears=np.zeros((2, 3)), head=np.zeros(3))
        wanted = compound(CAST.space, DOG, still)
        np.testing.assert_array_equal(compound(CAST.space, face(*neutral()), CAST.expressions[name]), wanted)


@pytest.mark.parametrize("region", FIELD_REGIONS)
def test_a_gain_scales_the_field_by_its_regions_mask_alone(region: GainRegion) -> None:
    mask = region_mask(CAST.space, region).skin  # type: ignore[arg-type]
    shout = CAST.expressions["shout"]
    answered = answer(CAST.space, [Gain(region, 1.5)], shout)
    np.testing.assert_allclose(answered.dh, (1.0 + 0.5 * mask) * shout.dh)
    np.testing.assert_allclose(answered.ratio - 1.0, (1.0 + 0.5 * mask) * (shout.ratio - 1.0), atol=1e-12)
    np.testing.assert_array_equal(answered.eyes, shout.eyes)
    assert answered.pupil == shout.pupil


def test_the_gains_of_all_regions_are_smooth_over_the_skin() -> None:
    gain = field_gain(CAST.space, [Gain(region, MOST_GAIN) for region in FIELD_REGIONS[::2]])
    assert gain is not None
    a, b = CAST.space.triangles[:, :2].T
    length = np.linalg.norm(CAST.space.points[a] - CAST.space.points[b], axis=1)
    assert (np.abs(gain.skin[a] - gain.skin[b]) <= 3 * length / 0.004).all()  # as steep as the masks, times 3


def test_brows_with_a_gain_rise_higher_and_the_mouth_does_not() -> None:
    plain, strong = (compound(CAST.space, one, CAST.expressions["surprise"]) for one in (DOG, face(Gain("brows", 2.0))))
    brows, mouth = (region_mask(CAST.space, region).skin > 0.7 for region in ("brows", "mouth"))
    risen = [(worn - DOG.positions)[brows, 1].mean() for worn in (plain, strong)]
    assert 1.6 * risen[0] < risen[1] < 2.4 * risen[0]
    assert np.abs(strong - plain)[mouth].max() < 2e-4


def test_parts_answer_where_they_lie() -> None:
    teeth = compound_parts(CAST.space, DOG, CAST.expressions["jawOpen"])["teeth_lower"]
    still = compound_parts(CAST.space, face(Gain("jaw", 0.0), Gain("mouth", 0.0)), CAST.expressions["jawOpen"])
    rest = DOG.parts["teeth_lower"]
    assert np.abs(still["teeth_lower"] - rest).mean() < 0.5 * np.abs(teeth - rest).mean()


def test_a_gain_of_one_expression_stands_before_that_of_all() -> None:
    gains = [Gain("mouth", 2.0), Gain("mouth", 0.5, "smile")]
    assert [gain_of(gains, "mouth", name) for name in ("smile", "angry", "", None)] == [0.5, 2.0, 2.0, 2.0]
    smile, angry = (answer(CAST.space, gains, CAST.expressions[name]) for name in ("smile", "angry"))
    assert np.abs(smile.dh).max() < np.abs(CAST.expressions["smile"].dh).max()
    assert np.abs(angry.dh).max() > np.abs(CAST.expressions["angry"].dh).max()


@settings(max_examples=20)
@given(gains_of_a_face, st.floats(-1.5, 1.5), st.floats(-1.5, 1.5))
def test_the_answer_to_a_sum_is_the_sum_of_the_answers(gains: list[Gain], one: float, other: float) -> None:
    gains = [gain for gain in gains if gain.expression is None]
    fields = [CAST.expressions[name] for name in ("browInnerUp", "mouthFrownLeft")]

    def added(first: Expression, second: Expression) -> Expression:
        return replace(first, dh=one * first.dh + other * second.dh, ears=one * first.ears + other * second.ears)

    whole = answer(CAST.space, gains, added(*fields))
    parts = added(*(answer(CAST.space, gains, field) for field in fields))
    np.testing.assert_allclose(whole.dh, parts.dh, atol=1e-12)
    np.testing.assert_allclose(whole.ears, parts.ears, atol=1e-12)


def test_what_is_extracted_from_a_face_with_gains_is_the_field_that_it_answered() -> None:
    """Where no gain is limited, which the next test is about."""
    strong = face(Gain("brows", 1.8), Gain("mouth", 0.6))
    field = replace(CAST.expressions["browOuterUpLeft"], ears=np.zeros((2, 3)), name="")
    worn = compound(CAST.space, strong, field)
    again = extract(CAST.space, strong, worn - DOG.positions)
    assert np.abs(compound(CAST.space, strong, again) - worn).max() < 1e-5
    np.testing.assert_allclose(again.dh, field.dh, atol=2e-4)


def test_what_is_extracted_where_a_gain_is_limited_looks_the_same_on_that_face() -> None:
    strong = face(Gain("brows", 1.8), Gain("mouth", 0.6))
    field = replace(CAST.expressions["browDownLeft"], ears=np.zeros((2, 3)), name="")
    worn = compound(CAST.space, strong, field)
    again = extract(CAST.space, strong, worn - DOG.positions)
    assert np.abs(compound(CAST.space, strong, again) - worn).max() < 1e-5
    assert np.abs(again.dh).max() <= np.abs(field.dh).max() + 1e-4


@settings(max_examples=20)
@given(gains_of_a_face)
def test_asking_is_the_way_back_of_answering(gains: list[Gain]) -> None:
    shout = CAST.expressions["shout"]
    gain = field_gain(CAST.space, gains, "shout")
    heard = np.ones(CAST.space.vertex_count, bool) if gain is None else gain.skin > 1e-3
    back = ask(CAST.space, gains, answer(CAST.space, gains, shout))
    np.testing.assert_allclose(back.dtheta[heard], shout.dtheta[heard], atol=1e-12)
    assert not back.dh[~heard].any()


@settings(max_examples=20)
@given(gains_of_a_face, gains_of_a_face, st.floats(0.0, 1.0))
def test_a_mix_of_faces_answers_by_the_mean_of_their_gains(one: list[Gain], two: list[Gain], share: float) -> None:
    mixed = mix_gains([(one, share), (two, 1.0 - share)])
    for region in GAIN_REGIONS:
        for name in (None, "smile", "angry", "fear"):
            wanted = share * gain_of(one, region, name) + (1.0 - share) * gain_of(two, region, name)
            assert gain_of(mixed, region, name) == pytest.approx(wanted, abs=1e-8)


def test_regions_come_from_their_face_and_own_gains_stand_before_all() -> None:
    base = (Gain("ears", 1.0), Gain("mouth", 2.0))
    other = (Gain("ears", 3.0), Gain("mouth", 3.0))
    assert regional_gains(base, {"ears": other, "skull": other}) == (Gain("mouth", 2.0), Gain("ears", 3.0))
    assert override_gains(base, (Gain("mouth", 1.0), Gain("ears", 2.0, "joy"))) == (
        Gain("ears", 1.0),
        Gain("ears", 2.0, "joy"),
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("tail", 1.0), "a gain is of region 'tail'; expected one of brows"),
        (("mouth", 4.5), "the gain of mouth is 4.5; expected a number from 0"),
        (("mouth", -0.1), "the gain of mouth is -0.1"),
        (("mouth", float("nan")), "the gain of mouth is nan"),
        (("mouth", "much"), "the gain of mouth is 'much'"),
        (("mouth", True), "the gain of mouth is True"),
        (("mouth", 1.0, ""), "the expression of the gain of mouth is named ''; expected"),
        (("mouth", 1.0, "x" * 81), "expected a text of 1 to 80"),
    ],
)
def test_a_gain_that_is_none_is_rejected(arguments: tuple[object, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Gain(*arguments)  # type: ignore[arg-type]


def test_two_gains_of_one_kind_are_rejected() -> None:
    with pytest.raises(ValueError, match="face 'dog' has two gains of mouth for smile"):
        face(Gain("mouth", 1.0, "smile"), Gain("mouth", 2.0, "smile"))
    with pytest.raises(TypeError, match="a gain of a face is a str"):
        validate_gains(["mouth"], "a face")  # type: ignore[list-item]
