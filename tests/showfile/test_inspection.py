"""A show file is looked into without being touched, and what is wrong in it is named."""

import shutil
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import msgspec
import numpy as np
import pytest

from omote.model.cast import Look
from omote.model.recipes.recipe import FaceRecipe, Layer, Recipe
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import Change, Content, Draft, Edit, StoredDocument, content_key
from omote.showfile.contents import pack_expression, pack_face
from omote.showfile.inspection import inspect_show, item_named, revisions_of, verdicts
from omote.showfile.schema import APPLICATION_ID, MIGRATIONS, ShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show
from tests.showfile.authored_work import item, revision

SMILE = pack_expression(Expression(np.ones(3), np.zeros(3), np.ones(3), np.zeros((0, 3))))
KEY = content_key(SMILE)
FACE_KEY = ""
RECIPE = msgspec.json.encode(Recipe((1,), ((0.0, 0.0, 1.0),), layers=(Layer(f"#{KEY}", "Smile"),)))
WHOLE: list[Change] = [
    Content(KEY, SMILE),
    item(1, head=2),
    revision(1, 1, content=KEY, recipe=RECIPE),
    revision(1, 2, content=KEY, recipe=RECIPE),
    Draft(1, "ada", 2, 0),
    Edit(1, "ada", 0, RECIPE, "opened"),
]


@pytest.fixture
def show(tmp_path: Path) -> Iterator[ShowFile]:
    """An open show with an expression of two revisions."""
    opened = open_show(tmp_path / "a.omote")
    opened.apply(WHOLE)
    opened.write_journal(JournalEntry(1234, 5.0, b"state"))
    yield opened
    opened.close()


def bad(path: Path) -> list[str]:
    """What is said to be wrong."""
    return [sentence for right, sentence in verdicts(path) if not right]


def test_an_open_show_is_read_as_it_is_committed(show: ShowFile) -> None:
    found = inspect_show(show.path)
    assert (found.epoch, found.stored, found.contents) == (1234, show.stored(), show.contents())
    assert bad(show.path) == []
    back_up(show)
    said = " ".join(sentence for _, sentence in verdicts(show.path))
    assert "1 own expressions, 2 revisions" in said
    assert "a.omote.good is whole" in said


def test_a_closed_file_is_left_as_it_was(show: ShowFile) -> None:
    show.close()
    before = show.path.read_bytes()
    assert bad(show.path) == []
    assert show.path.read_bytes() == before
    assert [file.name for file in show.path.parent.iterdir()] == ["a.omote"]


def test_a_file_of_the_first_version_has_a_state_and_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "old.omote"
    connection = sqlite3.connect(path)
    connection.executescript(f"PRAGMA application_id = {APPLICATION_ID}; PRAGMA user_version = 1; {MIGRATIONS[0]}")
    connection.execute("INSERT INTO journal VALUES (1, 77, 5.5, x'01')")
    connection.commit()
    connection.close()
    found = inspect_show(path)
    assert (found.version, found.epoch, found.stored.items) == (1, 77, ())
    assert bad(path) == []


def test_a_file_that_is_not_there_is_not_made(tmp_path: Path) -> None:
    with pytest.raises(ShowFileError, match=r"there is no show file .*a\.omote; omote show .*a\.omote makes one"):
        inspect_show(tmp_path / "a.omote")
    assert bad(tmp_path / "a.omote")
    assert [*tmp_path.iterdir()] == []


def test_an_item_is_found_by_its_name_and_kind(show: ShowFile) -> None:
    face = pack_face(Face("a", np.eye(3)), Look())
    key = content_key(face)
    face_recipe = msgspec.json.encode(FaceRecipe({"generic": 1.0}))
    show.apply(
        [
            Content(key, face),
            item(2, kind="face", name="own-1", head=1),
            revision(2, 1, content=key, recipe=face_recipe),
        ]
    )
    stored = show.stored()
    assert item_named(stored, "own-1", "face").id == 2
    assert [found.number for found in revisions_of(stored, item_named(stored, "own-1", "expression"))] == [1, 2]
    with pytest.raises(ShowFileError, match="say which with --kind"):
        item_named(stored, "own-1")
    with pytest.raises(ShowFileError, match="no own face or expression 'smirk'; there are: own-1"):
        item_named(stored, "smirk")
    assert item_named(stored, "OWN 1", "face").id == 2
    assert bad(show.path) == []


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (revision(1, 3, content=KEY, recipe=b"{"), "the recipe of revision 3 of own-1 cannot be read"),
        (
            Edit(1, "ada", 1, RECIPE.replace(KEY.encode(), b"f" * 24), ""),
            f"step 1 of the draft of own-1 by ada names #{'f' * 24}, which is not there",
        ),
        (Draft(1, "ada", 2, 7), "the draft of own-1 by ada shows step 7; it has [0]"),
        (Edit(1, "ada", 5, RECIPE, ""), "it has [0, 5]"),
    ],
)
def test_what_does_not_belong_together_is_named(show: ShowFile, change: Change, sentence: str) -> None:
    show.apply([change])
    (said,) = bad(show.path)
    assert sentence in said


def test_a_revision_of_what_is_no_content_or_another_kind_is_named(show: ShowFile) -> None:
    other = content_key(b"nothing")
    show.apply([Content(other, b"nothing"), revision(1, 3, content=other, recipe=RECIPE)])
    face = pack_face(Face("a", np.eye(3)), Look())
    show.apply(
        [
            Content(content_key(face), face),
            revision(1, 4, content=content_key(face), recipe=RECIPE),
        ]
    )
    first, second = bad(show.path)
    assert "revision 3 of own-1: these 7 bytes do not begin as a content does" in first
    assert second == "revision 4 of own-1 makes no expression, but a different kind: face"


def test_a_corrupt_file_and_what_lies_beside_it_is_named(show: ShowFile) -> None:
    back_up(show)
    show.apply([StoredDocument("layout", "console", b"{}")])
    show.close()
    with sqlite3.connect(show.path) as connection:
        connection.execute("UPDATE document SET body = x'00'")
    connection.close()
    shutil.copyfile(show.path, show.path.with_name("a.omote.corrupt-1"))
    said = list(verdicts(show.path))
    assert [right for right, _ in said] == [False, False, True, True]
    assert "document layout, console is damaged" in said[0][1]
    assert "for whoever repairs it: its document layout, console is damaged" in said[1][1]
    assert "a.omote.corrupt-1" in said[3][1]
    backup_paths(show.path)[0].write_bytes(b"bad" * 3000)
    assert "its good copy is none" in bad(show.path)[2]
    backup_paths(show.path)[1].write_bytes(b"")
    assert "a.omote.good-1 is empty" in bad(show.path)[3]
