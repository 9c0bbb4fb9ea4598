"""Imported and exported expressions: the same in every show file, under names of their own."""

import numpy as np
import pytest
from msgspec.structs import replace

from omote.edit.protocol.wire import read_recipe
from omote.edit.store.import_items import (
    ImportedItem,
    changes_to_import,
    export_document,
    find_known,
    import_document,
    make_document,
)
from omote.interchange.formats.expression_json import decode, encode
from omote.model.cast import Cast
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import KEY, Recipe
from omote.model.space.expression import Expression
from omote.model.transfer.compound import compound
from omote.showfile.changes import Content, Item, Revision, Stored
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


def made(arrival: ImportedItem) -> Expression:
    """The expression that arrived."""
    assert isinstance(arrival.made, Expression)
    return arrival.made


@pytest.mark.parametrize("name", synthetic.EXPRESSIONS)
def test_what_is_mailed_is_what_arrives(name: str, cast: Cast) -> None:
    letter = encode(make_document(SPACE, name, ["a", "b"], cast.expressions[name]))
    arrival = import_document(SPACE, decode(letter))
    assert (arrival.label, arrival.tags, arrival.recipe) == (name, ("a", "b"), None)
    assert same(made(arrival), cast.expressions[name])


def test_control_points_arrive_as_control_points() -> None:
    letter = make_document(SPACE, "drawn", [], compose_expression(SPACE, NET, {}), NET)
    assert letter.control is not None
    arrival = import_document(SPACE, decode(encode(letter)))
    assert arrival.recipe == NET
    assert same(made(arrival), compose_expression(SPACE, NET, {}))


def test_on_another_head_control_points_are_all_that_is_needed() -> None:
    letter = make_document(SPACE, "drawn", [], compose_expression(SPACE, NET, {}), NET)
    foreign = decode(encode(letter).replace(letter.space.encode(), b"0" * 24))
    assert import_document(SPACE, foreign).recipe == NET
    dense = make_document(SPACE, "dense", [], compose_expression(SPACE, NET, {}))
    with pytest.raises(ValueError, match=r"'dense' was made on another head .* and not by control points alone"):
        import_document(SPACE, decode(encode(dense).replace(dense.space.encode(), b"0" * 24)))


def test_layers_are_told_and_go_as_a_dense_field() -> None:
    recipe = Recipe(ROWS, VECTORS, ground="#00")
    letter = make_document(SPACE, "deep", [], compose_expression(SPACE, NET, {}), recipe)
    assert letter.control is None
    assert letter.dense is not None


def test_names_are_new_and_revisions_can_be_made_again(cast: Cast) -> None:
    before = Stored(items=(Item(7, "expression", "grin", "Grin", place=3.0),))
    smile = cast.expressions["smile"]
    changes = changes_to_import(
        cast, before, [ImportedItem("Grin", smile), ImportedItem("smile", smile, ("x",), "a note")], wall=5.0
    )
    items = [change for change in changes if isinstance(change, Item)]
    assert [(item.id, item.name, item.label, item.head) for item in items] == [
        (8, "grin_2", "Grin", 1),
        (9, "smile_2", "smile", 1),
    ]
    contents = {change.key: change.data for change in changes if isinstance(change, Content)}
    for change in changes:
        if isinstance(change, Revision):
            recipe = read_recipe(change.recipe)
            assert isinstance(recipe, Recipe)
            sources = {KEY + key: unpack_expression(data) for key, data in contents.items()}
            assert same(compose_expression(SPACE, recipe, sources), smile)
            assert change.written == 5.0


def test_what_plays_already_is_known_by_its_content(cast: Cast) -> None:
    smile, jaw = (ImportedItem(name, cast.expressions[name]) for name in ("smile", "jawOpen"))
    changes = changes_to_import(cast, Stored(), [smile], wall=0.0)
    (item,) = (change for change in changes if isinstance(change, Item))
    revisions = tuple(change for change in changes if isinstance(change, Revision))
    stored = Stored(items=(item,), revisions=revisions)
    first, new, again = find_known(stored, [ImportedItem("another name", cast.expressions["smile"]), jaw, jaw])
    assert (first, new) == (item, None)
    assert again is not None
    assert again.label == "jawOpen"
    deleted = Stored(items=(replace(item, deleted=True),), revisions=revisions)
    edited = Stored(items=(replace(item, head=2),), revisions=revisions)
    assert find_known(deleted, [smile]) == find_known(edited, [smile]) == [None]


def test_what_is_kept_can_be_mailed(cast: Cast) -> None:
    changes = changes_to_import(cast, Stored(), [ImportedItem("Grin", cast.expressions["smile"], ("x",))], wall=0.0)
    stored = Stored(
        tuple(change for change in changes if isinstance(change, Item)),
        tuple(change for change in changes if isinstance(change, Revision)),
    )
    contents = {change.key: change.data for change in changes if isinstance(change, Content)}
    letter = export_document(cast, stored, contents, "grin")
    assert (letter.label, letter.tags) == ("Grin", ["x"])
    assert same(made(import_document(SPACE, letter)), cast.expressions["smile"])
    assert export_document(cast, stored, contents, "jawOpen").label == cast.titles["jawOpen"].label
    with pytest.raises(ValueError, match="there is no expression 'frown' in this cast"):
        export_document(cast, stored, contents, "frown")
    with_face = replace(stored, items=(*stored.items, Item(9, "face", "on_air_1", "On air 1", (), 1.0, head=1)))
    with pytest.raises(ValueError, match="'on_air_1' is a face, and only expressions become documents"):
        export_document(cast, with_face, contents, "on_air_1")
    both = replace(stored, items=(*with_face.items, Item(10, "face", "grin", "Grin", (), 2.0, head=1)))
    assert export_document(cast, both, contents, "grin") == letter


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
    letter = make_document(SPACE, "drawn", [], compose_expression(SPACE, NET, {}), recipe)
    assert letter.control is None
    assert same(made(import_document(SPACE, decode(encode(letter)))), compose_expression(SPACE, NET, {}))
