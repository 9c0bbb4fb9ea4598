"""Errors of the system and of decoders are turned into words."""

import errno
import os
import struct
import zlib
from typing import Annotated, Literal

import msgspec
import pytest

from omote.interchange.formats.error_reasons import SYSTEM_REASONS, explain_error


class Layer(msgspec.Struct, forbid_unknown_fields=True):
    """A part of the document below."""

    weight: float


class Document(msgspec.Struct, tag_field="type", tag="document", forbid_unknown_fields=True):
    """A document as messages and files have them."""

    seconds: float | None
    layers: list[Layer] = []
    pair: tuple[int, int] = (1, 2)
    kind: Literal["face", "expression"] = "face"
    name: Annotated[str, msgspec.Meta(min_length=1, max_length=3)] = "a"


@pytest.mark.parametrize(
    ("fields", "sentence"),
    [
        ({}, "seconds is missing"),
        ({"seconds": "2"}, "seconds is text; expected a number or nothing"),
        ({"seconds": 1, "layers": [{"weight": 1}, {"weight": None}]}, "layers[1].weight is nothing; expected a number"),
        ({"seconds": 1, "layers": [{}]}, "weight in layers[0] is missing"),
        ({"seconds": 1, "layers": {}}, "layers is a table; expected a list"),
        ({"seconds": 1, "pair": [1]}, "pair is not a list of length 2"),
        ({"seconds": 1, "kind": "light"}, "kind is 'light', not one of those known"),
        ({"seconds": 1, "name": "abcd"}, "name is not text of length at most 3"),
        ({"seconds": 1, "size": 1}, "size is not known"),
        ({"type": "fax"}, "type is 'fax', not one of those known"),
    ],
)
@pytest.mark.parametrize("codec", [msgspec.json, msgspec.msgpack])
def test_what_is_wrong_with_a_document_is_named_in_words(
    codec: object, fields: dict[str, object], sentence: str
) -> None:
    assert codec in (msgspec.json, msgspec.msgpack)
    data = getattr(codec, "encode")({"type": "document", **fields})  # noqa: B009  (two modules with the same functions)
    with pytest.raises(msgspec.ValidationError) as raised:
        getattr(codec, "decode")(data, type=Document)  # noqa: B009
    assert explain_error(raised.value) == sentence


def test_a_document_that_is_none_is_told() -> None:
    with pytest.raises(msgspec.ValidationError) as raised:
        msgspec.json.decode(b"[1]", type=Document)
    assert explain_error(raised.value) == "the whole is a list; expected a table"


@pytest.mark.parametrize("error", [zlib.error("Error -3"), struct.error("unpack"), msgspec.DecodeError("truncated")])
def test_damaged_bytes_are_damaged_bytes(error: Exception) -> None:
    assert explain_error(error) == "its bytes are damaged or cut off"


@pytest.mark.parametrize("number", SYSTEM_REASONS)
def test_no_number_and_no_path_of_the_system_comes_through(number: int) -> None:
    error = OSError(number, os.strerror(number), "/somewhere/a.omote")
    assert explain_error(error) == SYSTEM_REASONS[number]


def test_a_rare_error_of_the_system_has_its_own_words() -> None:
    assert explain_error(OSError(errno.EXDEV, "x")) == os.strerror(errno.EXDEV).lower()


def test_our_own_sentences_come_through() -> None:
    for error in (OSError("the port is taken"), ValueError("a face is missing")):
        assert explain_error(error) == str(error)
    assert explain_error(KeyError("kaori")) == "kaori is missing"
    with pytest.raises(UnicodeDecodeError) as raised:
        b"\xff".decode()
    assert explain_error(raised.value) == "its text is not UTF-8"
