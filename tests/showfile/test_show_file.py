"""The show file keeps the last state, and never loses or overwrites what it cannot read."""

import os
import shutil
import sqlite3
import stat
from contextlib import closing
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from omote.showfile import show_file
from omote.showfile.changes import StoredDocument
from omote.showfile.recovery import move_aside
from omote.showfile.schema import APPLICATION_ID, SCHEMA_VERSION
from omote.showfile.show_file import (
    ASIDE_LIMIT,
    CorruptShowFileError,
    JournalEntry,
    ShowFileError,
    default_path,
    open_show,
)


def test_a_new_file_has_no_state(tmp_path: Path) -> None:
    show = open_show(tmp_path / "new" / "a.omote")
    assert show.journal() == JournalEntry(epoch=0, written=0.0, snapshot=None)
    show.close()


@given(epoch=st.integers(1, 2**53), written=st.floats(0, 1e9), snapshot=st.binary(max_size=500))
@settings(
    max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
)
def test_the_journal_comes_back_as_it_was(tmp_path: Path, epoch: int, written: float, snapshot: bytes) -> None:
    entry = JournalEntry(epoch, written, snapshot)
    show = open_show(tmp_path / "a.omote")
    show.write_journal(JournalEntry(1, 0.0, b"older"))
    show.write_journal(entry)
    show.close()
    again = open_show(tmp_path / "a.omote")
    assert again.journal() == entry
    again.close()


def test_a_commit_is_seen_by_the_next_server_without_a_close(tmp_path: Path) -> None:
    first = open_show(tmp_path / "a.omote")
    first.write_journal(JournalEntry(7, 1.0, b"state"))
    second = open_show(tmp_path / "a.omote")  # the first was killed: nothing closed, nothing merged
    assert second.journal().snapshot == b"state"
    first.close()
    second.close()


