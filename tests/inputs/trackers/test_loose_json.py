"""JSON as strangers write it: what no program can mean otherwise is read, and nothing else."""

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.loose_json import find_field, load_loosely, read_number, read_pairs, read_text

DOCUMENT = {"a": 0.5, "b": [1.0, {"c": -2.25}], "d": "1,5"}


@pytest.mark.parametrize("coding", ["utf-8", "utf-8-sig", "utf-16"])
def test_marks_and_commas_before_decimals_change_nothing(coding: str) -> None:
    for text in (json.dumps(DOCUMENT), json.dumps(DOCUMENT).replace("0.5", "0,5").replace("-2.25", "-2,25")):
        assert load_loosely(text.encode(coding)) == DOCUMENT


@given(
    st.recursive(st.integers() | st.text() | st.none(), lambda each: st.lists(each) | st.dictionaries(st.text(), each))
)
def test_a_document_that_is_one_is_read_as_it_is(document: object) -> None:
    text = json.dumps(document)
    assert load_loosely(text.encode()) == json.loads(text, parse_int=float)


@pytest.mark.parametrize("data", [b"", b"hello", b"{", b"[" * 100_000, b"\xff\xfe\x00", b'{"a":1,2,3}'])
def test_what_is_no_document_is_none(data: bytes) -> None:
    assert load_loosely(data) is None


def test_fields_are_found_in_any_case_and_with_underscores() -> None:
    document = {"Face_BlendShapes": 1, "x": None}
    assert find_field(document, "faceblendshapes") == 1
    assert find_field(document, "x", 2) is None
    assert (find_field(document, "y", 2), find_field([1], "x")) == (2, None)


@pytest.mark.parametrize(
    ("value", "number"),
    [(1, 1.0), ("0,5", 0.5), (" -0.5 ", -0.5), ("\u22120,5", -0.5), ("", None), (None, None), ([], None)],
)
def test_a_text_is_a_number_where_it_says_one(value: object, number: float | None) -> None:
    read = read_number(value)
    assert math.isnan(read) if number is None else read == number


def test_pairs_are_read_of_lists_and_of_objects() -> None:
    listed = [{"K": "a", "v": 1}, {"k": "b", "v": "2"}, {"k": None, "v": 3}, {"v": 4}, 5]
    assert read_pairs(listed, "k", "v") == read_pairs({"a": 1, "b": 2.0, "": 3}, "k", "v") == {"a": 1.0, "b": 2.0}
    assert read_pairs(None, "k", "v") == {}


def test_bytes_that_are_no_text_raise_nothing() -> None:
    assert read_text(b"a\xff\xfe\xfd") == "a" + 3 * "\ufffd"
