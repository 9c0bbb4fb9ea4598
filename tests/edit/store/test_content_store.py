"""The shelf: bytes by key, given to the file once, and what is known already is not made again."""

import pytest

from omote.edit.protocol.orders import Bake, Baked
from omote.edit.store.content_store import PASSING, Shelf
from omote.model.recipes.recipe import FaceRecipe, Recipe
from omote.showfile.changes import PutContent
from tests.authoring import craft, woven

RECIPE = Recipe((0, 1, 2), ((0.0, 0.0, 1.0),) * 3)


def baked(number: int) -> tuple[Bake, Baked]:
    """An order and its answer, one of many."""
    order = Bake(Recipe((0, 1, 2), RECIPE.vectors, pupil=number / 10_000), {})
    return order, craft(order)


def test_contents_are_given_to_the_file_once() -> None:
    shelf = Shelf({"old": b"kept"})
    shelf.hold({"new": b"made", "old": b"kept"})
    assert shelf.keep("old") == ()
    assert shelf.keep("new") == (PutContent("new", b"made"),)
    assert shelf.keep("new") == ()
    assert dict(shelf) == {"old": b"kept", "new": b"made"}
    assert len(shelf) == 2


def test_what_was_given_stays_whatever_passes() -> None:
    shelf = Shelf({})
    shelf.hold({"new": b"made"})
    shelf.keep("new")
    for number in range(PASSING + 10):
        shelf.take(*baked(number))
    assert shelf["new"] == b"made"
    assert len(shelf) == PASSING + 1
    with pytest.raises(KeyError):
        shelf["nothing"]


def test_what_the_file_has_by_now_is_read_from_there() -> None:
    kept: dict[str, bytes] = {}
    shelf = Shelf(kept)
    shelf.hold({"one": b"1", "two": b"2"})
    kept |= {change.key: change.data for change in shelf.keep("one")}
    shelf.keep("two")
    assert {**shelf} == {"one": b"1", "two": b"2"}
    assert shelf.keep("one") == ()


def test_a_recipe_that_was_baked_is_recalled() -> None:
    shelf = Shelf({})
    order, answer = baked(1)
    assert shelf.recall(order) is None
    shelf.take(order, answer)
    recalled = shelf.recall(order)
    assert recalled is not None
    assert (recalled.recipe, recalled.key) == (order.recipe, answer.key)


def test_a_net_is_woven_once() -> None:
    shelf = Shelf({})
    plain, weaving = Bake(RECIPE, {}), Bake(RECIPE, {}, weave=True)
    shelf.take(plain, craft(plain))
    assert shelf.recall(weaving) is None
    shelf.take(weaving, craft(weaving))
    recalled = shelf.recall(weaving)
    assert recalled is not None
    assert recalled.net == shelf.net(RECIPE) == woven(RECIPE.net)
    assert shelf.net(FaceRecipe({"generic": 1.0})) is None


def test_what_a_recipe_made_in_another_run_is_known_when_its_bytes_are_there() -> None:
    order, answer = baked(2)
    shelf = Shelf(answer.contents)
    assert shelf.recall(order) is None
    shelf.take(order, answer)
    assert shelf.keep(answer.key) == ()
