"""One message of each kind, made from its fields alone: what is new on the wire comes along by itself."""

import types
import typing

import msgspec

from omote.perform.mappings.mapping import MacroMapping, MacroTarget


def sample_of(kind: type[msgspec.Struct]) -> msgspec.Struct:
    """A message with plain values in all fields."""
    hints = typing.get_type_hints(kind, include_extras=True)
    return kind(**{field.name: _value(hints[field.name]) for field in msgspec.structs.fields(kind)})


def _value(annotation: object) -> object:
    origin = typing.get_origin(annotation)
    arguments = typing.get_args(annotation)
    if origin is typing.Annotated:
        return _value(arguments[0])
    if origin is typing.Literal:
        return arguments[0]
    if origin in (typing.Union, types.UnionType):
        return _value(next(each for each in arguments if each is not type(None)))
    if origin is tuple:
        return tuple(_value(argument) for argument in arguments if argument is not Ellipsis)
    if isinstance(annotation, type) and issubclass(annotation, msgspec.Struct):
        return sample_of(annotation)
    if annotation is MacroMapping:
        return MacroMapping("m", (MacroTarget("channel/jawOpen"),))
    if origin is dict:
        return {_value(arguments[0]): _value(arguments[1])}
    plain: dict[object, object] = {str: "x", float: 0.5, int: 1, bool: True, bytes: b"\xb0\x07\x40", list: []}
    return plain[origin or annotation]
