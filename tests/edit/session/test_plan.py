"""What requests are about: checked recipes, orders that carry everything, and what the file must keep for them."""

import pytest

from omote.edit.protocol import messages as wire
from omote.edit.session.plan import Authored
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe, Layer, Recipe
from omote.show.validation import Refusal
from tests.authoring import EditHarness, net_of


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """Ann at an unsaved expression."""
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.ask("ann", wire.CreateExpression, "Grin", {"smile": 1.0}, False)
    return harness


def authored(harness: EditHarness) -> Authored:
    """What the session's requests are about."""
    return harness.session.authored


def test_orders_carry_the_contents_that_their_recipe_names(harness: EditHarness) -> None:
    source = harness.ask("ann", wire.Flatten, 1).recipe.ground
    net = net_of(harness.cast)
    recipe = Recipe(net, ((0.0, 0.0, 1.0),) * len(net), layers=(Layer(source, "Grin"), Layer("smile", "Smile")))
    order = authored(harness).bake(recipe, with_net=True)
    assert {"#" + key for key in order.contents} == {source}
    assert order.with_net
    assert not authored(harness).bake(FaceRecipe({"broad": 1.0}), with_net=True).with_net, "faces have no net"


def test_a_draft_may_be_laid_under_another_before_it_is_saved_and_is_kept_then(harness: EditHarness) -> None:
    content = harness.ask("ann", wire.OpenItem, 1).content
    assert content.removeprefix("#") not in harness.tables.contents
    state = harness.ask("ann", wire.CreateExpression, "Wide grin", {content: 1.0}, False)
    assert state.recipe.layers[0].source == content
    assert content.removeprefix("#") in harness.tables.contents


def test_recipes_are_checked_whole(harness: EditHarness) -> None:
    with pytest.raises(Refusal, match="sums to 1"):
        authored(harness).resolve_and_check(FaceRecipe({"broad": 2.0}))
    with pytest.raises(Refusal, match="no face"):
        authored(harness).resolve_and_check(FaceRecipe({"smile": 1.0}))


def test_no_name_of_the_cast_or_of_ones_own_is_free(harness: EditHarness) -> None:
    assert authored(harness).names() == {*harness.cast.faces, *harness.cast.expressions, *harness.cast.poses, "grin"}
