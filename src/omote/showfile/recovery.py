"""What becomes of a corrupt show file: it is kept, and the newest good state takes its place.

That is the good copy beside it, and over it every row of the corrupt file that is proved by its own sum
(`files.authored`). It is written whole under another name before anything is renamed, so that a rescue that is cut off
is finished, or begun again, by the next start.
"""

from __future__ import annotations

import shutil
import sqlite3
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from omote.showfile.authored_rows import TABLES, Table, as_stored, is_content, row_checksum, row_of, selection
from omote.showfile.backup import good_path, put_in_place, remove
from omote.showfile.changes import Change, Stored
from omote.showfile.merging import changes_since
from omote.showfile.schema import CorruptShowFileError
from omote.showfile.show_file import HIGHEST_EPOCH, JournalEntry, ShowFile, move_aside, open_show

PAGE_SIZE_AT, SIZE_AT = 16, 28
"""Where the first page says how large pages are, and how many there are; zero: as many as the file has (SQLite's file
format, 1.3)."""


@dataclass(frozen=True)
class Salvage:
    """What could be read of a corrupt file, every row proved."""

    stored: Stored = field(default_factory=Stored)
    contents: dict[str, bytes] = field(default_factory=dict)
    journal: JournalEntry | None = None


@dataclass(frozen=True)
class Rescue:
    """How a show file was rescued.

    kept: where the corrupt file lies now, None where there was none; copied: when its good copy was made (seconds since
    1970), None where there was no good one; newer: how many changes of the corrupt file were made after that.
    """

    kept: Path | None
    copied: float | None
    newer: int


def is_lost(path: Path, /) -> bool:
    """Whether a show file is missing or empty that was more before: its good copy or its log are there."""
    if path.exists() and path.stat().st_size > 0:
        return False
    log = path.with_name(path.name + "-wal")
    return good_path(path).exists() or (path.exists() and log.exists() and log.stat().st_size > 0)


def finish(path: Path, /) -> None:
    """Finishes a rescue that was cut off after the corrupt file was moved aside."""
    rescued = path.with_name(path.name + ".rescued")
    if rescued.exists() and not path.exists():
        move_aside(path)  # a log that was left behind would be taken for the new file's
        put_in_place(rescued, path)


def rescue_show(path: Path, /) -> Rescue:
    """Puts the newest good state in the place of a corrupt or lost show file, which is kept.

    ShowFileError where the good copy is of a newer Omote, sqlite3.Error and OSError where the disk fails: all is as it
    was, or `finish` and another call do the rest.
    """
    found = salvage(path)
    draft, rescued = (path.with_name(path.name + suffix) for suffix in (".rescued-new", ".rescued"))
    remove(draft)
    try:
        show, copied = _from_good_copy(path, draft)
        try:
            newer = _add_newer(show, found)
        finally:
            show.close()
        put_in_place(draft, rescued)
    finally:
        remove(draft)
    kept = move_aside(path)
    put_in_place(rescued, path)
    return Rescue(kept, copied, newer)


def salvage(path: Path, /) -> Salvage:
    """Every row of a corrupt show file that can be read and is proved; the file and its log are not touched."""
    best = Salvage()
    if not path.exists():
        return best
    for graft in (None, good_path(path)):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "copy"
            shutil.copyfile(path, copy)
            log = path.with_name(path.name + "-wal")
            if log.exists():
                shutil.copyfile(log, copy.with_name("copy-wal"))
            if graft is not None and not _graft_first_page(copy, graft):
                break
            best = max(best, _salvage_copy(copy), key=_amount)
    return best


def _graft_first_page(copy: Path, good: Path) -> bool:
    """Gives a file its good copy's first page, which says where all tables begin: they are of one descent."""
    if not good.exists():
        return False
    with good.open("rb") as file:
        head = file.read(PAGE_SIZE_AT + 2)
        first = head + file.read(int.from_bytes(head[PAGE_SIZE_AT:], "big") - len(head))
    with copy.open("r+b") as file:
        if file.read(len(first)) == first:
            return False
        file.seek(0)
        file.write(first[:SIZE_AT] + bytes(4) + first[SIZE_AT + 4 :])
    return True


def _amount(found: Salvage) -> int:
    stored = found.stored
    rows = (stored.items, stored.revisions, stored.drafts, stored.edits, stored.layouts, found.contents)
    return sum(map(len, rows)) + (found.journal is not None)


def _salvage_copy(copy: Path) -> Salvage:
    connection = sqlite3.connect(copy)
    try:
        # Text that is no text fails its sum instead of ending the reading.
        connection.text_factory = lambda data: data.decode("utf-8", "replace")
        connection.execute("PRAGMA writable_schema = ON")  # reads on although the file is shorter than its header says
        rows = {table.name: [*_proved_rows(connection, table)] for table in TABLES}
        contents = _readable(connection, "content", "SELECT key, data FROM content")
        journal = _readable(connection, "journal", "SELECT epoch, written, snapshot, sum FROM journal")
        return Salvage(
            as_stored(rows),
            {key: data for key, data in contents if is_content(key, data)},
            next((JournalEntry(*row[:3]) for row in journal if _is_state(row)), None),
        )
    except sqlite3.Error:
        return Salvage()
    finally:
        connection.close()


def _is_state(row: Sequence[Any]) -> bool:
    epoch, _, snapshot, sealed = row
    return bool(row_checksum([epoch, snapshot]) == sealed and 0 <= epoch <= HIGHEST_EPOCH)


def _proved_rows(connection: sqlite3.Connection, table: Table) -> Iterator[Any]:
    for columns in _readable(connection, table.name, selection(table)):
        row = row_of(table, columns)
        if row is not None:
            yield row


def _readable(connection: sqlite3.Connection, table: str, select: str) -> Iterator[tuple[Any, ...]]:
    """The rows that can be read one by one; their numbers come from both ends, up to what is broken."""
    for number in sorted({*_numbers(connection, table, "ASC"), *_numbers(connection, table, "DESC")}):
        try:
            row = connection.execute(f"{select} WHERE rowid = ?", (number,)).fetchone()
        except sqlite3.Error:
            continue
        if row is not None:
            yield row


def _numbers(connection: sqlite3.Connection, table: str, order: str) -> Iterator[int]:
    try:
        for (number,) in connection.execute(f"SELECT rowid FROM {table} NOT INDEXED ORDER BY rowid {order}"):
            yield number
    except sqlite3.Error:
        return


def _from_good_copy(path: Path, draft: Path) -> tuple[ShowFile, float | None]:
    """A new file that holds the good copy, and when that was made; an empty one where there is no good one."""
    good = good_path(path)
    if not good.exists():
        return open_show(draft), None
    shutil.copyfile(good, draft)
    try:
        return open_show(draft), good.stat().st_mtime
    except CorruptShowFileError:
        remove(draft)
        move_aside(good)  # a later good copy would take its place
        return open_show(draft), None


def _add_newer(show: ShowFile, found: Salvage) -> int:
    """Adds to a good copy what is newer; how many changes that took."""
    changes: list[Change] = changes_since(show.stored(), show.contents().keys(), found.stored, found.contents)
    try:
        show.apply(changes)
    except (sqlite3.IntegrityError, ValueError):  # rows that are proved, and do not belong together: the copy is whole
        changes = []
    if found.journal is not None and found.journal.epoch >= show.journal().epoch:
        show.write_journal(found.journal)
    return len(changes)