def test_the_file_does_not_grow_with_the_length_of_the_show(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    show = open_show(path)
    for number in range(3000):
        show.write_journal(JournalEntry(1, number * 0.05, bytes(2000)))
    total = sum(file.stat().st_size for file in tmp_path.iterdir())
    show.close()
    assert total < 8_000_000


def test_the_header_names_the_application_and_the_schema(tmp_path: Path) -> None:
    open_show(tmp_path / "a.omote").close()
    connection = sqlite3.connect(tmp_path / "a.omote")
    assert connection.execute("PRAGMA application_id").fetchone() == (APPLICATION_ID,)
    assert connection.execute("PRAGMA user_version").fetchone() == (SCHEMA_VERSION,)
    assert connection.execute("PRAGMA journal_mode").fetchone() == ("wal",)
    connection.close()


def test_a_show_is_known_again_and_told_from_every_other_one(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    known = set[str]()
    for _ in range(2):
        with closing(open_show(path)) as show:
            known.add(show.identity())
    assert len(known) == 1
    shutil.copy(path, tmp_path / "copy.omote")
    with closing(open_show(tmp_path / "copy.omote")) as copied:
        known.add(copied.identity())
    path.unlink()
    with closing(open_show(path)) as anew:
        known.add(anew.identity())
    assert len(known) == 3


def test_a_file_of_a_newer_version_is_refused_untouched(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    open_show(path).close()
    connection = sqlite3.connect(path)
    connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION + 1}")
    connection.close()
    before = path.read_bytes()
    with pytest.raises(ShowFileError, match=rf"newer Omote \(schema {SCHEMA_VERSION + 1}, this one"):
        open_show(path)
    assert path.read_bytes() == before


def test_a_database_of_others_is_refused_untouched(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    connection = sqlite3.connect(path)
    connection.execute("CREATE TABLE theirs (x)")
    connection.close()
    before = path.read_bytes()
    with pytest.raises(ShowFileError, match="is a database of another program, not a show; it stays as it is"):
        open_show(path)
    assert path.read_bytes() == before


@pytest.mark.parametrize("start", range(0, 20_000, 1500))
def test_a_damaged_file_opens_or_is_refused_and_is_never_changed_into_a_blank_one(tmp_path: Path, start: int) -> None:
    path = tmp_path / "a.omote"
    show = open_show(path)
    show.write_journal(JournalEntry(7, 1.0, b"state" * 500))
    show.close()
    damaged = bytearray(path.read_bytes())
    damaged[start : start + 1500] = b"\xa5" * len(damaged[start : start + 1500])
    path.write_bytes(damaged)
    try:
        opened = open_show(path)
    except ShowFileError:
        assert path.read_bytes() == bytes(damaged)
    else:
        assert opened.journal().epoch in (0, 7)
        opened.close()


def test_corrupt_files_are_kept_one_beside_the_other(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    open_show(path).close()
    header = path.read_bytes()[:100]
    for content in (b"first", b"second"):
        path.write_bytes(header + content * 1000)
        with pytest.raises(CorruptShowFileError, match="is damaged"):
            open_show(path)
        move_aside(path)
    assert (tmp_path / "a.omote.corrupt-1").read_bytes() == header + b"first" * 1000
    assert (tmp_path / "a.omote.corrupt-2").read_bytes() == header + b"second" * 1000
    assert not path.exists()


def test_snapshots_set_aside_are_kept_and_bounded(tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    for epoch in range(1, ASIDE_LIMIT + 5):
        entry = JournalEntry(epoch, 0.0, b"poison")
        show.write_journal(entry)
        show.set_aside(entry, "it crashed three servers")
        assert show.journal() == JournalEntry(epoch, 0.0, None)
    show.close()
    connection = sqlite3.connect(tmp_path / "a.omote")
    kept = connection.execute("SELECT count(*), max(epoch) FROM journal_aside").fetchone()
    assert kept == (ASIDE_LIMIT, ASIDE_LIMIT + 4)
    connection.close()


def test_a_folder_that_cannot_be_made_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(ShowFileError, match="cannot be opened"):
        open_show(tmp_path / "file" / "a.omote")


def test_without_a_file_the_journal_lives_in_the_state_directory() -> None:
    assert default_path({"XDG_STATE_HOME": "/state"}) == Path("/state/omote/show.omote")
    assert default_path({}) == Path.home() / ".local/state/omote/show.omote"


@pytest.mark.parametrize(
    "tables", ["", "CREATE TABLE journal (a)", "CREATE TABLE journal (slot, epoch, written, snapshot)"]
)
def test_a_show_file_without_its_tables_is_corrupt(tmp_path: Path, tables: str) -> None:
    open_show(tmp_path / "a.omote").close()
    with sqlite3.connect(tmp_path / "a.omote") as connection:
        connection.executescript(f"DROP TABLE journal; DROP TABLE journal_aside; {tables}")
    connection.close()
    with pytest.raises(CorruptShowFileError, match=r"a\.omote is damaged: its tables are not those of"):
        open_show(tmp_path / "a.omote")


@pytest.mark.parametrize("epoch", [-1, 2**53 + 1, 2**63 - 1])
def test_an_epoch_that_no_server_wrote_is_not_believed(tmp_path: Path, epoch: int) -> None:
    show = open_show(tmp_path / "a.omote")
    show.write_journal(JournalEntry(epoch, 0.0, b"state"))
    with pytest.raises(sqlite3.DatabaseError, match=f"epoch {epoch}"):
        show.journal()
    show.close()


def test_a_flush_with_nothing_new_makes_no_checkpoint(tmp_path: Path) -> None:
    """A checkpoint that has nothing to do can lose the commit that begins the log anew (SQLite before 3.51.3)."""
    show = open_show(tmp_path / "a.omote")
    flusher = show.again()
    made: list[str] = []
    flusher._connection.set_trace_callback(lambda sql: made.append(sql) if "checkpoint" in sql else None)
    show.write_journal(JournalEntry(1, 0.0, b"state"))
    for _ in range(3):
        flusher.flush()
    assert len(made) == 1
    show.write_journal(JournalEntry(2, 0.0, b"state"))
    flusher.flush()
    assert len(made) == 2
    flusher.close()
    show.close()


def test_what_was_committed_is_in_the_log_that_is_synced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    synced = list[bytes]()
    monkeypatch.setattr(show_file, "_sync", lambda log: synced.append(os.pread(log, 1 << 20, 0)))
    show = open_show(tmp_path / "a.omote")
    show.write_journal(JournalEntry(1, 0.0, b"what is on air"))
    show.sync_log()
    assert b"what is on air" in synced[0]
    (tmp_path / "a.omote-wal").rename(tmp_path / "moved")
    show.sync_log()
    assert len(synced) == 1
    (tmp_path / "moved").rename(tmp_path / "a.omote-wal")
    show.close()


def test_authored_work_is_synced_at_once_and_the_journal_is_not(tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    said: list[str] = []
    show._connection.set_trace_callback(said.append)
    show.apply([StoredDocument("layout", "console", b"{}")])
    order = [said.index(f"PRAGMA synchronous = {level}") for level in ("FULL", "NORMAL")]
    assert order[0] < said.index("COMMIT") < order[1]
    assert show._connection.execute("PRAGMA synchronous").fetchone() == (1,)
    show.close()


def test_a_state_that_is_no_number_is_not_believed(tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    show._connection.execute("DROP TABLE journal")
    show._connection.execute("CREATE TABLE journal (epoch, written, snapshot, sum)")
    show._connection.execute("INSERT INTO journal VALUES (NULL, 0, NULL, NULL)")
    with pytest.raises(sqlite3.DatabaseError, match="epoch None"):
        show.journal()
    show.close()


def test_its_owner_alone_may_read_a_new_show_and_its_copies_unless_it_is_shared(tmp_path: Path) -> None:
    before = os.umask(0)
    try:
        path = tmp_path / "a.omote"
        show = open_show(path)
        show.copy_into(tmp_path / "copy")
        path.chmod(0o640)
        show.copy_into(tmp_path / "shared")
        modes = [stat.S_IMODE(each.stat().st_mode) for each in (tmp_path / "copy", tmp_path / "shared")]
        log = stat.S_IMODE(show.place.log_path.stat().st_mode)
        show.close()
    finally:
        os.umask(before)
    assert (log, *modes) == (0o600, 0o600, 0o640)
