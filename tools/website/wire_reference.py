"""Writes the reference of the wire as Markdown: every message and document, from the structs that check them."""

from __future__ import annotations

import dataclasses
import inspect
import re
import types
import typing

import msgspec

from omote.edit.protocol import messages as editing
from omote.show import messages as show
from omote.show.declaration import MESSAGE_LIMIT, SPEECH_LIMIT

Struct = type[msgspec.Struct]
PLAIN = {float: "float", int: "int", str: "text", bool: "bool", bytes: "bytes", type(None): "nothing"}

HEAD = f"""# The wire

Written from `src/omote/show/messages.py` and `src/omote/edit` by `tools/website/wire_reference.py`.

Messages are [MessagePack](https://msgpack.org) maps in binary WebSocket frames; `type` says which one it is. Two links:

| address | who | says first | largest message of a client |
|---|---|---|---|
| `{show.LINK_PATH}` | stages and consoles | `hello` with version {show.PROTOCOL_VERSION} | {MESSAGE_LIMIT} bytes |
| `{editing.EDITING_PATH}` | editors | `greet` with version {editing.EDITING_VERSION} | {editing.EDITING_LIMIT} bytes |

A `say` and a `put_cue` may have {SPEECH_LIMIT} bytes.

A state comes {show.STATE_RATE:g} times a second, complete and absolute: any may be lost. A message that cannot be
obeyed is answered with `refused` and the reason, and changes nothing. Numbers are checked where they are used: a value
out of range is refused, never clamped.
"""


def wire_page() -> str:
    """The page: both links' messages in both directions, then the documents fetched over HTTP."""
    parts = [HEAD]
    parts += _group("Show: client to server", show.CLIENT_MESSAGES)
    parts += _group("Show: server to client", show.SERVER_MESSAGES)
    parts += _shared("Editor: client to server", editing.EDITOR_MESSAGES, show.CLIENT_MESSAGES)
    parts += _shared("Editor: server to client", editing.ANSWERS, show.SERVER_MESSAGES)
    parts += _group("Documents over HTTP", show.DOCUMENTS)
    told = {*show.CLIENT_MESSAGES, *show.SERVER_MESSAGES, *editing.EDITOR_MESSAGES, *editing.ANSWERS, *show.DOCUMENTS}
    parts += _group("Inside messages and documents", _inner(told))
    return "\n".join(parts)


def _group(title: str, structs: typing.Iterable[Struct]) -> list[str]:
    return [f"## {title}\n", *(section(struct) for struct in structs)]


def _shared(title: str, structs: typing.Iterable[Struct], told: typing.Collection[Struct]) -> list[str]:
    """A group of the second link; what the first has too is named only."""
    own = list[Struct]()
    both = list[Struct]()
    for struct in structs:
        (both if struct in told else own).append(struct)
    named = ", ".join(f"`{struct.__struct_config__.tag}`" for struct in both)
    return [*_group(title, own), f"Of the show's too: {named}.\n"]


def section(struct: Struct) -> str:
    """One message: its tag, what it is for, and its fields."""
    tag = struct.__struct_config__.tag
    title = f"`{tag or struct.__name__}`"
    if (
        struct not in show.SERVER_MESSAGES
        and struct in editing.ANSWERS
        and tag in {answer.__struct_config__.tag for answer in show.SERVER_MESSAGES}
    ):
        title += " (editor)"  # both links have one of this name
    hints = typing.get_type_hints(struct, include_extras=True)
    rows = [f"| `{field.name}` | {_described(hints[field.name])} |" for field in msgspec.structs.fields(struct)]
    table = ["| field | type |", "|---|---|", *rows, ""] if rows else ["No fields.", ""]
    return "\n".join([f"### {title}\n", inspect.cleandoc(struct.__doc__ or ""), "", *table])


def _described(annotation: object) -> str:
    """A type in words: `text of 1 to 80 characters`, `one of "stage", "console"`, `float or nothing`."""
    origin = typing.get_origin(annotation)
    arguments = typing.get_args(annotation)
    if origin is typing.Annotated:
        return _described(arguments[0]) + _bounds(arguments[1:])
    if origin is typing.Literal:
        return "one of " + ", ".join(f"`{value}`" for value in arguments)
    if origin in (typing.Union, types.UnionType):
        return " or ".join(map(_described, arguments))
    if origin is list or (origin is tuple and arguments[1:] == (...,)):
        return f"list of {_described(arguments[0])}"
    if origin is tuple:
        return f"{len(arguments)} of {_described(arguments[0])}"
    if origin is dict:
        return f"{_described(arguments[1])} by name"
    return PLAIN.get(typing.cast(type, annotation)) or _named(annotation)


def _named(annotation: object) -> str:
    """A struct by a link to it, a value of the engine by its fields."""
    if isinstance(annotation, type) and issubclass(annotation, msgspec.Struct):
        tag = annotation.__struct_config__.tag
        return f"[{annotation.__name__}](#{_anchor(str(tag or annotation.__name__))})"
    if dataclasses.is_dataclass(annotation):
        return "map of " + ", ".join(f"`{each.name}`" for each in dataclasses.fields(annotation))
    return _unknown(annotation)


def _unknown(annotation: object) -> typing.NoReturn:
    raise TypeError(f"there are no words for {annotation!r}; give it some in tools/website/wire_reference.py")


def _bounds(extras: tuple[object, ...]) -> str:
    for extra in extras:
        if isinstance(extra, msgspec.Meta) and extra.max_length is not None:
            return (
                f", {extra.min_length} to {extra.max_length} long"
                if extra.min_length
                else f", up to {extra.max_length}"
            )
    return ""


def _anchor(title: str) -> str:
    return re.sub(r"[^\w-]", "", title.lower())


def _inner(told: set[Struct]) -> list[Struct]:
    """The structs that messages hold and that are no message themselves, each once, in the order of their use."""
    waiting = sorted(told, key=lambda struct: struct.__name__)
    found = dict[Struct, None]()
    while waiting:
        for annotation in typing.get_type_hints(waiting.pop(0)).values():
            for struct in _structs_in(annotation):
                if struct not in told and struct not in found:
                    found[struct] = None
                    waiting.append(struct)
    return [*found]


def _structs_in(annotation: object) -> list[Struct]:
    if isinstance(annotation, type) and issubclass(annotation, msgspec.Struct):
        return [annotation]
    return [struct for argument in typing.get_args(annotation) for struct in _structs_in(argument)]
