"""What requests are about: checked recipes, orders that carry everything, and what the file must keep for them."""

import pytest

from omote.edit.protocol import messages as wire
from omote.edit.session.plan import Authored
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe, Layer, Recipe
from omote.show.validation import Refusal
from tests.authoring import Studio, net_of


@pytest.fixture
def studio(cast: Cast) -> Studio:
    """Ann at an unsaved expression."""
    studio = Studio(cast)
    studio.greet("ann")
    studio.ask("ann", wire.CreateExpression, "Grin", {"smile": 1.0}, False)
    return studio


def authored(studio: Studio) -> Authored:
    """What the session's requests are about."""
    return studio.session.authored


def test_orders_carry_the_contents_that_their_recipe_names(studio: Studio) -> None:
    source = studio.ask("ann", wire.Flatten, 1).recipe.ground
    net = net_of(studio.cast)
    recipe = Recipe(net, ((0.0, 0.0, 1.0),) * len(net), layers=(Layer(source, "Grin"), Layer("smile", "Smile")))
    order = authored(studio).bake(recipe, weave=True)
    assert {"#" + key for key in order.contents} == {source}
    assert order.weave
    assert not authored(studio).bake(FaceRecipe({"broad": 1.0}), weave=True).weave, "faces have no net"


def test_a_draft_may_be_laid_under_another_before_it_is_saved_and_is_kept_then(studio: Studio) -> None:
    content = studio.ask("ann", wire.OpenItem, 1).content
    assert content.removeprefix("#") not in studio.tables.contents
    state = studio.ask("ann", wire.CreateExpression, "Wide grin", {content: 1.0}, False)
    assert state.recipe.layers[0].source == content
    assert content.removeprefix("#") in studio.tables.contents


def test_recipes_are_checked_whole(studio: Studio) -> None:
    with pytest.raises(Refusal, match="sums to 1"):
        authored(studio).checked(FaceRecipe({"broad": 2.0}))
    with pytest.raises(Refusal, match="no face"):
        authored(studio).checked(FaceRecipe({"smile": 1.0}))


def test_no_name_of_the_cast_or_of_ones_own_is_free(studio: Studio) -> None:
    assert authored(studio).names() == {*studio.cast.faces, *studio.cast.expressions, "grin"}
