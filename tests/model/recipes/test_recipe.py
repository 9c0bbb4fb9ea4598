"""Recipes as data: they come back from bytes, say what they need, and know no other fields."""

from __future__ import annotations

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.recipes.recipe import FaceRecipe, Layer, Pull, Recipe, sources

numbers = st.floats(allow_nan=False)
vectors = st.tuples(numbers, numbers, numbers)
names = st.sampled_from(["smile", "#0123", "kaori"])
expressions = st.builds(
    Recipe,
    net=st.lists(st.integers(0, 5000), max_size=5).map(tuple),
    vectors=st.lists(vectors, max_size=5).map(tuple),
    ground=st.none() | names,
    layers=st.lists(st.builds(Layer, names, st.text(), numbers, st.none() | st.just("brows"), st.booleans())).map(
        tuple
    ),
    pulls=st.lists(st.builds(Pull, st.text(), numbers)).map(tuple),
    eyes=st.tuples(numbers, numbers, numbers, numbers),
    pupil=numbers,
)
faces = st.builds(
    FaceRecipe,
    base=st.dictionaries(names, numbers),
    regions=st.dictionaries(st.text(), names),
    amount=numbers,
    points=st.lists(st.integers(0, 5000)).map(tuple),
    moves=st.lists(vectors).map(tuple),
)


@given(expressions | faces)
def test_a_recipe_comes_back_from_its_bytes_as_the_kind_it_was(recipe: Recipe | FaceRecipe) -> None:
    data = msgspec.msgpack.encode(recipe)
    assert msgspec.msgpack.decode(data, type=Recipe | FaceRecipe) == recipe


@given(expressions)
def test_an_expression_needs_its_ground_and_its_layers(recipe: Recipe) -> None:
    needed = {layer.source for layer in recipe.layers} | ({recipe.ground} if recipe.ground is not None else set())
    assert sources(recipe) == needed


@given(faces)
def test_a_face_needs_its_base_and_its_regions(recipe: FaceRecipe) -> None:
    assert sources(recipe) == set(recipe.base) | set(recipe.regions.values())


def test_fields_that_nobody_knows_are_refused() -> None:
    strange = msgspec.msgpack.encode({"kind": "face", "base": {}, "beard": 1.0})
    with pytest.raises(msgspec.ValidationError, match="beard"):
        msgspec.msgpack.decode(strange, type=Recipe | FaceRecipe)
