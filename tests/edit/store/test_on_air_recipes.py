"""What is on air becomes a recipe that names exactly what played then."""

import pytest
from msgspec.structs import replace

from omote.edit.protocol import messages as wire
from omote.edit.store.on_air_recipes import (
    OnAir,
    expression_recipe,
    face_recipe,
    neutral_recipe,
    read_on_air,
    recipe_on_air,
)
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe, Layer, Recipe
from omote.perform.performer import Performer
from omote.show.session import ShowSession
from omote.show.validation import Refusal
from tests import synthetic
from tests.authoring import EditHarness, net_of


def test_a_state_says_what_is_seen_and_what_is_coming(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_face("broad", seconds=10.0)
    performer.call_expression("smile", seconds=0.0)
    performer.set_channel("jawOpen", 0.5)
    performer.set_gaze(0.3, 0.0)
    show = ShowSession(cast, performer)
    show.tick(0.0)
    state = show.tick(1.0)
    on_air = read_on_air(state)
    assert (on_air.faces, on_air.expressions) == (state.faces, state.expressions)
    assert on_air.channels["jawOpen"] == 0.5
    looks = {name for name, weight in on_air.channels.items() if weight and name in synthetic.LOOKS}
    assert looks == {"eyeLookOutLeft", "eyeLookInRight"}, "the gaze is seen too"
    assert {"broad", "generic", "smile", "jawOpen"} <= on_air.names


def test_what_weighs_nothing_is_not_on_air() -> None:
    on_air = OnAir({"generic": 1.0, "long": 0.0}, {"smile": 0.0}, {"jawOpen": -0.1}, frozenset({"broad"}))
    assert on_air.names == {"generic", "jawOpen", "broad"}


def test_the_expression_on_air_is_a_layer_for_each_weight(cast: Cast) -> None:
    harness = EditHarness(cast)
    sources, net = harness.session.authored.sources, net_of(cast)
    on_air = OnAir({"generic": 1.0}, {"neutral": 0.3, "smile": 0.7}, {"jawOpen": 0.5, "browInnerUp": 0.0})
    recipe = recipe_on_air("expression", on_air, net, sources)
    assert recipe == replace(
        neutral_recipe(net), layers=(Layer("smile", "smile", 0.7), Layer("jawOpen", "jawOpen", 0.5))
    )
    assert expression_recipe([("neutral", 1.0)], net, sources) == neutral_recipe(net)


def test_the_face_on_air_is_a_mix(cast: Cast) -> None:
    harness = EditHarness(cast)
    on_air = OnAir({"generic": 0.25, "broad": 0.75, "long": 0.0})
    recipe = recipe_on_air("face", on_air, net_of(cast), harness.session.authored.sources)
    assert recipe == FaceRecipe({"generic": 0.25, "broad": 0.75})
    with pytest.raises(Refusal, match="from no face"):
        face_recipe({}, harness.session.authored.sources)


def test_own_things_on_air_are_taken_as_they_play_now(cast: Cast) -> None:
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.ask("ann", wire.CreateExpression, "Grin", {"smile": 1.0}, False)
    harness.ask("ann", wire.Save, 1, "")
    (own,) = harness.session.own()
    recipe = recipe_on_air(
        "expression", OnAir(expressions={"grin": 0.5}), net_of(cast), harness.session.authored.sources
    )
    assert isinstance(recipe, Recipe)
    assert recipe.layers == (Layer(own.source, "Grin", 0.5),)
