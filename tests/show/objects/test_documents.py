"""A kind of stored noun is one class: all that the house does with documents it does with a kind of this test alone."""

import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import closing
from pathlib import Path
from typing import ClassVar

import pytest

from omote.edit.session.console_requests import change_documents
from omote.edit.store.authored_state import AuthoredState
from omote.show.access.access_role import AccessRole
from omote.show.objects.documents import (
    KINDS,
    NAMES_OF,
    READ_ROUTES,
    Document,
    declared_kinds,
    messages_of,
    names_in,
    read_document,
)
from omote.show.validation import Refusal
from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import Change, DocumentRemoval, Stored, StoredDocument
from omote.showfile.inspection import inspect_show, verdicts
from omote.showfile.schema import CorruptShowFileError
from omote.showfile.show_file import ShowFile, open_show


@pytest.fixture
def pose() -> Iterator[type[Document]]:
    """A kind that no module of Omote knows."""

    class Pose(Document, frozen=True):
        """Who stands how."""

        kind: ClassVar[str] = "pose"
        read_by: ClassVar[AccessRole | None] = "view"
        written_by: ClassVar[AccessRole | None] = "operate"
        most: ClassVar[int] = 2

        face: str
        lean: float = 0.0

        def names(self) -> Iterable[str]:
            return (self.face,)

    yield Pose
    del KINDS["pose"]


@pytest.fixture
def show(tmp_path: Path) -> Iterator[ShowFile]:
    """A new show file."""
    opened = open_show(tmp_path / "a.omote")
    yield opened
    opened.close()


def test_a_document_is_put_listed_renamed_and_dropped_as_the_state_has_it(show: ShowFile, pose: type[Document]) -> None:
    state = AuthoredState(Stored())
    body = pose(face="ann").encode()
    steps: list[tuple[list[Change], dict[str, dict[str, bytes]]]] = [
        ([StoredDocument("pose", "bow", body)], {"pose": {"bow": body}}),
        ([DocumentRemoval("pose", "bow"), StoredDocument("pose", "low", body)], {"pose": {"low": body}}),
        ([DocumentRemoval("pose", "low"), DocumentRemoval("pose", "never there")], {}),
    ]
    for changes, expected in steps:
        show.apply(changes)
        state.apply(changes)
        assert show.stored().documents == state.stored().documents == expected


def test_a_document_is_on_the_disk_in_the_copies_and_proved_by_its_sum(show: ShowFile, pose: type[Document]) -> None:
    stored = StoredDocument("pose", "bow", pose(face="ann").encode())
    show.apply([stored])
    back_up(show)
    assert inspect_show(show.path).stored.documents == {"pose": {"bow": stored.body}}
    assert inspect_show(backup_paths(show.path)[0]).stored.documents == {"pose": {"bow": stored.body}}
    assert "documents: 1 of kind pose" in [sentence for right, sentence in verdicts(show.path) if right]
    show.close()
    with closing(sqlite3.connect(show.path)) as connection, connection:
        connection.execute("UPDATE document SET name = 'row'")
    with pytest.raises(CorruptShowFileError, match="its document pose, row is damaged"):
        inspect_show(show.path)


def test_a_document_is_read_by_its_schema_and_says_whom_it_names(pose: type[Document]) -> None:
    body = pose(face="ann").encode()
    assert declared_kinds()["pose"] is pose
    assert read_document(pose, body).names() == ("ann",)
    with pytest.raises(ValueError, match="this is no pose"):
        read_document(pose, b'{"lean":1.0}')
    assert names_in("pose", body, ["ann", "face"]) == ["ann"]
    assert names_in("pose", b'{"of": "annabel"}', ["ann"]) == ["ann"], "what cannot be read is looked through"
    assert names_in("of no Omote yet", b"ann", ["ann", "bo"]) == ["ann"]


def test_its_messages_set_rename_and_drop_it_under_its_role(pose: type[Document]) -> None:
    setting, renaming, dropping, names = messages_of(pose)
    try:
        assert [made.__struct_config__.tag for made in (setting, renaming, dropping, names)] == [
            "set_pose", "rename_pose", "drop_pose", "poses"
        ]  # fmt: skip
        assert {made.access for made in (setting, renaming, dropping)} == {pose.written_by}
        assert "Takes a pose out of the show file" in (dropping.__doc__ or "")
        assert NAMES_OF["pose"](["bow"]).names == ["bow"]
        assert READ_ROUTES["/poses/{name}"] == "view"
    finally:
        del NAMES_OF["pose"], READ_ROUTES["/poses/{name}"]
    body = pose(face="ann").encode()
    put = StoredDocument("pose", "bow", body)
    assert change_documents({}, setting("bow", body.decode())) == (put,)
    moved = (DocumentRemoval("pose", "bow"), StoredDocument("pose", "low", body))
    assert change_documents({"bow": body}, renaming("bow", "low")) == moved
    assert change_documents({"bow": body}, dropping("bow")) == (DocumentRemoval("pose", "bow"),)
    for asked, why in ((setting("bow", "{}"), "this is no pose"), (dropping("row"), "there is no pose 'row' any more")):
        with pytest.raises(Refusal, match=why):
            change_documents({"bow": body}, asked)
    with pytest.raises(Refusal, match="there are 2 poses already"):
        change_documents({"a": body, "b": body}, setting("c", body.decode()))


def test_every_kind_of_the_house_is_declared() -> None:
    assert {"layout", "bindings", "performer"} <= declared_kinds().keys()
