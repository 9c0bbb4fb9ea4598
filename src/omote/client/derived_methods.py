"""Methods of a running show that commands declare: their names, arguments and words are those of the command."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from typing import Any

from msgspec import NODEFAULT, structs

from omote.client.message_check import argument_name
from omote.show.declaration import ClientMessage, tag_of

FILLED_IN = ("id",)
"""Fields that the link fills in."""


def add_methods(owner: type[Any], commands: Iterable[type[ClientMessage]], *, filled: Iterable[str] = ()) -> None:
    """Gives a class a method for each command of which it has none of its own.

    owner: a class whose `build` makes a command of its fields and sends it; commands: the kinds of commands; filled:
    fields that `build` fills in, besides the id.
    """
    for command in commands:
        name = tag_of(command) if command.method == "" else command.method
        if name is not None and not hasattr(owner, name):
            setattr(owner, name, method_of(command, name, {*FILLED_IN, *filled}))


def method_of(command: type[ClientMessage], name: str, filled: set[str]) -> Callable[..., Any]:
    """The method that sends a command: fields without a default by their place, others by name, but for the first of a
    command that has no other.

    command: the kind; name: of the method; filled: fields that are not given.
    """
    fields = [field for field in structs.fields(command) if field.name not in filled]
    needed = [field for field in fields if field.required]
    placed = needed or fields[:1]
    names = {argument_name(command, field.name): field.name for field in fields}
    signature = inspect.Signature(
        [inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)]
        + [
            inspect.Parameter(
                argument_name(command, field.name),
                inspect.Parameter.POSITIONAL_OR_KEYWORD if field in placed else inspect.Parameter.KEYWORD_ONLY,
                default=_default_of(field),
            )
            for field in sorted(fields, key=lambda field: field not in placed)
        ]
    )

    def send(self: Any, *arguments: Any, **named: Any) -> Any:
        bound = signature.bind(self, *arguments, **named).arguments
        return self.build(command, {names[argument]: value for argument, value in bound.items() if argument != "self"})

    send.__name__ = name
    send.__qualname__ = name
    send.__doc__ = command.__doc__
    send.__signature__ = signature  # type: ignore[attr-defined]
    return send


def _default_of(field: structs.FieldInfo) -> Any:
    if field.default is not NODEFAULT:
        return field.default
    return inspect.Parameter.empty if field.default_factory is NODEFAULT else field.default_factory()


def named(command: type[ClientMessage], next_id: Callable[[], str]) -> dict[str, str]:
    """The id of a command that has one, so that it executes once. command: its kind; next_id: gives the next."""
    return {"id": next_id()} if "id" in command.__struct_fields__ else {}
