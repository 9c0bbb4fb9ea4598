"""The authored work of a show file: opened as an edit session, or reported as unreadable."""

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from omote.model.cast import Cast
from omote.server.persistence.authored_work import open_authored_work
from omote.server.persistence.commit_thread import CommitOutcome
from omote.server.workers.order_worker import OrderWorker
from omote.showfile.changes import Change, Content, DocumentRemoval, Item, Revision, StoredDocument, content_key
from omote.showfile.contents import pack_expression
from omote.showfile.database_errors import DamageError
from omote.showfile.show_file import ShowFile, open_show


class FakeCommitter:
    """Keeps nothing."""

    def commit(self, changes: object, told: object) -> None:
        """Does not even listen."""

    def close(self) -> None:
        """Has nothing to close."""


def test_the_authored_work_is_what_the_file_has(cast: Cast, tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    data = pack_expression(cast.expressions["smile"])
    revision = Revision(1, 1, 0, b'{"kind":"expression","net":[],"vectors":[]}', content_key(data), 1.0, "Ada")
    item = Item(1, "expression", "grin", "Grin", place=1.0, head=1)
    show.apply((Content(content_key(data), data), item, revision, StoredDocument("layout", "desk", b"1")))
    said: list[str] = []
    authored_work = open_authored_work(show, FakeCommitter(), OrderWorker(cast), said.append)
    assert authored_work is not None
    assert [(own.name, own.label, own.content) for own in authored_work.session.own()] == [
        ("grin", "Grin", content_key(data))
    ]
    assert authored_work.session.contents[content_key(data)] == data
    assert (authored_work.documents("layout"), said) == ({"desk": b"1"}, [])
    assert authored_work.session.show == show.identity()
    show.close()


def test_work_that_cannot_be_read_does_not_stop_the_show(
    cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def damaged(self: ShowFile) -> None:
        raise DamageError("its item 1 is damaged")

    show = open_show(tmp_path / "a.omote")
    monkeypatch.setattr(ShowFile, "stored", damaged)
    said: list[str] = []
    assert open_authored_work(show, FakeCommitter(), OrderWorker(cast), said.append) is None
    assert "its item 1 is damaged); the show goes on without them" in said[0]
    show.close()


def test_performers_are_kept_and_dropped_together(cast: Cast, tmp_path: Path) -> None:
    class Refusing:
        def commit(self, changes: Sequence[Change], told: Callable[[CommitOutcome], None]) -> None:
            made.append(tuple(changes))
            told(CommitOutcome("refused", "the disk is full"))

        def close(self) -> None:
            pass

    made: list[tuple[Change, ...]] = []
    said: list[str] = []
    show = open_show(tmp_path / "a.omote")
    show.apply((StoredDocument("performer", "Ada", b"1"),))
    work = open_authored_work(show, Refusing(), OrderWorker(cast), said.append)
    assert work is not None
    assert work.documents("performer") == {"Ada": b"1"}
    work.keep_documents([DocumentRemoval("performer", "Ada"), StoredDocument("performer", "Bo", b"1")], said.append)
    assert work.documents("performer") == {"Bo": b"1"}
    assert made == [(DocumentRemoval("performer", "Ada"), StoredDocument("performer", "Bo", b"1"))]
    assert said == ["a change of performer documents is not kept: the disk is full"]
    show.close()
