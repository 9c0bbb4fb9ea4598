"""Writes and reads authored work as rows of the show file: in one transaction, each row with a checksum.

SQLite proves its log, not what lies in the file. So every row carries the sum of its own columns, and contents are
named by the hash of their bytes: a row that is not what was written is known.
"""

from __future__ import annotations

import contextlib
import hashlib
import sqlite3
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import msgspec

from omote.showfile.changes import (
    Change,
    Content,
    ContentRemoval,
    DocumentRemoval,
    Documents,
    Draft,
    Edit,
    Item,
    Revision,
    Stored,
    StoredDocument,
    content_key,
)
from omote.showfile.database_errors import DamageError, WrongRowError

Row = Item | Revision | Draft | Edit | StoredDocument


@dataclass(frozen=True)
class Table:
    """A table of the rows of one struct; key: the columns that tell them apart."""

    name: str
    type: type[msgspec.Struct]
    key: tuple[str, ...]

    @property
    def columns(self) -> tuple[str, ...]:
        """The columns that a row's sum is of."""
        return self.type.__struct_fields__


ITEMS = Table("item", Item, ("id",))
REVISIONS = Table("revision", Revision, ("item", "number"))
DRAFTS = Table("draft", Draft, ("item", "editor"))
EDITS = Table("edit", Edit, ("item", "editor", "number"))
DOCUMENTS = Table("document", StoredDocument, ("kind", "name"))
TABLES = (ITEMS, REVISIONS, DRAFTS, EDITS, DOCUMENTS)
TABLE_OF = {table.type: table for table in TABLES}
EARLIER_TABLES = {
    "layout": ("layout", "name"),
    "binding_list": ("bindings", "'bindings'"),
    "performer": ("performer", "name"),
}
"""Tables up to schema 7, each of one kind of document: the kind, and where its name is."""


def apply_changes(connection: sqlite3.Connection, changes: Iterable[Change]) -> None:
    """Commits the changes in one transaction; on an error none of them is made.

    sqlite3.IntegrityError: they can never be made (a revision that is there and is another, a content that is missing);
    sqlite3.OperationalError: not now (a full disk, a lock).

    connection: to the show file; changes: in any order.
    """
    connection.execute("BEGIN IMMEDIATE")
    try:
        for change in changes:
            _make(connection, change)
        connection.execute("COMMIT")
    except BaseException:
        if connection.in_transaction:
            connection.rollback()
        raise


def read_all(connection: sqlite3.Connection) -> Stored:
    """All authored rows, each proved by its sum; sqlite3.DatabaseError names the first that is not what was written."""
    earlier = _tables_of(connection) & EARLIER_TABLES.keys()
    documents: Documents = {}
    for document in read_earlier_documents(connection) if earlier else _proved_rows(connection, DOCUMENTS):
        documents.setdefault(document.kind, {})[document.name] = document.body
    return Stored(
        items=tuple(_proved_rows(connection, ITEMS)),
        revisions=tuple(_proved_rows(connection, REVISIONS)),
        drafts=tuple(_proved_rows(connection, DRAFTS)),
        edits=tuple(_proved_rows(connection, EDITS)),
        documents=documents,
    )


def read_earlier_documents(connection: sqlite3.Connection) -> Iterator[StoredDocument]:
    """The documents of a file up to schema 7, each proved by its sum; sqlite3.DatabaseError as of `read_all`."""
    for table in EARLIER_TABLES.keys() & _tables_of(connection):
        kind, name = EARLIER_TABLES[table]
        for row_name, *row in connection.execute(f"SELECT {name}, * FROM {table} ORDER BY 2"):
            if row_checksum(row[:-1]) != row[-1]:
                raise DamageError(f"its {table} {row[0]} is damaged")
            yield StoredDocument(kind, row_name, row[1])


def _tables_of(connection: sqlite3.Connection) -> set[str]:
    return {name for (name,) in connection.execute("SELECT name FROM sqlite_schema WHERE type = 'table'")}


def read_contents(connection: sqlite3.Connection) -> Iterator[tuple[str, bytes]]:
    """Every content, proved by its key; sqlite3.DatabaseError names the first that is not what was written."""
    for key, data in connection.execute("SELECT key, data FROM content ORDER BY key"):
        yield key, _prove_content(key, data)


