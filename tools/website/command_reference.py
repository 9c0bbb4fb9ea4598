"""Writes the reference of the `omote` commands as Markdown, from what their own `--help` is made of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import typer

from omote.cli import app

HEAD = """# Commands

Written from `omote --help` by `tools/website/command_reference.py`. Every command says the same in a terminal:
`omote COMMAND --help`. A command that cannot do what it is told ends with one sentence and exit status 1,
one that is not understood with 2, Ctrl-C with 130.
"""


def command_page() -> str:
    """The page: each command with its arguments and options."""
    root = typer.main.get_command(app)
    return "\n".join([HEAD, *(_section(path, command) for path, command in commands(root, "omote"))])


def commands(command: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Every command that does something, by the words that call it."""
    subcommands = getattr(command, "commands", None)
    if subcommands is None:
        yield path, command
        return
    for name, each in subcommands.items():
        yield from commands(each, f"{path} {name}")


def _section(path: str, command: Any) -> str:
    rows = [_row(parameter) for parameter in command.params if parameter.name != "help"]
    table = ["| argument or option | what it is | without it |", "|---|---|---|", *rows, ""] if rows else []
    return "\n".join([f"## `{path}`\n", str(command.help), "", *table])


def _row(parameter: Any) -> str:
    if parameter.param_type_name == "argument":
        name = f"`{(parameter.metavar or parameter.name).upper()}`"
    else:
        name = ", ".join(f"`{option}`" for option in [*parameter.opts, *parameter.secondary_opts])
    text = (getattr(parameter, "help", None) or "").replace("|", "\\|")
    return f"| {name} | {text} | {_default(parameter)} |"


def _default(parameter: Any) -> str:
    if parameter.required:
        return "must be given"
    default = parameter.default
    if isinstance(default, bool):
        options = parameter.opts if default else parameter.secondary_opts
        return f"`{options[0]}`" if options else "off"
    return f"`{default}`" if isinstance(default, str | int | float) and default != "" else ""
