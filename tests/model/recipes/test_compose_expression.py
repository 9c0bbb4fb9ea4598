"""What recipes add up to: sums, masks, mirror images, muscles; the same under another net."""

from __future__ import annotations

from functools import cache

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import omote
from omote.model.controls.default_net import default_net
from omote.model.controls.face_muscles import muscles
from omote.model.controls.mirror import mirror_expression
from omote.model.controls.net_field import NetField, build_net_field
from omote.model.recipes.compose_expression import add_field, change_net, compose_expression, find_muscle_field
from omote.model.recipes.recipe import Layer, Pull, Recipe, Vector
from omote.model.space.expression import Expression
from omote.model.space.head_regions import REGIONS
from omote.model.space.parameter_space import ParameterSpace

CAST = omote.load_cast()


def space() -> ParameterSpace:
    return CAST.space


@cache
def _woven() -> NetField:
    return build_net_field(space(), default_net(space()))


def recipe(*layers: Layer, seed: int | None = None, pulls: tuple[Pull, ...] = ()) -> Recipe:
    net = default_net(space())
    vectors: tuple[Vector, ...] = ((0.0, 0.0, 1.0),) * len(net)
    if seed is not None:
        moved = np.random.default_rng(seed).normal([0, 0, 1], [0.02, 0.002, 0.02], (len(net), 3))
        vectors = tuple((float(a), float(b), float(c)) for a, b, c in moved)
    return Recipe(net, vectors, None, layers, pulls)


def baked(made: Recipe, **own: Expression) -> Expression:
    net_field = _woven() if made.net == default_net(space()) else None
    return compose_expression(space(), made, {**CAST.expressions, **own}, net_field)


def numbers(expression: Expression) -> NDArray[np.float64]:
    """All of an expression as one row."""
    parts = [expression.parts.get(name, np.zeros_like(part.points)) for name, part in space().parts.items()]
    fields = (expression.dtheta, expression.dh, expression.ratio - 1.0, expression.residual, expression.eyes, *parts)
    return np.concatenate([*(field.ravel() for field in fields), [expression.pupil, *expression.complexion]])


def test_nothing_is_the_expression_at_rest() -> None:
    assert not numbers(baked(recipe())).any()


def test_one_layer_is_that_expression() -> None:
    for name in ("smile", "wink", "tongueOut", "pupils-wide"):
        found = numbers(baked(recipe(Layer(name, name))))
        assert np.allclose(found, numbers(CAST.expressions[name]), atol=1e-15)


@given(st.floats(-1, 1), st.floats(-1, 1))
def test_layers_add(a: float, b: float) -> None:
    both = numbers(baked(recipe(Layer("smile", "", a), Layer("surprise", "", b))))
    one = numbers(CAST.expressions["smile"])
    other = numbers(CAST.expressions["surprise"])
    assert np.allclose(both, a * one + b * other, atol=1e-14)


@given(st.lists(st.tuples(st.sampled_from(["smile", "wink", "pupils-wide"]), st.booleans()), max_size=5))
def test_muted_layers_add_nothing(layers: list[tuple[str, bool]]) -> None:
    kept = [Layer(name, "", muted=muted) for name, muted in layers]
    audible = [layer for layer in kept if not layer.muted]
    assert np.array_equal(numbers(baked(recipe(*kept))), numbers(baked(recipe(*audible))))


def test_a_muted_layer_of_an_expression_that_is_gone_is_still_rejected() -> None:
    with pytest.raises(ValueError, match="choose another layer"):
        baked(recipe(Layer("#gone", "Gone", muted=True)))


def test_all_regions_of_one_expression_are_that_expression() -> None:
    for name in ("shout", "wink", "pupils-wide"):
        layers = [Layer(name, name, region=region) for region in REGIONS]
        assert np.allclose(numbers(baked(recipe(*layers))), numbers(CAST.expressions[name]), atol=1e-12)


def test_the_brow_of_one_and_the_mouth_of_another() -> None:
    both = baked(recipe(Layer("surprise", "", region="brows"), Layer("smile", "", region="mouth")))
    smile = CAST.expressions["smile"]
    surprise = CAST.expressions["surprise"]
    lip = space().lines[-1].loop
    brow = list(default_net(space()))[30:34]
    assert np.abs(both.dh - smile.dh)[lip].max() < 0.3 * np.abs(smile.dh[lip]).max()
    assert both.dh[brow].max() > 0.5 * surprise.dh[brow].max()


