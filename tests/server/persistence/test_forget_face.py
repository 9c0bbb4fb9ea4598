"""Own faces removed for good: no byte of them is left in the show file, its log and its good copies."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from omote.builtin import load_cast
from omote.cli import app
from omote.edit.protocol.wire import write_recipe
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.cast import Look
from omote.model.recipes.recipe import KEY, FaceRecipe
from omote.model.space.face import Face
from omote.server.persistence.forget_face import forget_faces
from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import Content, Draft, Edit, Stored, StoredDocument, content_key
from omote.showfile.contents import pack_face
from omote.showfile.inspection import inspect_show, verdicts
from omote.showfile.recording_file import KeptRecording, StoredCast, open_recording, recording_path
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import JournalEntry, open_show
from tests.showfile.authored_work import item, revision

SECRETS = ("Anneliese", "anneliese", "from anneliese_scan.ply", "drawn by hand")


def make_show(folder: Path) -> tuple[Path, bytes]:
    """A show with a scanned face, another one, drafts, a last state and three good copies; and the face's content."""
    cast = load_cast()
    kaori = cast.faces["kaori"]
    noise = np.random.default_rng(8).normal(0, 1e-4, kaori.positions.shape)
    scanned = Face("x", (kaori.positions + noise).astype(np.float32), kaori.parts)
    arrivals = [
        ImportedItem("Bo", (cast.faces["old"], Look()), note="from bo.ply"),
        ImportedItem("Anneliese", (scanned, Look()), note="from anneliese_scan.ply"),
    ]
    show = open_show(folder / "a.omote")
    show.apply(changes_to_import(cast, Stored(), arrivals, wall=1.0))
    (made,) = [each for each in show.stored().revisions if each.item == 2]
    show.apply(
        [
            Draft(2, "ada", 1, 0),
            Edit(2, "ada", 0, made.recipe, "drawn by hand"),
            StoredDocument("layout", "console", b'{"rows":["smile"]}'),
        ]
    )
    for _ in range(3):
        show.write_journal(JournalEntry(4, 2.0, b"\x81\xa4face\xa9anneliese"))
        back_up(show)
    show.set_aside(JournalEntry(5, 3.0, b"\x81\xa4face\xa9anneliese"), "why")
    show.write_journal(JournalEntry(6, 2.0, b"\x81\xa4face\xa9anneliese"))
    content = show.contents()[made.content]
    show.close()
    return folder / "a.omote", content


def pieces(content: bytes) -> list[bytes]:
    """Pieces of a content, so near to each other that every page of a file with it holds one."""
    return [content[at : at + 32] for at in range(0, len(content) - 32, 500)]


def holding(folder: Path, content: bytes) -> set[str]:
    """The files in a folder that hold anything of the face."""
    wanted = [*pieces(content), *(secret.encode() for secret in SECRETS)]
    return {path.name for path in folder.iterdir() if any(each in path.read_bytes() for each in wanted)}


def test_no_byte_is_left_in_the_file_nor_in_its_good_copies(tmp_path: Path) -> None:
    path, content = make_show(tmp_path)
    assert len(content) > 8 * 4096  # many pages
    assert holding(tmp_path, content) == {path.name, *(each.name for each in backup_paths(path))}
    found = forget_faces(path, ["Anneliese"])
    assert found.labels == ("Anneliese",)
    assert "starts neutral" in " ".join(found.notes)
    assert holding(tmp_path, content) == set()


def test_all_else_is_there_and_whole(tmp_path: Path) -> None:
    path, _ = make_show(tmp_path)
    before = inspect_show(path)
    forget_faces(path, ["anneliese"])
    after = inspect_show(path)
    assert after.stored.items == before.stored.items[:1]
    assert after.stored.revisions == before.stored.revisions[:1]
    assert after.stored.documents.get("layout", {}) == before.stored.documents.get("layout", {})
    key = before.stored.revisions[0].content
    assert after.contents == {key: before.contents[key]}
    assert all(good for good, _ in verdicts(path))
    newest, *older = backup_paths(path)
    assert inspect_show(newest).stored == after.stored
    assert not any(each.exists() for each in older)


