"""Writes `web/src/link/messages.ts` and `editing.ts` from the Python messages: `python tools/messages.py [--check]`."""

from __future__ import annotations

import inspect
import sys
import types
import typing
from pathlib import Path
from types import ModuleType

import msgspec

from omote.edit.protocol import messages as editing
from omote.show import messages

FOLDER = Path(__file__).parent.parent / "web" / "src" / "link"
HEAD = "// Written by tools/messages.py from src/omote/{}/messages.py. Do not edit: run `python tools/messages.py`.\n"
PLAIN = {float: "number", int: "number", str: "string", bool: "boolean", bytes: "Uint8Array", type(None): "null"}


def type_script(annotation: object) -> str:
    """The TypeScript type of a Python annotation; TypeError for one the wire does not know."""
    if isinstance(annotation, type) and annotation in PLAIN:
        return PLAIN[annotation]
    if isinstance(annotation, type) and issubclass(annotation, msgspec.Struct):
        return annotation.__name__
    return _generic(typing.get_origin(annotation), typing.get_args(annotation), annotation)


def interface(struct: type[msgspec.Struct]) -> str:
    """One exported interface, with the docstring as its comment."""
    config = struct.__struct_config__
    hints = typing.get_type_hints(struct)
    fields = [f"  {config.tag_field}: {_quote(config.tag)};"] if config.tag is not None else []
    fields += [f"  {field.name}: {type_script(hints[field.name])};" for field in msgspec.structs.fields(struct)]
    lines = inspect.cleandoc(struct.__doc__ or "").replace("\n\n", "\n").splitlines()
    comment = f"/** {lines[0]} */" if len(lines) == 1 else "/**\n" + "".join(f" * {line}\n" for line in lines) + " */"
    return f"{comment}\nexport interface {struct.__name__} {{\n" + "\n".join(fields) + "\n}\n"


def show_module() -> str:
    """The messages of the show's link in TypeScript, the same text for the same messages."""
    constants = [
        f"export const PROTOCOL_VERSION = {messages.PROTOCOL_VERSION};",
        f"export const LINK_PATH = {_quote(messages.LINK_PATH)};",
        f"/** States per second. */\nexport const STATE_RATE = {messages.STATE_RATE:g};",
    ]
    unions = [_union("FromClient", messages.CLIENT_MESSAGES), _union("FromServer", messages.SERVER_MESSAGES)]
    return _module("show", constants, structs_of(messages), unions)


def editing_module() -> str:
    """The messages of the editors' link in TypeScript, recipes and what is kept of them included."""
    constants = [
        f"export const EDITING_VERSION = {editing.EDITING_VERSION};",
        f"export const EDITING_PATH = {_quote(editing.EDITING_PATH)};",
        f"/** Bytes; no message of an editor is longer. */\nexport const EDITING_LIMIT = {editing.EDITING_LIMIT};",
    ]
    unions = [_union("FromEditor", editing.EDITOR_MESSAGES), _union("ToEditor", editing.ANSWERS)]
    return _module("edit", constants, structs_of(editing), unions)


MODULES = {"messages.ts": show_module, "editing.ts": editing_module}


def structs_of(module: ModuleType) -> list[type[msgspec.Struct]]:
    """Every struct that a module of messages defines or names, in its order."""
    return [value for value in vars(module).values() if _is_message(value)]


def main(arguments: list[str]) -> int:
    """Writes the mirrors; with `--check` only says whether one is stale (exit status 1)."""
    texts = {FOLDER / name: text() for name, text in MODULES.items()}
    if "--check" in arguments:
        return 0 if all(path.exists() and path.read_text() == text for path, text in texts.items()) else 1
    FOLDER.mkdir(parents=True, exist_ok=True)
    for path, text in texts.items():
        path.write_text(text)
    return 0


def _module(package: str, constants: list[str], structs: list[type[msgspec.Struct]], unions: list[str]) -> str:
    return "\n".join([HEAD.format(package), "\n".join(constants) + "\n", *map(interface, structs), *unions])


def _generic(origin: object, arguments: tuple[object, ...], annotation: object) -> str:
    if origin is typing.Literal:
        return " | ".join(map(_quote, arguments))
    if origin in (typing.Union, types.UnionType):
        return " | ".join(map(type_script, arguments))
    if origin is list or (origin is tuple and arguments[1:] == (...,)):
        inner = type_script(arguments[0])
        return f"({inner})[]" if "|" in inner else f"{inner}[]"
    if origin is tuple:
        return f"[{', '.join(map(type_script, arguments))}]"
    if origin is dict and arguments[0] is str:
        return f"Record<string, {type_script(arguments[1])}>"
    raise TypeError(
        f"no TypeScript for {annotation!r}: use float, int, str, bool, bytes, None, list, tuple, dict or a struct"
    )


def _is_message(value: object) -> bool:
    return isinstance(value, type) and issubclass(value, msgspec.Struct) and value is not messages.Message


def _union(name: str, members: tuple[type[msgspec.Struct], ...]) -> str:
    names = [member.__name__ for member in members]
    line = f"export type {name} = {' | '.join(names)};\n"
    return (
        line if len(line) <= 120 else f"export type {name} =\n" + "\n".join(f"  | {member}" for member in names) + ";\n"
    )


def _quote(value: object) -> str:
    return f'"{value}"'


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
