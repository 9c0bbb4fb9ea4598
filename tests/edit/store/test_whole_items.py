"""Items of one show file, whole, in another: the same bytes of each, clashes told, nothing replaced."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import closing
from pathlib import Path

import msgspec
import numpy as np
import pytest

from omote.edit.protocol.wire import write_recipe
from omote.edit.store.whole_items import merge_show, whole_item
from omote.model.albedo import SIDES, Albedo
from omote.model.cast import Cast, Look
from omote.model.recipes.recipe import KEY, FaceRecipe, GainRow
from omote.show.validation import Refusal
from omote.showfile.changes import Change, Content, Draft, Edit, Item, Revision, Stored, StoredDocument, content_key
from omote.showfile.contents import pack_face
from omote.showfile.inspection import Inspection, inspect_show
from omote.showfile.show_file import open_show, write_new_show
from tests.showfile.authored_work import item, revision


def written(path: Path, changes: Iterable[Change]) -> Inspection:
    """A show file that holds changes, as it is read."""
    with closing(open_show(path)) as show:
        show.apply(changes)
    return inspect_show(path)


def faces(cast: Cast) -> Iterator[Change]:
    """A face with a picture on its skin, two revisions and a draft, made of a shape that no item plays; a second one,
    and an expression of its name."""
    first = next(iter(cast.faces.values()))
    pixels = np.zeros((SIDES[0], SIDES[0], 4), np.uint8)
    pixels[100:200, 50:70] = 10, 200, 30, 255
    albedo = Albedo(pixels)
    looks = [Look(), Look(hair="#102030", albedo=albedo), Look(iris="#334455")]
    contents = [pack_face(first, look) for look in looks]
    keys = [content_key(content) for content in contents]
    yield from (Content(key, content) for key, content in zip(keys, contents, strict=True))
    recipe = write_recipe(FaceRecipe({KEY + keys[0]: 1.0}, gains=(GainRow("mouth", 1.5, "wry"),)))
    yield item(4, kind="face", name="aunt", label="Aunt Ö.", tags=("old",), head=2, place=7.0)
    yield revision(4, 1, content=keys[0], recipe=recipe, note="the first")
    yield revision(4, 2, content=keys[1], recipe=recipe, editor="Bo", written=17.25)
    yield Draft(4, "Ada", 2, 0)
    yield Edit(4, "Ada", 0, write_recipe(FaceRecipe({KEY + keys[2]: 1.0})), "another")
    yield item(5, kind="face", name="uncle", label="Uncle", head=1)
    yield revision(5, 1, content=keys[2], recipe=recipe)
    yield item(6, name="wry", label="Wry", deleted=True)
    yield StoredDocument("layout", "wide", b'{"a":1}')


def rows_of(stored: Stored, name: str) -> list[object]:
    """All rows of an item without its number and its place among others."""
    (found,) = [each for each in stored.items if each.name == name]
    rows: tuple[Revision | Draft | Edit, ...] = (*stored.revisions, *stored.drafts, *stored.edits)
    mine = [msgspec.structs.replace(row, item=0) for row in rows if row.item == found.id]
    return [msgspec.structs.replace(found, id=0, place=0.0), *mine]


def test_a_new_show_file_is_synced_with_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    synced = list[tuple[int, bool]]()
    real = os.fsync

    def sync(file: int) -> None:
        synced.append((os.fstat(file).st_ino, (tmp_path / "a.omote").exists()))
        real(file)

    monkeypatch.setattr(os, "fsync", sync)
    write_new_show(tmp_path / "a.omote", [])
    assert (tmp_path.stat().st_ino, True) in synced


def test_an_item_leaves_whole_and_comes_in_with_the_same_bytes(cast: Cast, tmp_path: Path) -> None:
    theirs = written(tmp_path / "theirs.omote", faces(cast))
    aunt = theirs.stored.items[0]
    write_new_show(tmp_path / "aunt.omote", whole_item(theirs.stored, theirs.contents, aunt))
    alone = inspect_show(tmp_path / "aunt.omote")
    assert [each.name for each in alone.stored.items] == ["aunt"]
    assert alone.contents == theirs.contents, "its draft is made of the third"
    ours = written(tmp_path / "ours.omote", [item(9, name="mine", place=40.0)])
    merged = merge_show(cast, ours.stored, alone.stored, alone.contents)
    assert (merged.labels, merged.notes) == (["Aunt Ö."], [])
    after = written(tmp_path / "ours.omote", merged.changes)
    assert rows_of(after.stored, "aunt") == rows_of(theirs.stored, "aunt")
    assert rows_of(after.stored, "mine") == rows_of(ours.stored, "mine")
    assert after.contents == theirs.contents
    again = merge_show(cast, after.stored, alone.stored, alone.contents)
    assert again.changes == []
    assert again.notes == ["'Aunt Ö.' is there already, with the same history, as aunt (Aunt Ö.)"]


def test_a_whole_show_comes_into_an_empty_one_as_it_is(cast: Cast, tmp_path: Path) -> None:
    theirs = written(tmp_path / "theirs.omote", faces(cast))
    merged = merge_show(cast, Stored(), theirs.stored, theirs.contents)
    assert merged.notes == []
    after = written(tmp_path / "ours.omote", merged.changes)
    for name in ("aunt", "uncle", "wry"):
        assert rows_of(after.stored, name) == rows_of(theirs.stored, name)
    assert (after.contents, after.stored.documents) == (theirs.contents, theirs.stored.documents)


def test_what_is_taken_here_gets_another_name_and_nothing_is_replaced(cast: Cast, tmp_path: Path) -> None:
    theirs = written(tmp_path / "theirs.omote", faces(cast))
    built_in = next(iter(cast.faces))
    here: list[Change] = [
        item(1, kind="face", name="aunt", label="Aunt Ö."),
        item(2, kind="face", name="oncle", label="uncle"),
        item(3, name="wry", label="Wry"),
        StoredDocument("layout", "wide", b'{"a":2}'),
    ]
    ours = written(tmp_path / "ours.omote", here)
    merged = merge_show(cast, ours.stored, theirs.stored, theirs.contents)
    assert merged.notes == [
        "another face is named aunt here: 'Aunt Ö.' is aunt_o (Aunt Ö. 2)",
        "there is a 'Uncle' already, so uncle is called 'Uncle 2'",
        "another expression is named wry here: 'Wry' is wry_2 (Wry)",
        "the face 'Aunt Ö.' has a gain for wry, which is wry_2 here: set it anew",
        "the face 'Uncle' has a gain for wry, which is wry_2 here: set it anew",
        "the layout 'wide' is another one here, and stays; rename it and import again to have both",
    ]
    after = written(tmp_path / "ours.omote", merged.changes)
    for kept in ours.stored.items:
        assert kept in after.stored.items
    assert after.stored.documents == ours.stored.documents
    strange = Stored(items=(Item(1, "face", built_in, "Mine"), Item(2, "face", "../x", "Odd")))
    names = [change.name for change in merge_show(cast, Stored(), strange, {}).changes if isinstance(change, Item)]
    assert names == ["mine", "odd"]


@pytest.mark.parametrize("label", ["", "a\x1b[31m", "x" * 81])
def test_labels_that_nobody_can_read_are_refused(cast: Cast, label: str) -> None:
    with pytest.raises(Refusal):
        merge_show(cast, Stored(), Stored(items=(Item(1, "face", "x", label),)), {})
