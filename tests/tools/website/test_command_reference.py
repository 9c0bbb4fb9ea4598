"""The reference of the commands has each command with each of its options."""

from __future__ import annotations

import typer

from omote.cli import app
from tools.website.command_reference import command_page, commands


def test_every_command_and_option_is_there() -> None:
    page = command_page()
    found = dict(commands(typer.main.get_command(app), "omote"))
    assert {"omote show", "omote file import", "omote grid"} <= found.keys()
    assert [path for path in found if f"## `{path}`" not in page] == []
    options = {option for command in found.values() for parameter in command.params for option in parameter.opts}
    assert [option for option in options if option.startswith("--") and f"`{option}`" not in page] == ["--help"][:0]


def test_what_must_be_given_and_what_is_usual_is_said() -> None:
    page = command_page()
    assert "| `--output`, `-o` | The picture to write: .png, .jpg. | must be given |" in page
    assert "| `--port` | The port to listen on; 0 for any. | `8090` |" in page
