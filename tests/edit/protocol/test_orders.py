"""Orders and answers travel to the workshop and back as they are."""

import msgspec
import pytest

from omote.edit.protocol.orders import Bake, Baked, EditOrder, Flat, Renet, Solve
from omote.model.recipes.recipe import FaceRecipe, Recipe
from tests.authoring import net_document

REST = (0.0, 0.0, 1.0)
RECIPE = Recipe((0, 1, 2), (REST, (0.1, -0.01, 1.2), REST), ground="#key")
CONTENTS = {"key": b"\x00\xff"}


@pytest.mark.parametrize(
    "order",
    [
        Bake(RECIPE, CONTENTS, with_net=True),
        Bake(FaceRecipe({"generic": 1.0}), {}),
        Solve(RECIPE, CONTENTS, "broad", (1,), ((0.0, 0.1, 0.1),), RECIPE.vectors),
        Renet(RECIPE, CONTENTS, (0, 1, 2, 3)),
        Flat(RECIPE, CONTENTS),
    ],
    ids=["expression", "face", "solve", "renet", "flat"],
)
def test_orders_come_back_as_they_were(order: EditOrder) -> None:
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(order), type=EditOrder) == order


def test_answers_come_back_as_they_were() -> None:
    baked = Baked(RECIPE, "key", CONTENTS, net_document(RECIPE.net), 1e-5)
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(baked), type=Baked) == baked
