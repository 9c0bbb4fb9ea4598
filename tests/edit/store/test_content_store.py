"""The content store: bytes by key, written to the file once; known results are not computed again."""

import pytest

from omote.edit.protocol.orders import Bake, Baked
from omote.edit.store.content_store import PASSING, PASSING_BYTES, ContentStore
from omote.model.recipes.recipe import FaceRecipe, Recipe
from omote.showfile.changes import Content
from tests.authoring import make_baked, net_document

RECIPE = Recipe((0, 1, 2), ((0.0, 0.0, 1.0),) * 3)


def baked(number: int) -> tuple[Bake, Baked]:
    """An order and its answer, one of many."""
    order = Bake(Recipe((0, 1, 2), RECIPE.vectors, pupil=number / 10_000), {})
    return order, make_baked(order)


def test_contents_are_given_to_the_file_once() -> None:
    store = ContentStore({"old": b"kept"})
    store.remember_contents({"new": b"made", "old": b"kept"})
    assert store.changes_to_keep("old") == ()
    assert store.changes_to_keep("new") == (Content("new", b"made"),)
    assert store.changes_to_keep("new") == ()
    assert dict(store) == {"old": b"kept", "new": b"made"}
    assert len(store) == 2


def test_what_was_given_stays_whatever_passes() -> None:
    store = ContentStore({})
    store.remember_contents({"new": b"made"})
    store.changes_to_keep("new")
    for number in range(PASSING + 10):
        store.remember_result(*baked(number))
    assert store["new"] == b"made"
    assert len(store) == PASSING + 1
    with pytest.raises(KeyError):
        store["nothing"]


def test_what_the_file_has_by_now_is_read_from_there() -> None:
    kept: dict[str, bytes] = {}
    store = ContentStore(kept)
    store.remember_contents({"one": b"1", "two": b"2"})
    kept |= {change.key: change.data for change in store.changes_to_keep("one")}
    store.changes_to_keep("two")
    assert {**store} == {"one": b"1", "two": b"2"}
    assert store.changes_to_keep("one") == ()


def test_a_recipe_that_was_baked_is_recalled() -> None:
    store = ContentStore({})
    order, answer = baked(1)
    assert store.recall(order) is None
    store.remember_result(order, answer)
    recalled = store.recall(order)
    assert recalled is not None
    assert (recalled.recipe, recalled.key) == (order.recipe, answer.key)


def test_a_net_is_built_once() -> None:
    store = ContentStore({})
    plain = Bake(RECIPE, {})
    weaving = Bake(RECIPE, {}, with_net=True)
    store.remember_result(plain, make_baked(plain))
    assert store.recall(weaving) is None
    store.remember_result(weaving, make_baked(weaving))
    recalled = store.recall(weaving)
    assert recalled is not None
    assert recalled.net == store.net(RECIPE) == net_document(RECIPE.net)
    assert store.net(FaceRecipe({"generic": 1.0})) is None


def test_what_a_recipe_made_in_another_run_is_known_when_its_bytes_are_there() -> None:
    order, answer = baked(2)
    store = ContentStore(answer.contents)
    assert store.recall(order) is None
    store.remember_result(order, answer)
    assert store.changes_to_keep(answer.key) == ()


def test_large_contents_of_drafts_are_forgotten_by_their_bytes_and_the_newest_stays() -> None:
    store = ContentStore({})
    large = bytes(PASSING_BYTES // 4 + 1)
    for number in range(5):
        store.remember_contents({f"face {number}": large})
    assert list(store) == ["face 2", "face 3", "face 4"]
    store.remember_contents({"huge": bytes(PASSING_BYTES + 1)})
    assert list(store) == ["huge"]