def _prove_content(key: str, data: object) -> bytes:
    if not isinstance(data, bytes) or content_key(data) != key:
        raise DamageError(f"its content {key} is damaged")
    return data


def row_checksum(values: Sequence[Any]) -> str:
    """The checksum of a row's columns as SQLite returns them: 16 hexadecimal digits."""
    return hashlib.blake2b(msgspec.msgpack.encode(values), digest_size=8).hexdigest()


def _rows(connection: sqlite3.Connection, table: Table, where: str = "", *values: int) -> sqlite3.Cursor:
    columns = ", ".join((*table.columns, "sum"))
    key = ", ".join(table.key)
    return connection.execute(f"SELECT {columns} FROM {table.name} {where} ORDER BY {key}", values)


def _proved_rows(connection: sqlite3.Connection, table: Table) -> Iterator[Any]:
    return (_prove_row(table, row) for row in _rows(connection, table))


def _prove_row(table: Table, columns: Sequence[Any]) -> Any:
    """The struct of columns and their sum; sqlite3.DatabaseError where they are not what was written."""
    *values, sealed = columns
    with contextlib.suppress(msgspec.MsgspecError, RecursionError):  # another program knows our sums
        if row_checksum(values) == sealed:
            return _row(table, values)
    place = ", ".join(map(str, columns[: len(table.key)]))
    raise DamageError(f"its {table.name} {place} is damaged")


def _row(table: Table, values: Sequence[Any]) -> Any:
    document = dict(zip(table.columns, values, strict=True))
    for flag in {"deleted", "aside"} & document.keys():
        document[flag] = bool(document[flag])
    if table is ITEMS:
        document["tags"] = msgspec.json.decode(document["tags"])
    return msgspec.convert(document, table.type)


def _make(connection: sqlite3.Connection, change: Change) -> None:
    match change:
        case Content(key, data):
            connection.execute("INSERT INTO content VALUES (?, ?) ON CONFLICT DO NOTHING", (key, data))
        case ContentRemoval(key):
            connection.execute("DELETE FROM content WHERE key = ?", (key,))
        case DocumentRemoval(kind, name):
            connection.execute("DELETE FROM document WHERE kind = ? AND name = ?", (kind, name))
        case Revision():
            _add_revision(connection, change)
        case Edit():
            after = "DELETE FROM edit WHERE item = ? AND editor = ? AND number >= ?"
            connection.execute(after, (change.item, change.editor, change.number))
            put_row(connection, change)
        case _:
            put_row(connection, change)


def _add_revision(connection: sqlite3.Connection, revision: Revision) -> None:
    """Adds it; the very same there already: a change that is made again, and nothing to do."""
    row = _rows(connection, REVISIONS, "WHERE item = ? AND number = ?", revision.item, revision.number).fetchone()
    if row is None:
        put_row(connection, revision)
    elif _prove_row(REVISIONS, row) != revision:
        raise WrongRowError(
            f"revision {revision.number} of item {revision.item} is there and is another; revisions are never changed"
        )


def put_row(connection: sqlite3.Connection, row: Row) -> None:
    """Adds or replaces a row; ValueError where its columns would not return the same values.

    connection: to the show file; row: of any table.
    """
    table = TABLE_OF[type(row)]
    checked = msgspec.convert(msgspec.structs.asdict(row), table.type)
    columns = (*table.columns, "sum")
    values = [_column(getattr(checked, name)) for name in table.columns]
    changed = ", ".join(f"{name} = excluded.{name}" for name in columns if name not in table.key)
    connection.execute(
        f"INSERT INTO {table.name} ({', '.join(columns)}) VALUES ({', '.join('?' * len(columns))}) "
        f"ON CONFLICT ({', '.join(table.key)}) DO UPDATE SET {changed}",
        (*values, row_checksum(values)),
    )


def _column(value: Any) -> Any:
    """A field as SQLite keeps it and gives it back."""
    if isinstance(value, tuple):
        return msgspec.json.encode(value).decode()
    if isinstance(value, float):
        return value + 0.0  # it knows no -0.0
    return int(value) if isinstance(value, bool) else value
