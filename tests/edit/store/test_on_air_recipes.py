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
from omote.perform.scene.scene import Scene
from omote.show.session import ShowSession
from omote.show.validation import Refusal
from tests import synthetic
from tests.authoring import EditHarness, net_of


def test_a_state_says_what_is_seen_and_what_is_coming(cast: Cast) -> None:
    scene = Scene.begun(cast)
    performer = scene["one"]
    performer.call_face("broad", seconds=10.0)
    performer.call_expression("smile", seconds=0.0)
    performer.set_channel("jawOpen", 0.5)
    performer.set_gaze(0.3, 0.0)
    show = ShowSession(cast, scene)
    show.tick(0.0)
    state = show.tick(1.0)
    on_air = read_on_air(state)
    assert (on_air.faces, on_air.expressions) == (state.characters["one"].faces, state.characters["one"].expressions)
    assert on_air.channels["jawOpen"] == 0.5
    looks = {name for name, weight in on_air.channels.items() if weight and name in synthetic.LOOKS}
    assert looks == {"eyeLookOutLeft", "eyeLookInRight"}, "the gaze is seen too"
    assert {"broad", "generic", "smile", "jawOpen"} <= on_air.names


def test_of_several_characters_one_is_meant_and_all_are_in_use(cast: Cast) -> None:
    scene = Scene.begun(cast)
    for name, face in (("two", "broad"), ("three", "long")):
        scene.add(name, face=face)
    scene["two"].set_channel("jawOpen", 0.5)
    scene.leave("one", seconds=0.0)
    scene.enter("three", seconds=0.0)
    state = ShowSession(cast, scene).tick(0.0)
    assert read_on_air(state).faces == {"long": 1.0}, "the first that is on the stage"
    assert (read_on_air(state, "two").faces, read_on_air(state, "two").channels) == ({"broad": 1.0}, {"jawOpen": 0.5})
    assert read_on_air(state, "gone").faces == {"long": 1.0}
    for character in ("", "two"):
        on_air = read_on_air(state, character)
        assert on_air.names == {"generic", "broad", "long", "neutral", "jawOpen"}
        assert on_air.homes == {"generic", "broad", "long"}


def test_what_weighs_nothing_is_not_on_air() -> None:
    on_air = OnAir({"generic": 1.0, "long": 0.0}, {"smile": 0.0}, {"jawOpen": -0.1}, frozenset({"broad"}))
    assert on_air.names == {"generic", "jawOpen", "broad"}


def test_the_expression_on_air_is_a_layer_for_each_weight(cast: Cast) -> None:
    harness = EditHarness(cast)
    sources = harness.session.authored.sources
    net = net_of(cast)
    on_air = OnAir({"generic": 1.0}, {"neutral": 0.3, "smile": 0.7}, {"jawOpen": 0.5, "browInnerUp": 0.0})
    recipe = recipe_on_air("expression", on_air, net, sources)
    assert recipe == replace(
        neutral_recipe(net), layers=(Layer("smile", "smile", 0.7), Layer("jawOpen", "jawOpen", 0.5))
    )
    assert expression_recipe([("neutral", 1.0)], net, sources) == neutral_recipe(net)


def test_what_regions_show_beyond_the_face_is_layers_on_the_parts_of_the_head_that_they_are(cast: Cast) -> None:
    harness = EditHarness(cast)
    sources = harness.session.authored.sources
    net = net_of(cast)
    regions = {"mouth": {"smile": 1.0}, "brows": {"jawOpen": 0.25, "neutral": 0.75}}
    on_air = OnAir({"generic": 1.0}, {"neutral": 0.75, "jawOpen": 0.25}, {}, regions=regions)  # type: ignore[arg-type]
    assert on_air.names == {"generic", "neutral", "jawOpen", "smile"}
    recipe = recipe_on_air("expression", on_air, net, sources)
    assert isinstance(recipe, Recipe)
    assert recipe.layers[0] == Layer("jawOpen", "jawOpen", 0.25), "the whole face"
    assert set(recipe.layers[1:]) == {
        Layer(name, name, weight, part)
        for part in ("mouth", "jaw", "cheeks")
        for name, weight in (("smile", 1.0), ("jawOpen", -0.25))
    }, "and the mouth beyond it; the brows show what the face does"


def test_what_is_called_in_a_region_is_coming(cast: Cast) -> None:
    show = ShowSession(cast)
    show.scene["one"].call_expression("smile", seconds=5.0, region="brows")
    on_air = read_on_air(show.tick(0.0))
    assert "smile" in on_air.names
    assert "smile" not in on_air.expressions


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