def test_a_mirrored_layer_is_the_mirror_image() -> None:
    found = baked(recipe(Layer("wink", "", mirrored=True)))
    assert np.allclose(numbers(found), numbers(mirror_expression(space(), CAST.expressions["wink"])), atol=1e-15)


def test_a_muscle_pulls_linearly_and_eyes_turn() -> None:
    for name in muscles(space()):
        half = baked(recipe(pulls=(Pull(name, 0.5),)))
        assert np.allclose(
            np.stack([half.dtheta, half.dh, half.ratio - 1], 1), 0.5 * find_muscle_field(space(), name), atol=1e-15
        )
    turned = msgspec.structs.replace(recipe(), eyes=(0.1, 0.2, -0.1, 0.3), pupil=0.5)
    assert baked(turned).eyes.ravel().tolist() == [0.1, 0.2, -0.1, 0.3]
    assert baked(turned).pupil == 0.5


def test_blood_tears_and_sweat_add_as_layers_do_and_a_region_brings_its_own() -> None:
    own = (0.25, 0.0, 0.0, 0.0, 0.0, 0.5, 0.25)
    whole = msgspec.structs.replace(recipe(), layers=(Layer("cry", "Cry", 0.5),), complexion=own)
    cry = np.array(CAST.expressions["cry"].complexion)
    assert baked(whole).complexion == pytest.approx(0.5 * cry + own)
    eyes = msgspec.structs.replace(recipe(), layers=(Layer("cry", "Cry", 1.0, "eyes"),))
    assert baked(eyes).complexion == pytest.approx(cry * [0, 0, 0, 1, 0, 1, 0])
    skull = msgspec.structs.replace(recipe(), layers=(Layer("fear", "Fear", 1.0, "skull"),))
    fear = CAST.expressions["fear"].complexion
    assert baked(skull).complexion == pytest.approx((0, 0, 0, 0, fear.whole, 0, fear.sweat))
    muted = msgspec.structs.replace(recipe(), layers=(Layer("cry", "Cry", 1.0, muted=True),))
    assert not any(baked(muted).complexion)


@given(st.integers(0, 1000), st.integers(1, 6), st.booleans())
@settings(max_examples=20)
def test_another_net_changes_nothing_that_is_seen(seed: int, fewer: int, grounded: bool) -> None:
    before = recipe(Layer("smile", ""), seed=seed)
    own = {"#ground": CAST.expressions["angry"]} if grounded else {}
    before = msgspec.structs.replace(before, ground="#ground" if grounded else None)
    spare = int(space().sheet_triangles[seed % 900, 0])
    net = [row for row in before.net[fewer:] if row != spare] + [spare]
    made, net_field, ground = change_net(space(), before, own.get("#ground"), net)
    assert made.net == tuple(net) == net_field.rows
    assert ground is not None
    after = msgspec.structs.replace(made, ground="#new")
    apart = numbers(baked(before, **own)) - numbers(baked(after, **{"#new": ground}))
    assert np.abs(apart).max() < 1e-9


def test_the_same_net_needs_no_ground() -> None:
    made, _, ground = change_net(space(), recipe(seed=3), None, default_net(space()))
    assert ground is None
    assert np.allclose(made.vectors, recipe(seed=3).vectors, atol=1e-12)


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        (recipe(Layer("nobody", "")), "names 'nobody'; there is no such expression of the cast"),
        (recipe(Layer("#0123", "")), "names '#0123'; there is no such own content"),
        (recipe(Layer("smile", "Smile", 5.0)), "weight of layer 'Smile' is 5.0; expected a number from -4 to 4"),
        (recipe(Layer("smile", "Smile", float("nan"))), "weight of layer 'Smile' is nan"),
        (recipe(Layer("smile", "", region="tail")), "there is no region 'tail'"),
        (recipe(pulls=(Pull("biceps", 1.0),)), "there is no muscle 'biceps'"),
        (recipe(pulls=(Pull("zygomaticus_left", 9.0),)), "contraction of muscle 'zygomaticus_left' is 9.0"),
        (msgspec.structs.replace(recipe(), vectors=((0.0, 0.0, 1.0),)), "vectors have shape"),
        (msgspec.structs.replace(recipe(), eyes=(float("inf"), 0.0, 0.0, 0.0)), "eyes"),
    ],
)
def test_recipes_that_say_nothing_sensible_are_refused(wrong: Recipe, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        baked(wrong)


def test_a_radius_must_stay_positive() -> None:
    field = np.zeros((space().vertex_count, 3))
    field[default_net(space())[0], 2] = -1.0
    with pytest.raises(ValueError, match="give layers and muscles less weight"):
        add_field(space(), None, field)
