"""A corrupt show file is kept, and everything of it that is proved goes on."""

import os
import shutil
import sqlite3
from pathlib import Path

import pytest

from omote.showfile.backup import good_path, keep_good_copy
from omote.showfile.changes import Draft, Edit, PutContent, PutDraft, PutEdit, PutItem, PutLayout, PutRevision, Stored
from omote.showfile.contents import content_key
from omote.showfile.integrity import prove
from omote.showfile.recovery import finish, is_lost, rescue_show, salvage
from omote.showfile.schema import SCHEMA_VERSION, CorruptShowFileError, ShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show
from tests.showfile.ledger import item, revision

STATE = JournalEntry(1234, 5.0, b"state")


def save(show: ShowFile, number: int) -> None:
    """An item, its save and a draft of it."""
    data = bytes([number]) * 9000
    key = content_key(data)
    show.apply(
        [
            PutContent(key, data),
            PutItem(item(number, head=1)),
            PutRevision(revision(number, 1, content=key, recipe=b"{}" * 500)),
            PutDraft(Draft(number, "ada", 1, 1)),
            *(PutEdit(Edit(number, "ada", step, b"{}" * 300, "dragged")) for step in range(2)),
            PutLayout(f"page {number}", b"{}"),
        ]
    )


def filled(path: Path, *, copied: int, saves: int) -> ShowFile:
    """An open show file with so many saves, the first of which its good copy holds."""
    show = open_show(path)
    for number in range(1, saves + 1):
        save(show, number)
        if number == copied:
            keep_good_copy(show)
    show.write_journal(STATE)
    return show


def killed(show: ShowFile, folder: Path) -> Path:
    """The files of an open show as a killed server leaves them, elsewhere."""
    folder.mkdir()
    for file in show.path.parent.glob(f"{show.path.name}*"):
        if not file.name.endswith("-shm"):
            shutil.copyfile(file, folder / file.name)
    return folder / show.path.name


def held(path: Path) -> tuple[Stored, dict[str, bytes], JournalEntry]:
    """All that a show file holds."""
    prove(path)
    show = open_show(path)
    everything = (show.stored(), show.contents(), show.journal())
    show.close()
    return everything


@pytest.fixture
def whole(tmp_path: Path) -> Path:
    """A closed show file with five saves; its good copy has two of them."""
    show = filled(tmp_path / "a.omote", copied=2, saves=5)
    show.close()
    return show.path


def test_all_of_a_whole_file_is_salvaged_and_it_is_not_touched(whole: Path) -> None:
    before = whole.read_bytes()
    found = salvage(whole)
    assert (found.stored, found.contents, found.journal) == held(whole)
    assert whole.read_bytes() == before


