"""Writes and reads authored work as rows of the show file: in one transaction, each row with a checksum.

SQLite proves its log, not what lies in the file. So every row carries the sum of its own columns, and contents are
named by the hash of their bytes: a row that is not what was written is known.
"""

from __future__ import annotations

import contextlib
import hashlib
import sqlite3
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import msgspec

from omote.showfile.changes import (
    Change,
    Draft,
    DropDraft,
    DropLayout,
    DropPerformer,
    Edit,
    Item,
    PutBindings,
    PutContent,
    PutDraft,
    PutEdit,
    PutItem,
    PutLayout,
    PutPerformer,
    PutRevision,
    Revision,
    Stored,
    content_key,
)
from omote.showfile.database_errors import DamageError, WrongRowError


class Layout(msgspec.Struct, frozen=True):
    """A page's document by name."""

    name: str
    document: bytes


class PerformerDocument(msgspec.Struct, frozen=True):
    """How the landmarks of a performer's face are read, by the performer's name."""

    name: str
    document: bytes


class BindingDocuments(msgspec.Struct, frozen=True):
    """What controls of devices play: one row."""

    slot: int
    document: bytes


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
LAYOUTS = Table("layout", Layout, ("name",))
BINDINGS = Table("binding_list", BindingDocuments, ("slot",))
PERFORMERS = Table("performer", PerformerDocument, ("name",))
TABLES = (ITEMS, REVISIONS, DRAFTS, EDITS, LAYOUTS, BINDINGS, PERFORMERS)
ADDED_LATER = (BINDINGS, PERFORMERS)
"""Tables that a file of an older Omote, which is read as it is, may not have yet."""


def apply_changes(connection: sqlite3.Connection, changes: Iterable[Change]) -> None:
    """Commits the changes in one transaction; on an error none of them is made.

    sqlite3.IntegrityError: they can never be made (a revision that is there and is another, a content that is missing);
    sqlite3.OperationalError: not now (a full disk, a lock).
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
    there = {name for (name,) in connection.execute("SELECT name FROM sqlite_schema WHERE type = 'table'")}
    rows = {table.name: [_prove_row(table, row) for row in _rows_of(connection, table, there)] for table in TABLES}
    return Stored(
        items=tuple(rows["item"]),
        revisions=tuple(rows["revision"]),
        drafts=tuple(rows["draft"]),
        edits=tuple(rows["edit"]),
        layouts={layout.name: layout.document for layout in rows["layout"]},
        bindings=b"".join(each.document for each in rows["binding_list"]),
        performers={each.name: each.document for each in rows["performer"]},
    )


def read_contents(connection: sqlite3.Connection) -> Iterator[tuple[str, bytes]]:
    """Every content, proved by its key; sqlite3.DatabaseError names the first that is not what was written."""
    for key, data in connection.execute("SELECT key, data FROM content ORDER BY key"):
        yield key, _prove_content(key, data)


def read_content(connection: sqlite3.Connection, key: str) -> bytes:
    """One content, proved by its key; sqlite3.DatabaseError where it is missing or damaged."""
    row = connection.execute("SELECT data FROM content WHERE key = ?", (key,)).fetchone()
    return _prove_content(key, None if row is None else row[0])


def _prove_content(key: str, data: object) -> bytes:
    if not isinstance(data, bytes) or content_key(data) != key:
        raise DamageError(f"its content {key} is damaged")
    return data


def row_checksum(values: Sequence[Any]) -> str:
    """The checksum of a row's columns as SQLite returns them: 16 hexadecimal digits."""
    return hashlib.blake2b(msgspec.msgpack.encode(values), digest_size=8).hexdigest()


def _rows(connection: sqlite3.Connection, table: Table, where: str = "", *values: int) -> sqlite3.Cursor:
    columns, key = ", ".join((*table.columns, "sum")), ", ".join(table.key)
    return connection.execute(f"SELECT {columns} FROM {table.name} {where} ORDER BY {key}", values)


def _rows_of(connection: sqlite3.Connection, table: Table, there: Collection[str]) -> Iterable[Sequence[Any]]:
    """All rows of a table; none where the file has it not yet."""
    return () if table in ADDED_LATER and table.name not in there else _rows(connection, table)


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
        case PutContent(key, data):
            connection.execute("INSERT INTO content VALUES (?, ?) ON CONFLICT DO NOTHING", (key, data))
        case PutItem(item):
            _put(connection, ITEMS, item)
        case PutRevision(revision):
            _add_revision(connection, revision)
        case PutDraft(draft):
            _put(connection, DRAFTS, draft)
        case PutEdit(edit):
            after = "DELETE FROM edit WHERE item = ? AND editor = ? AND number >= ?"
            connection.execute(after, (edit.item, edit.editor, edit.number))
            _put(connection, EDITS, edit)
        case PutLayout() | PutBindings() | PutPerformer():
            _put_document(connection, change)
        case DropDraft() | DropLayout() | DropPerformer():
            _drop(connection, change)


def _put_document(connection: sqlite3.Connection, change: PutLayout | PutBindings | PutPerformer) -> None:
    if isinstance(change, PutLayout):
        _put(connection, LAYOUTS, Layout(change.name, change.document))
    elif isinstance(change, PutPerformer):
        _put(connection, PERFORMERS, PerformerDocument(change.name, change.document))
    else:
        _put(connection, BINDINGS, BindingDocuments(1, change.document))


def _drop(connection: sqlite3.Connection, change: DropDraft | DropLayout | DropPerformer) -> None:
    if isinstance(change, DropDraft):
        connection.execute("DELETE FROM draft WHERE item = ? AND editor = ?", (change.item, change.editor))
    elif isinstance(change, DropPerformer):
        connection.execute("DELETE FROM performer WHERE name = ?", (change.name,))
    else:
        connection.execute("DELETE FROM layout WHERE name = ?", (change.name,))


def _add_revision(connection: sqlite3.Connection, revision: Revision) -> None:
    """Adds it; the very same there already: a change that is made again, and nothing to do."""
    found = _rows(connection, REVISIONS, "WHERE item = ? AND number = ?", revision.item, revision.number).fetchone()
    if found is None:
        _put(connection, REVISIONS, revision)
    elif _prove_row(REVISIONS, found) != revision:
        raise WrongRowError(
            f"revision {revision.number} of item {revision.item} is there and is another; revisions are never changed"
        )


def _put(connection: sqlite3.Connection, table: Table, row: msgspec.Struct) -> None:
    """Adds or replaces a row; ValueError where its columns would not return the same values."""
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
