"""Writes the reference of the show file as Markdown, from the tables that SQLite makes of its schema."""

from __future__ import annotations

import sqlite3
from contextlib import closing

from omote.showfile.schema import APPLICATION_ID, SCHEMA_VERSION, migrate

PURPOSES = {
    "journal": "The show as it was last: one row, from which a server that was killed goes on.",
    "journal_aside": "Snapshots that a later server could not play, kept with the reason.",
    "content": "What recipes make (positions, fields), by the key of the content; written once.",
    "item": "An own face or expression: its name for ever, what people read, and the revision that plays.",
    "revision": "Every save, never changed and never removed.",
    "draft": "One editor's unsaved work at an item.",
    "edit": "Its steps, which undo and redo walk.",
    "identity": "Which show this is: one row, made at random with the file.",
    "document": "Stored nouns of every kind (layouts, bindings, performers), as JSON by kind and name.",
}
HEAD = f"""# The show file

Written from the tables of the schema by `tools/website/file_reference.py`.

A show file (`.omote`) is a SQLite database: application id `0x{APPLICATION_ID:X}`, schema version {SCHEMA_VERSION}
(`user_version`). An older version is brought to the newest when it is opened; a newer one is left untouched and
rejected with an error message. `sum` is the checksum of a row. Read it with any SQLite tool; write it with
`omote file` only. Beside `NAME.omote` lie its write-ahead log (`-wal`, `-shm`) while a show plays it, a lock and
complete earlier copies; [recover a show](../howto/recover-a-show.md) says what to do with them.
"""


def file_page() -> str:
    """The page: each table with its columns."""
    with closing(sqlite3.connect(":memory:")) as made:
        migrate(made, 0)
        names = [name for (name,) in made.execute("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY rowid")]
        return "\n".join([HEAD, *(_table(made, name) for name in names)])


def _table(made: sqlite3.Connection, name: str) -> str:
    rows = made.execute('SELECT name, type, "notnull", pk FROM pragma_table_xinfo(?)', (name,))
    columns = [
        f"| `{column}` | {kind.lower()} | {'key' if key else 'always' if required else 'may be missing'} |"
        for column, kind, required, key in rows
    ]
    return "\n".join([f"## `{name}`\n", PURPOSES[name], "", "| column | type | |", "|---|---|---|", *columns, ""])
