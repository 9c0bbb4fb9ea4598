"""Authored work as rows of the show file: written in one transaction, each row with its checksum, read and proved.

SQLite proves its log, not what lies in the file. So every row carries the sum of its own columns, and contents are
named by the hash of their bytes: a row that is not what was written is known, and one that is can be rescued alone.
"""

from __future__ import annotations

import hashlib
import sqlite3
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import msgspec

from omote.showfile.changes import (
    Change,
    Draft,
    DropDraft,
    Edit,
    Item,
    PutContent,
    PutDraft,
    PutEdit,
    PutItem,
    PutLayout,
    PutRevision,
    Revision,
    Stored,
)
from omote.showfile.contents import content_key


class Layout(msgspec.Struct, frozen=True):
    """A page's document by name."""

    name: str
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
TABLES = (ITEMS, REVISIONS, DRAFTS, EDITS, LAYOUTS)


def apply_changes(connection: sqlite3.Connection, changes: Iterable[Change]) -> None:
    """Makes the changes in one transaction; returns when they are committed, raises with none of them made.

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
    return as_stored({table.name: [_prove_row(table, row) for row in _rows(connection, table)] for table in TABLES})


def read_contents(connection: sqlite3.Connection) -> Iterator[tuple[str, bytes]]:
    """Every content, proved by its key; sqlite3.DatabaseError names the first that is not what was written."""
    for key, data in connection.execute("SELECT key, data FROM content ORDER BY key"):
        if not is_content(key, data):
            raise sqlite3.DatabaseError(f"its content {key} is damaged")
        yield key, data


def is_content(key: object, data: object, /) -> bool:
    """Whether these are a content and its key; a damaged row can hold anything."""
    return isinstance(data, bytes) and content_key(data) == key


def refuse_damaged(connection: sqlite3.Connection) -> None:
    """sqlite3.DatabaseError where the last state or anything authored is not what was written, or belongs to
    nothing."""
    for (verdict,) in connection.execute("PRAGMA integrity_check(1)"):
        if verdict != "ok":
            raise sqlite3.DatabaseError(verdict.splitlines()[-1])  # SQLite's heading stands on a line above it
    stray = connection.execute("PRAGMA foreign_key_check").fetchone()
    if stray is not None:
        raise sqlite3.DatabaseError(f"row {stray[1]} of {stray[0]} belongs to no {stray[2]}")
    _refuse_damaged_state(connection)
    try:
        read_all(connection)
        for _ in read_contents(connection):
            pass
    except sqlite3.OperationalError as error:
        if "decode" in str(error):  # text that is no text
            raise sqlite3.DatabaseError(str(error)) from error
        raise


def _refuse_damaged_state(connection: sqlite3.Connection) -> None:
    for epoch, snapshot, sealed in connection.execute("SELECT epoch, snapshot, sum FROM journal"):
        if sealed is not None and row_checksum([epoch, snapshot]) != sealed:  # None: as the first schema left it
            raise sqlite3.DatabaseError("its last state is damaged")


def as_stored(rows: dict[str, list[Any]]) -> Stored:
    """Rows by table's name as one document."""
    return Stored(
        items=tuple(rows["item"]),
        revisions=tuple(rows["revision"]),
        drafts=tuple(rows["draft"]),
        edits=tuple(rows["edit"]),
        layouts={layout.name: layout.document for layout in rows["layout"]},
    )


def row_of(table: Table, columns: Sequence[Any]) -> Any | None:
    """The struct of columns and their sum; None where they are not what was written, or not by us."""
    *values, sealed = columns
    if row_checksum(values) != sealed:
        return None
    document = dict(zip(table.columns, values, strict=True))
    for flag in {"deleted", "aside"} & document.keys():
        document[flag] = bool(document[flag])
    try:
        if table is ITEMS:
            document["tags"] = msgspec.json.decode(document["tags"])
        return msgspec.convert(document, table.type)
    except (msgspec.MsgspecError, RecursionError):  # another program knows our sums
        return None


def row_checksum(values: Sequence[Any]) -> str:
    """The sum of a row's columns, as SQLite gives them back: 16 hexadecimal digits."""
    return hashlib.blake2b(msgspec.msgpack.encode(values), digest_size=8).hexdigest()


def selection(table: Table) -> str:
    """The SQL that reads a table's columns and sums."""
    return f"SELECT {', '.join((*table.columns, 'sum'))} FROM {table.name}"


def _rows(connection: sqlite3.Connection, table: Table) -> sqlite3.Cursor:
    return connection.execute(f"{selection(table)} ORDER BY {', '.join(table.key)}")


def _prove_row(table: Table, columns: Sequence[Any]) -> Any:
    row = row_of(table, columns)
    if row is None:
        place = ", ".join(map(str, columns[: len(table.key)]))
        raise sqlite3.DatabaseError(f"its {table.name} {place} is damaged")
    return row


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
        case DropDraft(item, editor):
            connection.execute("DELETE FROM draft WHERE item = ? AND editor = ?", (item, editor))
        case PutLayout(name, document):
            _put(connection, LAYOUTS, Layout(name, document))


def _add_revision(connection: sqlite3.Connection, revision: Revision) -> None:
    """Adds it; the very same there already: a change that is made again, and nothing to do."""
    found = connection.execute(
        f"{selection(REVISIONS)} WHERE item = ? AND number = ?", (revision.item, revision.number)
    ).fetchone()
    if found is None:
        _put(connection, REVISIONS, revision)
    elif _prove_row(REVISIONS, found) != revision:
        raise sqlite3.IntegrityError(
            f"revision {revision.number} of item {revision.item} is there and is another; revisions are never changed"
        )


def _put(connection: sqlite3.Connection, table: Table, row: msgspec.Struct) -> None:
    """Adds or replaces a row; ValueError where it holds what its columns would give back as something else."""
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
