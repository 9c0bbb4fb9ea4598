"""How every command speaks to people at a terminal: sentences beside what programs read, errors in words, status 1.

Names come from files of strangers, so no character of theirs controls the terminal.
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import typer

MOST_JOBS = 64
INTERRUPTED = 130
"""The exit status of a command that was stopped by Ctrl-C."""


def escape_controls(text: str) -> str:
    """Escapes control characters: names in untrusted files must not control the terminal."""
    return "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode() for character in text
    )


def read_count(text: str | int) -> int:
    """How many browsers draw at once, as it is typed."""
    digits = str(text).strip()
    if not digits.isascii() or not digits.isdecimal() or not 1 <= int(digits[:9]) <= MOST_JOBS:
        raise typer.BadParameter(f"{digits!r} is no number of browsers; give one from 1 to {MOST_JOBS}")
    return int(digits)


def complete_name(path: Path, ending: str) -> Path:
    """The path of a file to be written, with this ending where a person left the ending out."""
    return path if path.suffix or path.exists() else path.with_name(path.name + ending)


def complete_show(path: Path | None) -> Path | None:
    """The path of a show file to be read or written, with `.omote` where a person left it out; None for none."""
    if path is None:
        return None
    from omote.showfile.recovery import name_show

    with exit_on_refusal():
        return name_show(path)


@contextlib.contextmanager
def exit_on_refusal() -> Iterator[None]:
    """Turns errors of files and browsers into an error message and exit status 1, and Ctrl-C into a word and 130."""
    import sqlite3

    from omote.server.headless.devtools import BrowserError
    from omote.server.persistence.lock import ShowLockedError
    from omote.showfile.schema import ShowFileError

    try:
        yield
    except (ShowFileError, ShowLockedError, BrowserError, OSError, ValueError, OverflowError, sqlite3.Error) as error:
        fail_with(error)
    except KeyboardInterrupt:
        say("stopped.")
        raise typer.Exit(INTERRUPTED) from None


def say(sentence: str) -> None:
    """Prints a sentence beside what programs read; names in untrusted files do not control the terminal."""
    typer.echo(f"omote: {escape_controls(sentence)}", err=True)


def fail_with(error: Exception) -> NoReturn:
    """Ends the command with what an error means, in words."""
    from omote.showfile.database_errors import describe_error

    fail(describe_error(error))


def fail(sentence: str) -> NoReturn:
    """Ends the command with an error message and exit status 1."""
    say(sentence)
    raise typer.Exit(1)


def has_screen() -> bool:
    """Whether there is a screen on which a browser can open."""
    return sys.platform == "darwin" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