def test_what_lies_in_the_log_is_salvaged_too(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote", copied=0, saves=3)
    path = killed(show, tmp_path / "killed")
    before = {file.name: file.read_bytes() for file in path.parent.iterdir()}
    assert "a.omote-wal" in before
    found = salvage(path)
    assert (found.stored, found.contents, found.journal) == (show.stored(), show.contents(), STATE)
    assert {file.name: file.read_bytes() for file in path.parent.iterdir()} == before
    show.close()


def test_a_file_without_its_first_page_is_read_by_that_of_its_good_copy(whole: Path) -> None:
    everything = held(whole)
    with whole.open("r+b") as file:
        file.write(bytes(4096))
    found = salvage(whole)
    assert (found.stored, found.contents, found.journal) == everything
    rescue = rescue_show(whole)
    assert held(whole) == everything
    assert rescue.copied == pytest.approx(good_path(whole).stat().st_mtime)
    assert rescue.newer > 0
    assert rescue.kept == whole.with_name("a.omote.corrupt-1")


def test_without_its_first_page_and_a_good_copy_nothing_is_left_but_the_file(whole: Path) -> None:
    good_path(whole).unlink()
    damaged = bytes(4096) + whole.read_bytes()[4096:]
    whole.write_bytes(damaged)
    rescue = rescue_show(whole)
    assert (rescue.copied, rescue.newer) == (None, 0)
    assert rescue.kept is not None
    assert rescue.kept.read_bytes() == damaged
    assert held(whole) == (Stored(), {}, JournalEntry(0, 0.0, None))


@pytest.mark.parametrize("copied", [0, 2])
def test_a_damaged_content_costs_only_its_revision(whole: Path, copied: int) -> None:
    if not copied:
        good_path(whole).unlink()
    stored, contents, journal = held(whole)
    data = bytearray(whole.read_bytes())
    at = data.index(bytes([4]) * 1000)
    data[at : at + 100] = b"\xa5" * 100
    whole.write_bytes(data)
    with pytest.raises(CorruptShowFileError, match=r"its content \w+ is damaged"):
        open_show(whole)
    rescue_show(whole)
    lost = stored.revisions[3]
    now, its_contents, its_journal = held(whole)
    assert set(now.revisions) == set(stored.revisions) - {lost}
    assert its_contents.keys() == contents.keys() - {lost.content}
    assert (now.drafts, now.edits, now.layouts, its_journal) == (
        stored.drafts,
        stored.edits,
        stored.layouts,
        journal,
    )
    assert [found.head for found in now.items] == [1, 1, 1, 0, 1]


def test_a_good_copy_that_is_bad_is_kept_too(whole: Path) -> None:
    good_path(whole).write_bytes(b"bad" * 3000)
    with whole.open("r+b") as file:
        file.write(bytes(4096))
    rescue = rescue_show(whole)
    assert rescue.copied is None
    assert good_path(whole).with_name("a.omote.good.corrupt-1").read_bytes() == b"bad" * 3000
    assert held(whole)[0] == Stored()


def test_a_good_copy_of_a_newer_omote_is_not_taken_and_nothing_is_touched(whole: Path) -> None:
    with sqlite3.connect(good_path(whole)) as connection:
        connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION + 1}")
    connection.close()
    whole.write_bytes(b"corrupt" * 1000)
    before = {file.name: file.read_bytes() for file in whole.parent.iterdir()}
    with pytest.raises(ShowFileError, match="newer Omote"):
        rescue_show(whole)
    assert {file.name: file.read_bytes() for file in whole.parent.iterdir()} == before


@pytest.mark.parametrize("content", [None, b""])
def test_a_lost_file_comes_back_from_its_good_copy(whole: Path, content: bytes | None) -> None:
    assert not is_lost(whole)
    whole.unlink()
    if content is not None:
        whole.write_bytes(content)
    assert is_lost(whole)
    rescue = rescue_show(whole)
    assert (rescue.kept is None) == (content is None)
    assert len(held(whole)[0].revisions) == 2
    assert not is_lost(whole)


def test_a_new_file_is_not_lost(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    assert not is_lost(path)
    path.write_bytes(b"")
    assert not is_lost(path)
    path.with_name("a.omote-wal").write_bytes(b"log")
    assert is_lost(path)


@pytest.mark.parametrize("renames", range(1, 5))
def test_a_rescue_cut_off_between_two_renames_is_finished_by_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, renames: int
) -> None:
    show = filled(tmp_path / "a.omote", copied=2, saves=3)
    show.flush()
    show.write_journal(STATE)  # all else has left the log
    everything = (show.stored(), show.contents(), show.journal())
    path = killed(show, tmp_path / "killed")
    show.close()
    with path.open("r+b") as file:
        file.write(bytes(4096))
    damaged = path.read_bytes()
    cut_after(monkeypatch, renames)
    with pytest.raises(KeyboardInterrupt):
        rescue_show(path)
    monkeypatch.undo()
    finish(path)
    try:
        open_show(path).close()
    except CorruptShowFileError:
        rescue_show(path)
    assert held(path) == everything
    assert [kept.read_bytes() for kept in path.parent.glob("*.corrupt-?")] == [damaged]
    assert not list(path.parent.glob("*.rescued*"))


def cut_after(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    """Lets so many renames pass, then the power goes."""
    left = [count]

    def counted(name: str) -> None:
        real = getattr(os, name)

        def renamed(*paths: object, **options: object) -> None:
            left[0] -= 1
            real(*paths, **options)
            if left[0] == 0:
                raise KeyboardInterrupt

        monkeypatch.setattr(os, name, renamed)

    counted("rename")
    counted("replace")
