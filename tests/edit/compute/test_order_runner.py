"""Orders: baking, solving, other control nets, flattening; and every rejection."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import omote
from omote.edit.compute.order_runner import OrderRunner
from omote.edit.protocol.orders import Bake, Flat, Renet, Solve
from omote.model.controls.default_net import default_net
from omote.model.controls.tangents import tangents
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import FaceRecipe, Layer, Pull, Recipe, Vector
from omote.model.space.expression import Expression
from omote.model.transfer.compound import compound
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression, pack_face, unpack_expression, unpack_face

CAST = omote.load_cast()
RUNNER = OrderRunner(CAST)
NET = default_net(CAST.space)
REST: tuple[Vector, ...] = ((0.0, 0.0, 1.0),) * len(NET)
SMILE = Recipe(NET, REST, layers=(Layer("smile", "Smile"),), pulls=(Pull("mentalis", 0.5),))


def apart(one: Expression, other: Expression) -> float:
    names = ("dtheta", "dh", "ratio", "residual", "eyes")
    return max(float(np.abs(getattr(one, name) - getattr(other, name)).max()) for name in names)


def test_a_bake_is_the_recipes_expression_under_the_key_of_its_bytes() -> None:
    made = RUNNER.run(Bake(SMILE, {}))
    data = made.contents[made.key]
    assert content_key(data) == made.key
    assert apart(unpack_expression(data), compose_expression(CAST.space, SMILE, CAST.expressions)) == 0.0
    assert made.net is None
    assert RUNNER.run(Bake(SMILE, {})) == made


def test_a_net_that_is_asked_for_says_the_field_of_its_vectors() -> None:
    document = RUNNER.run(Bake(SMILE, {}, True)).net
    assert document == RUNNER.net_document(NET)
    assert document is not None
    corners = np.frombuffer(document.corners, "<u2").reshape(-1, 3)
    weights = np.frombuffer(document.weights, "<f4").reshape(-1, 3)
    vectors = np.random.default_rng(1).normal([0, 0, 1], 0.002, (len(NET), 3))
    rings = int(np.frombuffer(document.triangles, "<u2").max()) + 1 - len(NET)
    values = np.concatenate([vectors - [0, 0, 1], np.zeros((rings, 3))])
    field = np.einsum("vk,vkc->vc", weights, values[corners])
    recipe = Recipe(NET, tuple((float(a), float(b), float(c)) for a, b, c in vectors))
    expected = compose_expression(CAST.space, recipe, {})
    assert np.allclose(field, np.stack([expected.dtheta, expected.dh, expected.ratio - 1], 1), atol=1e-8)


def test_a_solve_puts_the_point_where_it_was_let_go() -> None:
    face = CAST.faces["dog"]
    row = NET[20]
    start = compound(CAST.space, face, compose_expression(CAST.space, SMILE, CAST.expressions))[row]
    target = (float(start[0]), float(start[1]) + 0.004, float(start[2]))
    made = RUNNER.run(Solve(SMILE, {}, "dog", (20,), (target,), REST))
    assert isinstance(made.recipe, Recipe)
    assert made.recipe.layers == SMILE.layers
    there = compound(CAST.space, face, unpack_expression(made.contents[made.key]))[row]
    assert np.linalg.norm(there - target) == pytest.approx(made.miss, abs=1e-6)
    assert made.miss < 5e-5


def test_another_net_and_a_flat_one_mean_the_same() -> None:
    moved = msgspec.structs.replace(SMILE, vectors=tuple((0.01, 0.001 * (i % 5), 1.0) for i in range(len(NET))))
    before = unpack_expression((whole := RUNNER.run(Bake(moved, {}))).contents[whole.key])
    for order in (Renet(moved, {}, NET[:-3]), Flat(moved, {})):
        made = RUNNER.run(order)
        assert apart(unpack_expression(made.contents[made.key]), before) < 1e-9
        again = RUNNER.run(Bake(made.recipe, made.contents))
        assert apart(unpack_expression(again.contents[again.key]), before) < 1e-9
    flat = RUNNER.run(Flat(moved, {})).recipe
    assert isinstance(flat, Recipe)
    assert (flat.vectors, flat.layers, flat.pulls) == (REST, (), ())


def test_flattening_keeps_muted_layers_as_they_were() -> None:
    muted = Layer("angry", "Angry", 0.7, "brows", True, True)
    order = Flat(msgspec.structs.replace(SMILE, layers=(*SMILE.layers, muted)), {})
    made = RUNNER.run(order)
    without = RUNNER.run(Flat(SMILE, {}))
    assert isinstance(made.recipe, Recipe)
    assert made.recipe.layers == (muted,)
    assert made.key == without.key, "what is seen holds nothing of it"


def test_own_contents_are_layers_and_faces() -> None:
    data = pack_expression(CAST.expressions["angry"])
    key = content_key(data)
    made = RUNNER.run(Bake(Recipe(NET, REST, layers=(Layer(f"#{key}", "Mine", 0.5),)), {key: data}))
    assert np.allclose(unpack_expression(made.contents[made.key]).dh, 0.5 * CAST.expressions["angry"].dh, atol=1e-15)
    face = pack_face(CAST.faces["baby"], CAST.looks["baby"])
    own = {content_key(face): face}
    mixed = RUNNER.run(Bake(FaceRecipe({f"#{content_key(face)}": 1.0}), own))
    positions = unpack_face(mixed.contents[mixed.key], "x")[0].positions
    assert np.allclose(positions, CAST.faces["baby"].positions, atol=1e-6)
    slopes = RUNNER.tangents_asset(f"#{content_key(face)}", own)
    there = np.frombuffer(slopes.tangents, "<f4").reshape(3, -1, 3)
    assert np.allclose(there, tangents(CAST.space, CAST.faces["baby"]), atol=1e-6)


@pytest.mark.parametrize(
    ("order", "sentence"),
    [
        (Bake(Recipe(NET, REST, layers=(Layer("nobody", ""),)), {}), "there is no expression 'nobody'"),
        (Bake(Recipe(NET, REST, ground="#00"), {}), "there is no expression '#00'"),
        (Bake(Recipe(NET, REST, ground="#00"), {"00": b"OMOC"}), "hash to their key"),
        (Bake(Recipe((1, 2, 10**7), REST[:3]), {}), "stands on vertex 10000000"),
        (Bake(Recipe(NET, REST[:-1]), {}), "vectors have shape"),
        (Bake(Recipe(NET, REST, eyes=(float("nan"), 0.0, 0.0, 0.0)), {}), "eyes"),
        (Bake(Recipe(NET, REST, pupil=float("nan")), {}), "pupil"),
        (Bake(FaceRecipe({"nobody": 1.0}), {}), "there is no face 'nobody'"),
        (Renet(SMILE, {}, (1, 1, 1)), "two control points stand on vertex 1"),
        (Solve(SMILE, {}, "nobody", (1,), ((0.0, 0.0, 0.0),), REST), "there is no face 'nobody'"),
        (Solve(SMILE, {}, "dog", (1,), ((0.0, 0.0, float("inf")),), REST), "expected finite metres"),
        (Solve(SMILE, {}, "dog", (1,), ((0.0, 0.0, 0.0),), REST[:3]), "vectors have shape"),
        (Solve(SMILE, {}, "dog", (-1,), ((0.0, 0.0, 0.0),), REST), "control point -1 does not exist"),
    ],
)
def test_orders_that_name_nothing_or_nonsense_are_refused(
    order: Bake | Renet | Solve, sentence: str
) -> None:  # fmt: skip
    with pytest.raises(ValueError, match=sentence):
        RUNNER.run(order)


def test_only_so_many_contents_stay_unpacked() -> None:
    runner = OrderRunner(CAST)
    for step in range(70):
        data = pack_expression(widened(step))
        key = content_key(data)
        runner.run(Flat(Recipe(NET, REST, ground=f"#{key}"), {key: data}))
    assert len(runner._expressions) == 64


def widened(step: int) -> Expression:
    """An expression that differs from others in its pupils only."""
    still = CAST.expressions["neutral"]
    return Expression(still.dtheta, still.dh, still.ratio, still.residual, pupil=0.01 * step)
