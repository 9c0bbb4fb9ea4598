"""The SQLite schema of a show file and its migrations; files of newer versions are rejected."""

from __future__ import annotations

import sqlite3
from pathlib import Path

from omote.showfile.authored_rows import EARLIER_TABLES, put_row, read_earlier_documents
from omote.showfile.database_errors import DamageError

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
# Foreign keys are checked at the end of the transaction, so changes may come in any order. `sum` is the row's checksum
# (showfile.authored_rows): SQLite has none for the database file itself.
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
# The same tables: from here on recipes and contents of faces may carry gains, and expressions turns of ears and head,
# which an older Omote could not read.
_GAINS = ""
# Which show this is, from its beginning: pages that kept something of another one at the same address are told apart.
_IDENTITY = """
CREATE TABLE identity (
    slot INTEGER PRIMARY KEY CHECK (slot = 1),
    id TEXT NOT NULL
) STRICT;
INSERT INTO identity VALUES (1, lower(hex(randomblob(16))));
"""
# What controls of devices play, as JSON: one document, for it changes as a whole.
_BINDINGS = """
CREATE TABLE binding_list (
    slot INTEGER PRIMARY KEY CHECK (slot = 1),
    document BLOB NOT NULL,
    sum TEXT NOT NULL
) STRICT;
"""
# How the landmarks of a performer's face are read, as JSON: a guided minute before a camera.
_PERFORMERS = """
CREATE TABLE performer (
    name TEXT PRIMARY KEY,
    document BLOB NOT NULL,
    sum TEXT NOT NULL
) STRICT;
"""
# The same tables: from here on contents of faces may carry a picture of the skin, which an older Omote could
# not read.
_ALBEDOS = ""
# Stored nouns of every kind, as JSON: a new kind needs no table. What three tables held before moves into it.
_DOCUMENTS = """
CREATE TABLE document (
    kind TEXT NOT NULL,
    name TEXT NOT NULL,
    body BLOB NOT NULL,
    sum TEXT NOT NULL,
    PRIMARY KEY (kind, name)
) STRICT;
"""
# Items may be poses too. The constraint is changed in the schema's text, as SQLite advises for what changes no row: a
# table made anew would have to take the rows of all tables along that refer to it.
_POSES = """
PRAGMA writable_schema = ON;
UPDATE sqlite_schema SET sql = replace(sql, '(''expression'', ''face'')', '(''expression'', ''face'', ''pose'')')
    WHERE type = 'table' AND name = 'item';
PRAGMA writable_schema = RESET;
"""
MIGRATIONS = (_JOURNAL, _AUTHORED, _GAINS, _IDENTITY, _BINDINGS, _PERFORMERS, _ALBEDOS, _DOCUMENTS, _POSES)
"""Statements that migrate version n to n + 1; never changed once released."""
SCHEMA_VERSION = len(MIGRATIONS)
DOCUMENTS_SINCE = 8
"""The first schema with one table of documents."""
AUTHORED_SINCE = 2
"""The first schema with authored work."""


class ShowFileError(RuntimeError):
    """The show file cannot be used; the message says why. The file is untouched."""


class CorruptShowFileError(ShowFileError):
    """The file is not a readable show file."""


def version_of(connection: sqlite3.Connection, path: Path) -> int:
    """The version of a file's schema, 0 for a blank file; ShowFileError for what this Omote must not touch.

    connection: to the file; path: where it lies, for the message.
    """
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
        raise DamageError(f"its schema {version} was written by no Omote")
    return int(version)


def _move_documents(connection: sqlite3.Connection) -> None:
    """Moves what earlier tables hold into the one of documents."""
    for document in list(read_earlier_documents(connection)):
        put_row(connection, document)
    for table in EARLIER_TABLES:
        connection.execute(f"DROP TABLE {table}")


def migrate(connection: sqlite3.Connection, version: int) -> None:
    """Brings a file up to the newest schema, tables and documents, in one transaction.

    connection: the open file; version: of its schema, 0 for a blank file. DamageError where its tables are not those of
    the version, or a document of before is not what was written; sqlite3.OperationalError where it cannot be written.
    """
    if version == SCHEMA_VERSION:
        return
    steps = "".join(MIGRATIONS[version:])
    try:
        connection.executescript(
            f"BEGIN IMMEDIATE; PRAGMA application_id = {APPLICATION_ID}; PRAGMA user_version = {SCHEMA_VERSION};{steps}"
        )
        if version < DOCUMENTS_SINCE:
            _move_documents(connection)
        connection.commit()
        if version == 0:
            connection.execute("VACUUM")  # leaves no pages behind of tables that a new file never had
    except sqlite3.DatabaseError as error:
        connection.rollback()
        if "no such" in str(error) or "already exists" in str(error):  # its tables are not those of its version
            raise DamageError("its tables are not those of its version") from error
        raise
