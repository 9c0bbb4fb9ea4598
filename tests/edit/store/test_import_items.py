"""Expressions from outside: in every crew's show file the same, under names of their own."""

import numpy as np
import pytest

from omote.edit.protocol.wire import read_recipe
from omote.edit.store.import_items import Arrival, adopted, mail_of, mailed, opened
from omote.interchange.formats.expression_json import decode, encode
from omote.model.cast import Cast
from omote.model.recipes.compose_expression import composed
from omote.model.recipes.recipe import KEY, Recipe
from omote.model.space.expression import Expression
from omote.model.transfer.compound import compound
from omote.showfile.changes import Item, PutContent, PutItem, PutRevision, Stored
from omote.showfile.contents import unpack_expression
from tests import synthetic

SPACE = synthetic.space()
ROWS = tuple(int(row) for row in np.flatnonzero(SPACE.on_sheet & (np.abs(SPACE.h) < 0.1))[5::61])
VECTORS = tuple((0.01 * at, -0.001 * at, 1.0 + 0.01 * at) for at in range(len(ROWS)))
NET = Recipe(ROWS, VECTORS)


def same(one: Expression, other: Expression) -> bool:
    """Whether two expressions do the same to every face, to the last bit."""
    faces = synthetic.cast().faces.values()
    return all(np.array_equal(compound(SPACE, face, one), compound(SPACE, face, other)) for face in faces)


def made(arrival: Arrival) -> Expression:
    """The expression that arrived."""
    assert isinstance(arrival.made, Expression)
    return arrival.made


@pytest.mark.parametrize("name", synthetic.EXPRESSIONS)
def test_what_is_mailed_is_what_arrives(name: str, cast: Cast) -> None:
    letter = encode(mailed(SPACE, name, ["a", "b"], cast.expressions[name]))
    arrival = opened(SPACE, decode(letter))
    assert (arrival.label, arrival.tags, arrival.recipe) == (name, ("a", "b"), None)
    assert same(made(arrival), cast.expressions[name])


def test_control_points_arrive_as_control_points() -> None:
    letter = mailed(SPACE, "drawn", [], composed(SPACE, NET, {}), NET)
    assert letter.control is not None
    arrival = opened(SPACE, decode(encode(letter)))
    assert arrival.recipe == NET
    assert same(made(arrival), composed(SPACE, NET, {}))


def test_on_another_head_control_points_are_all_that_is_needed() -> None:
    letter = mailed(SPACE, "drawn", [], composed(SPACE, NET, {}), NET)
    foreign = decode(encode(letter).replace(letter.space.encode(), b"0" * 24))
    assert opened(SPACE, foreign).recipe == NET
    dense = mailed(SPACE, "dense", [], composed(SPACE, NET, {}))
    with pytest.raises(ValueError, match=r"'dense' was made on another head .* and not by control points alone"):
        opened(SPACE, decode(encode(dense).replace(dense.space.encode(), b"0" * 24)))


def test_layers_are_told_and_go_as_a_dense_field() -> None:
    recipe = Recipe(ROWS, VECTORS, ground="#00")
    letter = mailed(SPACE, "deep", [], composed(SPACE, NET, {}), recipe)
    assert letter.control is None
    assert letter.dense is not None


def test_names_are_new_and_revisions_can_be_made_again(cast: Cast) -> None:
    before = Stored(items=(Item(7, "expression", "grin", "Grin", place=3.0),))
    smile = cast.expressions["smile"]
    changes = adopted(cast, before, [Arrival("Grin", smile), Arrival("smile", smile, ("x",), "a note")], wall=5.0)
    items = [change.item for change in changes if isinstance(change, PutItem)]
    assert [(item.id, item.name, item.label, item.head) for item in items] == [
        (8, "grin_2", "Grin", 1),
        (9, "smile_2", "smile", 1),
    ]
    contents = {change.key: change.data for change in changes if isinstance(change, PutContent)}
    for change in changes:
        if isinstance(change, PutRevision):
            recipe = read_recipe(change.revision.recipe)
            assert isinstance(recipe, Recipe)
            sources = {KEY + key: unpack_expression(data) for key, data in contents.items()}
            assert same(composed(SPACE, recipe, sources), smile)
            assert change.revision.written == 5.0


def test_what_is_kept_can_be_mailed(cast: Cast) -> None:
    changes = adopted(cast, Stored(), [Arrival("Grin", cast.expressions["smile"], ("x",))], wall=0.0)
    stored = Stored(
        tuple(change.item for change in changes if isinstance(change, PutItem)),
        tuple(change.revision for change in changes if isinstance(change, PutRevision)),
    )
    contents = {change.key: change.data for change in changes if isinstance(change, PutContent)}
    letter = mail_of(cast, stored, contents, "grin")
    assert (letter.label, letter.tags) == ("Grin", ["x"])
    assert same(made(opened(SPACE, letter)), cast.expressions["smile"])
    assert mail_of(cast, stored, contents, "jawOpen").label == cast.titles["jawOpen"].label
    with pytest.raises(ValueError, match="there is no expression 'frown' in this cast"):
        mail_of(cast, stored, contents, "frown")


@pytest.mark.parametrize(
    "recipe",
    [
        Recipe((-1, *ROWS[1:]), VECTORS),
        Recipe((10**9, *ROWS[1:]), VECTORS),
        Recipe(ROWS, VECTORS[1:]),
        Recipe((int(SPACE.inner.vertices[0]), *ROWS[1:]), VECTORS),
    ],
)
def test_control_points_that_stand_nowhere_are_not_mailed_and_the_field_is(recipe: Recipe) -> None:
    letter = mailed(SPACE, "drawn", [], composed(SPACE, NET, {}), recipe)
    assert letter.control is None
    assert same(made(opened(SPACE, decode(encode(letter)))), composed(SPACE, NET, {}))
