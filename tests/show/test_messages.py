"""The messages themselves: tags, and that both directions survive the wire."""

import typing
from typing import TypeVar

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.show.declaration import Message, snake_case
from omote.show.messages import CLIENT_MESSAGES, SERVER_MESSAGES
from omote.show.objects.calls import CallFace
from omote.show.wire import decode, decode_answer, encode

Struct = TypeVar("Struct", bound=msgspec.Struct)


def test_every_message_has_a_tag_of_its_own() -> None:
    tags = [message.__struct_config__.tag for message in (*CLIENT_MESSAGES, *SERVER_MESSAGES)]
    assert len(set(tags)) == len(tags)
    assert {"hello", "call_face", "set_channel", "welcome", "state", "refused"} <= set(tags)


@pytest.mark.parametrize(("name", "tag"), [("Hello", "hello"), ("CallFace", "call_face"), ("SetHead", "set_head")])
def test_a_tag_is_the_name_in_lower_case(name: str, tag: str) -> None:
    assert snake_case(name) == tag


@pytest.mark.parametrize("kind", CLIENT_MESSAGES, ids=lambda kind: str(kind.__name__))
def test_what_a_client_says_comes_over_the_wire_unchanged(kind: type[Message]) -> None:
    message = _example(kind)
    assert decode(encode(message)) == message


@pytest.mark.parametrize("kind", SERVER_MESSAGES, ids=lambda kind: str(kind.__name__))
def test_what_the_server_says_comes_over_the_wire_unchanged(kind: type[Message]) -> None:
    message = _example(kind)
    assert decode_answer(encode(message)) == message


@given(st.floats(0.0, 600.0), st.text(min_size=1, max_size=80))
def test_numbers_and_names_travel_exactly(seconds: float, name: str) -> None:
    message = CallFace("one", "id", name, seconds, "smooth")
    assert decode(encode(message)) == message


def _example(kind: type[Struct]) -> Struct:
    hints = typing.get_type_hints(kind, include_extras=False)
    message: Struct = kind(**{field.name: _value(hints[field.name]) for field in msgspec.structs.fields(kind)})
    return message


def _value(hint: object) -> object:
    origin = typing.get_origin(hint)
    arguments = typing.get_args(hint)
    if origin is typing.Literal:
        return arguments[0]
    if origin is tuple:
        return tuple(_value(argument) for argument in arguments)
    if origin in (list, dict):
        return [] if origin is list else {_value(arguments[0]): _value(arguments[1])}
    if type(None) in arguments:
        return None
    if isinstance(hint, type) and issubclass(hint, msgspec.Struct):
        return _example(hint)
    if hint is MacroMapping:
        return MacroMapping("m", (MacroTarget("channel/jawOpen"),))
    return {str: "smile", float: 0.25, int: 1, bool: True, bytes: b"\xb0\x07\x40"}[hint]  # type: ignore[index]
