"""Encoding of editors' messages: every message round-trips, everything else is rejected with an error message."""

import contextlib
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import inspect

from omote.edit.protocol import messages as wire
from omote.edit.protocol.orders import Baked
from omote.edit.protocol.wire import decode, decode_answer, decode_baked, encode, read_recipe, request_in, write_recipe
from omote.model.recipes.recipe import FaceRecipe, Recipe
from omote.show.validation import Refusal


def of(kind: inspect.Type) -> st.SearchStrategy[Any]:
    """Values of a type as messages know it, numbers finite, lists short."""
    match kind:
        case inspect.StructType():
            return st.builds(kind.cls, **{each.name: of(each.type) for each in kind.fields})
        case inspect.UnionType():
            return st.one_of([of(each) for each in kind.types])
        case inspect.TupleType():
            return st.tuples(*[of(each) for each in kind.item_types])
        case inspect.VarTupleType():
            return st.lists(of(kind.item_type), max_size=4).map(tuple)
        case inspect.ListType():
            return st.lists(of(kind.item_type), max_size=min(kind.max_length or 4, 4))
        case inspect.DictType():
            return st.dictionaries(of(kind.key_type), of(kind.value_type), max_size=4)
        case inspect.StrType():
            return st.text(min_size=kind.min_length or 0, max_size=min(kind.max_length or 20, 20))
        case _:
            return PLAIN[type(kind)]


PLAIN: dict[type[inspect.Type], st.SearchStrategy[Any]] = {
    inspect.IntType: st.integers(-(2**63), 2**63 - 1),
    inspect.FloatType: st.floats(allow_nan=False, allow_infinity=False),
    inspect.BoolType: st.booleans(),
    inspect.NoneType: st.none(),
}
requests = st.one_of([of(inspect.type_info(kind)) for kind in wire.EDITOR_MESSAGES])
recipes = st.one_of([of(inspect.type_info(kind)) for kind in (Recipe, FaceRecipe)])


@given(requests)
def test_every_request_comes_back_as_it_was(message: wire.FromEditor) -> None:
    data = encode(message)
    if len(data) <= wire.EDITING_LIMIT:
        assert decode(data) == message


@given(recipes)
def test_every_recipe_comes_back_as_it_was_and_is_written_alike(recipe: Recipe | FaceRecipe) -> None:
    data = write_recipe(recipe)
    assert read_recipe(data) == recipe
    assert write_recipe(read_recipe(data)) == data


@given(st.binary(max_size=300))
def test_no_bytes_do_more_than_be_refused(data: bytes) -> None:
    for read in (decode, decode_baked, read_recipe):
        with contextlib.suppress(Refusal):
            read(data)


@given(requests, st.data())
def test_bent_requests_are_refused_or_are_requests(message: wire.FromEditor, data: st.DataObject) -> None:
    sent = bytearray(encode(message))
    sent[data.draw(st.integers(0, len(sent) - 1))] = data.draw(st.integers(0, 255))
    with contextlib.suppress(Refusal):
        assert isinstance(decode(bytes(sent)), wire.EDITOR_MESSAGES)


def test_a_message_that_is_too_long_is_refused_unread() -> None:
    with pytest.raises(Refusal, match="at most 65536 are read"):
        decode(b"\xff" * 65537)


def test_answers_come_back_for_editors_in_python() -> None:
    answer = wire.Saved(3, 1, 2, 2, False, "Revision 2 of 'Grin' plays from now on.")
    assert decode_answer(encode(answer)) == answer


def test_answers_of_the_workshop_come_back() -> None:
    baked = Baked(Recipe((0, 1, 2), ((0.0, 0.0, 1.0),) * 3), "key", {"key": b"bytes"}, None, 1e-5)
    assert decode_baked(encode(baked)) == baked
    with pytest.raises(Refusal, match="workshop"):
        decode_baked(msgspec.msgpack.encode({"key": 1}))


@given(st.integers(0, 2**53))
def test_the_number_of_a_request_that_is_none_can_be_read(number: int) -> None:
    assert request_in(msgspec.msgpack.encode({"type": "dance", "request": number, "more": []})) == number
    for data in (b"", b"\x91" * 3000, msgspec.msgpack.encode({"request": str(number)}), bytes(wire.EDITING_LIMIT + 1)):
        assert request_in(data) == -1
