"""The commands of a show as tools of the Model Context Protocol, derived from their declarations."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

import msgspec

from omote.client.derived_methods import FILLED_IN
from omote.show.access.access_role import AccessRole, role_allows
from omote.show.declaration import ClientMessage, tag_of, values_of
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects.speech import Say

DEFINITIONS = "$defs"
OWN = (Say,)
"""Commands that a program sends in a way of its own, and that have a tool of their own here."""
NAMES = ("face", "expression", "channel", "pose", "body", "light")
"""Kinds of values that are names; `list_names` gives those that there are."""


class CommandTool(NamedTuple):
    """A tool: its name, what it does, the JSON Schema of its arguments, and the kind of command that it sends."""

    name: str
    description: str
    schema: Mapping[str, Any]
    command: type[ClientMessage]


def command_tools(role: AccessRole) -> dict[str, CommandTool]:
    """The tools of whoever has a role, by name: the commands that programs have methods for and that the role allows.

    role: of the token.
    """
    kinds = [kind for kind in CLIENT_MESSAGES if kind.method is not None and kind not in OWN]
    tools = [_tool_of(kind) for kind in kinds if role_allows(role, kind.access)]
    return {tool.name: tool for tool in tools}


@cache
def _tool_of(kind: type[ClientMessage]) -> CommandTool:
    return CommandTool(tag_of(kind), " ".join((kind.__doc__ or "").split()), _schema_of(kind), kind)


def _schema_of(kind: type[ClientMessage]) -> dict[str, Any]:
    """The JSON Schema of a command's fields, without those that the link fills in."""
    (reference,), definitions = msgspec.json.schema_components([kind], ref_template=f"#/{DEFINITIONS}/{{name}}")
    whole = definitions.pop(reference["$ref"].rpartition("/")[2])
    filled = {"type", *FILLED_IN}
    fields = {name: _described(kind, name, field) for name, field in whole["properties"].items() if name not in filled}
    needed = [name for name in whole.get("required", ()) if name not in filled]
    schema = {"type": "object", "properties": fields, "required": needed, "additionalProperties": False}
    return {**schema, DEFINITIONS: definitions} if definitions else schema


def _described(kind: type[ClientMessage], name: str, field: Mapping[str, Any]) -> dict[str, Any]:
    """The schema of a field, with the unit, the range or the kind of name that the command declares for it."""
    value = values_of(kind).get(name)
    if value is None:
        return dict(field)
    if value.kind in NAMES:
        return {**field, "description": f"The name or the label of one of the show: kind {value.kind} of list_names."}
    if value.unit == "degrees":
        return {**field, "description": "Radians."}
    limits = {"minimum": value.low, "maximum": value.high} if field.get("type") == "number" else {}
    unit = {"description": {"s": "Seconds."}.get(value.unit, value.unit)} if value.unit else {}
    return {**field, **limits, **unit}