def test_what_others_are_made_of_is_forgotten_only_with_them(tmp_path: Path) -> None:
    path, content = make_show(tmp_path)
    show = open_show(path)
    (made,) = [each for each in show.stored().revisions if each.item == 2]
    recipe = write_recipe(FaceRecipe({KEY + made.content: 0.5, "dog": 0.5}))
    data = pack_face(load_cast().faces["dog"], Look())
    other = revision(3, content=content_key(data), recipe=recipe)
    mix = item(3, kind="face", name="mix", label="Mix", head=1)
    show.apply([Content(content_key(data), data), mix, other])
    show.close()
    before = path.read_bytes()
    with pytest.raises(ShowFileError, match="mix is made of anneliese: name it too"):
        forget_faces(path, ["Anneliese"])
    assert path.read_bytes() == before
    forget_faces(path, ["Anneliese", "Mix"])
    assert holding(tmp_path, content) == set()
    assert [each.name for each in inspect_show(path).stored.items] == ["bo"]


def test_a_damaged_copy_is_named_and_goes_only_if_asked(tmp_path: Path) -> None:
    path, content = make_show(tmp_path)
    aside, other = (path.with_name(path.name + ending) for ending in (".corrupt-1", ".corrupt-2"))
    shutil.copy(path, aside)
    other.write_bytes(b"nothing of it")
    before = path.read_bytes()
    with pytest.raises(ShowFileError, match=r"a\.omote\.corrupt-1 beside it holds it too, so nothing was removed"):
        forget_faces(path, ["Anneliese"])
    assert path.read_bytes() == before
    forget_faces(path, ["Anneliese"], copies=True)
    assert holding(tmp_path, content) == set()
    assert other.exists()


def test_a_face_that_is_not_there_changes_nothing(tmp_path: Path) -> None:
    path, _ = make_show(tmp_path)
    before = {each.name: each.read_bytes() for each in tmp_path.iterdir()}
    with pytest.raises(ShowFileError, match="nobody"):
        forget_faces(path, ["nobody"])
    assert {name: (tmp_path / name).read_bytes() for name in before} == before


def test_the_command_says_what_went(tmp_path: Path) -> None:
    path, content = make_show(tmp_path)
    result = CliRunner().invoke(app, ["file", "forget", str(path), "Anneliese"])
    assert result.exit_code == 0, result.output
    assert "has nothing of Anneliese any more" in result.output
    assert holding(tmp_path, content) == set()


def test_what_was_recorded_with_it_is_gone_and_the_rest_stays(tmp_path: Path) -> None:
    path, content = make_show(tmp_path)
    key = content_key(content)
    recorded = open_recording(recording_path(path), new=True)
    start = recorded.begin_start(1e9, 0.0, "test")
    recorded.keep_cast(StoredCast("with", "base", b"anneliese", (key,)), [(key, content)])
    recorded.keep_cast(StoredCast("without", "base", b"", ()), [])
    for first, casts in ((0.0, ["without"]), (60.0, ["without", "with"]), (120.0, ["without"])):
        piece = recorded.begin_piece(start, first)
        recorded.add(piece, b"anneliese" if "with" in casts else b"nobody", last=first + 60.0, ticks=1, casts=casts)
    recorded.keep(KeptRecording("her", start, 70.0, 80.0))
    recorded.close()
    forgotten = forget_faces(path, ["anneliese"])
    assert "1.0 minutes" in forgotten.notes[0]
    for file in tmp_path.glob("a.omote-recording*"):
        data = file.read_bytes()
        assert b"anneliese" not in data
        assert not any(piece in data for piece in pieces(content))
    left = open_recording(recording_path(path))
    assert [piece.first for piece in left.pieces()] == [0.0, 120.0]
    assert (left.kept(), list(left.casts())) == ([], ["without"])
    left.close()
