"""What a program gives, checked at one place before it goes to a show: each wrong value is named in a sentence."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping
from dataclasses import is_dataclass
from functools import lru_cache
from numbers import Real
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import msgspec
import numpy as np
from msgspec import structs

from omote.show.declaration import ClientMessage, Message
from omote.show.objects.calls import FadeExpression, FadeFace, FadePose
from omote.show.objects.characters import AddCharacter, EnterCharacter, LeaveCharacter, RemoveCharacter, RenameCharacter
from omote.show.objects.speech import Say
from omote.show.wire import encode

LARGEST = 1e30
"""The largest number that is packed: float32 goes to 3.4e38."""


def pack_numbers(values: Iterable[object], what: str) -> bytes:
    """Packs values as float32, little-endian; TypeError or ValueError for what is none. what: "a time (seconds)"."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise TypeError(f"{values!r} came; give a list of numbers, each {what}")
    numbers = list[float]()
    for value in values:
        if isinstance(value, bool) or not isinstance(value, Real):
            raise TypeError(f"{what} is {value!r}; give a number")
        if abs(float(value)) > LARGEST:
            raise ValueError(f"{what} is {value!r}; give a number that is not so large")
        numbers.append(float(value))
    return struct.pack(f"<{len(numbers)}f", *numbers)


_NOUNS: Mapping[object, str] = {
    str: "text", float: "a number", int: "a whole number", bool: "True or False", NoneType: "None", bytes: "bytes",
}  # fmt: skip
_ARGUMENTS: Mapping[tuple[type, str], str] = {
    (FadeFace, "value"): "x",
    (FadeExpression, "value"): "x",
    (FadePose, "value"): "x",
    (RenameCharacter, "character"): "name",
    (AddCharacter, "character"): "name",
    (RemoveCharacter, "character"): "name",
    (EnterCharacter, "character"): "name",
    (LeaveCharacter, "character"): "name",
}
"""Fields that a program knows by another name."""


def argument_name(kind: type[ClientMessage], field: str) -> str:
    """What a program calls a field of a kind of command."""
    return _ARGUMENTS.get((kind, field), field)


def check_fields(message: ClientMessage) -> ClientMessage:
    """The message with plain values: numbers of numpy as numbers, arrays as lists.

    TypeError for a value that is of another kind than its field, ValueError for one that is of this kind but cannot be;
    both name the argument, what came and what to give.
    """
    changed = {}
    for field, hint in _hints(type(message)):
        value = getattr(message, field)
        if type(value) in (bytes, NoneType) or (is_dataclass(hint) and type(value) is hint):
            continue  # values of the engine are checked when they are made
        plain = _plain(value)
        try:
            converted = msgspec.convert(plain, hint)
        except (msgspec.ValidationError, OverflowError):
            name = argument_name(type(message), field)
            kind = ValueError if _is_of_kind(plain, hint) else TypeError
            raise kind(f"{name} is {_shown(value)}; give {explain(hint)}{_advice(message, kind)}") from None
        if converted is not value:
            changed[field] = converted
    return structs.replace(message, **changed) if changed else message


def encode_checked(message: ClientMessage) -> bytes:
    """The bytes of a message; ValueError and TypeError as of `check_fields`, and for more than a show reads, which
    would end the link."""
    message = check_fields(message)
    data = encode(message)
    limit = message.longest
    if len(data) <= limit:
        return data
    advice = _advice(message, ValueError) or ": send less at once"
    raise ValueError(f"this takes {len(data)} bytes, and a show reads at most {limit} of one message{advice}")


def explain(hint: Any) -> str:
    """What a field wants, in words."""
    origin = get_origin(hint)
    inner = get_args(hint)
    if origin is Annotated:
        longest = next(
            (constraint.max_length for constraint in inner[1:] if isinstance(constraint, msgspec.Meta)), None
        )
        return explain(inner[0]) + ("" if longest is None else f", at most {longest}{_unit(inner[0])}")
    if origin is Literal:
        return f"one of {', '.join(map(str, inner))}"
    if origin in (Union, UnionType):
        return " or ".join(explain(choice) for choice in inner)
    if origin is list:
        return f"a list of {explain(inner[0])}"
    if origin is tuple:
        return f"{len(inner)} numbers"
    if is_dataclass(hint) and isinstance(hint, type):
        return f"an omote.{hint.__name__}"
    return _NOUNS.get(hint, "what the reference says")


def _advice(message: ClientMessage, kind: type[Exception]) -> str:
    """What to do about a speech that is too long."""
    wants = isinstance(message, Say) and kind is ValueError
    return ": say it in several sentences, with queue=True" if wants else ""


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:40]}... ({len(value if isinstance(value, str) else text)} characters)"


def _unit(hint: Any) -> str:
    return " characters" if hint is str else " of them" if get_origin(hint) is list else ""


@lru_cache(maxsize=256)
def _hints(kind: type[Message]) -> tuple[tuple[str, Any], ...]:
    hints = get_type_hints(kind, include_extras=True)
    return tuple((field.name, hints[field.name]) for field in structs.fields(kind))


def _plain(value: Any) -> Any:
    """Without numpy: a number of it as a number, an array as a list."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    return value


def _is_of_kind(value: object, hint: Any) -> bool:
    """Whether a value is of the type that a field has, so that it is the value itself that cannot be."""
    origin = get_origin(hint)
    inner = get_args(hint)
    if origin is Annotated:
        return _is_of_kind(value, inner[0])
    if origin in (Union, UnionType):
        return any(_is_of_kind(value, choice) for choice in inner)
    if origin is Literal:
        return isinstance(value, str)
    if hint is float:
        return isinstance(value, float | int) and not isinstance(value, bool)
    if origin in (tuple, list):
        return isinstance(value, tuple | list) and all(_is_of_kind(entry, inner[0]) for entry in value)
    return isinstance(hint, type) and isinstance(value, hint) and not (hint is int and isinstance(value, bool))
