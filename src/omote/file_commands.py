"""`omote file ...`: what is in a show file; these commands read only, also while a show plays it."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

ShowFileArgument = Annotated[Path, typer.Argument(help="The show file (.omote).")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print it for programs.")]

file_app = typer.Typer(help="Looks into show files.", no_args_is_help=True)


@file_app.command("list")
def list_items(file: ShowFileArgument, json: JsonOption = False) -> None:
    """Lists the own faces and expressions of a show file."""
    from omote.files.inspection import inspect_show

    with refusals():
        stored = inspect_show(file).stored
    rows = [
        {
            "kind": item.kind,
            "name": item.name,
            "label": item.label,
            "revision": item.head,
            "revisions": sum(revision.item == item.id for revision in stored.revisions),
            "drafts": sum(draft.item == item.id for draft in stored.drafts),
            "tags": " ".join(item.tags),
            "deleted": item.deleted,
        }
        for item in sorted(stored.items, key=lambda item: (item.kind, item.place, item.id))
    ]
    show_rows(rows, json=json, none=f"{file} has no own faces or expressions yet.")


@file_app.command()
def check(file: ShowFileArgument) -> None:
    """Says what is in a show file, and whether all of it is right."""
    from omote.files.inspection import verdicts

    good = True
    for right, sentence in verdicts(file):
        good = good and right
        typer.echo(f"{'good' if right else 'BAD '}  {sentence}")
    if not good:
        typer.echo(f"omote: {file} is not all right; omote show {file} opens its newest good state.", err=True)
        raise typer.Exit(1)


@file_app.command()
def history(
    file: ShowFileArgument,
    name: Annotated[str, typer.Argument(help="The name of an own face or expression (omote file list).")],
    kind: Annotated[
        Literal["expression", "face"] | None, typer.Option(help="Which, where both have this name.")
    ] = None,
    json: JsonOption = False,
) -> None:
    """Lists the revisions of an own face or expression, oldest first."""
    from omote.files.inspection import inspect_show, item_named, revisions_of

    with refusals():
        stored = inspect_show(file).stored
        item = item_named(stored, name, kind)
    rows = [
        {
            "revision": revision.number,
            "of": revision.parent,
            "written": moment(revision.written),
            "by": revision.editor,
            "note": revision.note,
            "state": "plays" if revision.number == item.head else "aside" if revision.aside else "",
            "content": revision.content,
        }
        for revision in revisions_of(stored, item)
    ]
    show_rows(rows, json=json, none=f"{name} has never been saved.")


def moment(seconds: float) -> str:
    """A time of the calendar (seconds since 1970) as people write it here; "?" for one that no clock shows."""
    try:
        return time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(seconds))
    except (OverflowError, ValueError, OSError):
        return "?"


@contextlib.contextmanager
def refusals() -> Iterator[None]:
    """Ends the command with a sentence and exit status 1 where a show file refuses."""
    import sqlite3

    from omote.files.schema import ShowFileError

    try:
        yield
    except (ShowFileError, OSError, sqlite3.Error) as error:
        typer.echo(f"omote: {error}", err=True)
        raise typer.Exit(1) from error


def show_rows(rows: list[dict[str, Any]], *, json: bool, none: str) -> None:
    """Rows as a table, or as JSON; a sentence where there are none."""
    if json:
        import msgspec

        typer.echo(msgspec.json.format(msgspec.json.encode(rows), indent=2).decode())
        return
    if not rows:
        typer.echo(none)
        return
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(*rows[0], box=None, pad_edge=False)
    for row in rows:
        table.add_row(*(Text("yes" if value is True else str(value or "")) for value in row.values()))
    Console(soft_wrap=False).print(table)
