"""The tables of a show file, and how a file of an older version gets them; one of a newer version is refused."""

from __future__ import annotations

import sqlite3
from functools import cache
from pathlib import Path

APPLICATION_ID = 0x4F4D4F54  # "OMOT"
_JOURNAL = """
CREATE TABLE journal (
    slot INTEGER PRIMARY KEY CHECK (slot = 1),
    epoch INTEGER NOT NULL,
    written REAL NOT NULL,
    snapshot BLOB
) STRICT;
CREATE TABLE journal_aside (
    epoch INTEGER PRIMARY KEY,
    reason TEXT NOT NULL,
    snapshot BLOB NOT NULL
) STRICT;
"""
# Foreign keys wait for the end of the transaction, so changes may come in any order. `sum` is the row's checksum
# (files.authored): SQLite has none for what lies in the file itself.
_AUTHORED = """
ALTER TABLE journal ADD COLUMN sum TEXT;
CREATE TABLE content (
    key TEXT PRIMARY KEY,
    data BLOB NOT NULL
) STRICT;
CREATE TABLE item (
    id INTEGER PRIMARY KEY,
    kind TEXT NOT NULL CHECK (kind IN ('expression', 'face')),
    name TEXT NOT NULL,
    label TEXT NOT NULL,
    tags TEXT NOT NULL,
    place REAL NOT NULL,
    head INTEGER NOT NULL,
    deleted INTEGER NOT NULL CHECK (deleted IN (0, 1)),
    sum TEXT NOT NULL,
    plays INTEGER GENERATED ALWAYS AS (nullif(head, 0)) VIRTUAL,
    UNIQUE (kind, name),
    FOREIGN KEY (id, plays) REFERENCES revision (item, number) DEFERRABLE INITIALLY DEFERRED
) STRICT;
CREATE TABLE revision (
    item INTEGER NOT NULL REFERENCES item (id) DEFERRABLE INITIALLY DEFERRED,
    number INTEGER NOT NULL CHECK (number > 0),
    parent INTEGER NOT NULL,
    recipe BLOB NOT NULL,
    content TEXT NOT NULL REFERENCES content (key) DEFERRABLE INITIALLY DEFERRED,
    written REAL NOT NULL,
    editor TEXT NOT NULL,
    note TEXT NOT NULL,
    aside INTEGER NOT NULL CHECK (aside IN (0, 1)),
    sum TEXT NOT NULL,
    PRIMARY KEY (item, number)
) STRICT;
CREATE TABLE draft (
    item INTEGER NOT NULL REFERENCES item (id) DEFERRABLE INITIALLY DEFERRED,
    editor TEXT NOT NULL,
    base INTEGER NOT NULL,
    cursor INTEGER NOT NULL,
    sum TEXT NOT NULL,
    PRIMARY KEY (item, editor)
) STRICT;
CREATE TABLE edit (
    item INTEGER NOT NULL,
    editor TEXT NOT NULL,
    number INTEGER NOT NULL CHECK (number >= 0),
    recipe BLOB NOT NULL,
    what TEXT NOT NULL,
    sum TEXT NOT NULL,
    PRIMARY KEY (item, editor, number),
    FOREIGN KEY (item, editor) REFERENCES draft (item, editor) ON DELETE CASCADE DEFERRABLE INITIALLY DEFERRED
) STRICT;
CREATE TABLE layout (
    name TEXT PRIMARY KEY,
    document BLOB NOT NULL,
    sum TEXT NOT NULL
) STRICT;
CREATE TRIGGER revisions_are_not_changed BEFORE UPDATE ON revision
    BEGIN SELECT RAISE(ABORT, 'a revision is never changed'); END;
CREATE TRIGGER revisions_are_not_removed BEFORE DELETE ON revision
    BEGIN SELECT RAISE(ABORT, 'a revision is never removed'); END;
CREATE TRIGGER items_keep_their_name BEFORE UPDATE ON item WHEN new.name != old.name OR new.kind != old.kind
    BEGIN SELECT RAISE(ABORT, 'an item keeps its kind and its name for ever'); END;
"""
MIGRATIONS = (_JOURNAL, _AUTHORED)
"""What makes version n + 1 of version n; never changed once a release wrote it."""
SCHEMA_VERSION = len(MIGRATIONS)


class ShowFileError(RuntimeError):
    """The show file cannot be used, and why, in one sentence; the file is untouched."""


class CorruptShowFileError(ShowFileError):
    """The file is no readable show file."""


def version_of(connection: sqlite3.Connection, path: Path) -> int:
    """The version of a file's schema, 0 for a blank file; ShowFileError for what this Omote must not touch."""
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_schema").fetchone()
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if tables == 0 and application == 0 and version == 0:
        return 0
    if application != APPLICATION_ID:
        raise ShowFileError(f"{path} is a database, but not of Omote; name another file.")
    if version > SCHEMA_VERSION:
        raise ShowFileError(
            f"{path} was written by a newer Omote (schema {version}, this one reads up to {SCHEMA_VERSION}); "
            "update Omote."
        )
    if version < 1:
        raise sqlite3.DatabaseError(f"its schema {version} was written by no Omote")
    return int(version)


def migrate(connection: sqlite3.Connection, version: int) -> None:
    """Brings the tables from a version to the newest, all or nothing."""
    if version == SCHEMA_VERSION:
        return
    steps = "".join(MIGRATIONS[version:])
    try:
        connection.executescript(
            f"BEGIN IMMEDIATE; PRAGMA application_id = {APPLICATION_ID}; PRAGMA user_version = {SCHEMA_VERSION};"
            f"{steps} COMMIT;"
        )
    except sqlite3.OperationalError as error:
        connection.rollback()
        if "no such" in str(error) or "already exists" in str(error):  # its tables are not those of its version
            raise sqlite3.DatabaseError(str(error)) from error
        raise


def refuse_without_tables(connection: sqlite3.Connection) -> None:
    """sqlite3.DatabaseError where a table or a column is missing."""
    there = _columns(connection)
    for table, columns in _expected_columns().items():
        missing = columns - there.get(table, set())
        if missing:
            what = f"column: {table}.{min(missing)}" if table in there else f"table: {table}"
            raise sqlite3.DatabaseError(f"no such {what}")


@cache
def _expected_columns() -> dict[str, set[str]]:
    made = sqlite3.connect(":memory:")
    made.executescript("".join(MIGRATIONS))
    wanted = _columns(made)
    made.close()
    return wanted


def _columns(connection: sqlite3.Connection) -> dict[str, set[str]]:
    rows = connection.execute(
        "SELECT t.name, c.name FROM sqlite_schema AS t JOIN pragma_table_xinfo(t.name) AS c WHERE t.type = 'table'"
    )
    found: dict[str, set[str]] = {}
    for table, column in rows:
        found.setdefault(table, set()).add(column)
    return found
