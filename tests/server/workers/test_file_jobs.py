"""Jobs of files do what the commands do, say how far they are, and reject with a sentence."""

import io
import zipfile
from pathlib import Path

import msgspec
import numpy as np
import pytest
from msgspec import structs

from omote.builtin import load_cast
from omote.edit.store.import_items import ImportedItem, changes_to_import, make_document
from omote.interchange.export_face import named_compound_meshes
from omote.interchange.formats.expression_json import decode, encode
from omote.interchange.formats.glb_reader import read_glb
from omote.model.cast import Cast
from omote.server.workers.file_jobs import ExportExpression, ExportFace, FileJob, Imported, ImportFile, run_file_job
from omote.showfile.changes import Content, Stored
from omote.showfile.show_file import open_show
from tests.interchange.formats.scenes import head_glb, taken_apart

Steps = list[tuple[int, int, str]]


@pytest.fixture(scope="module")
def built_in() -> Cast:
    """The built-in cast."""
    return load_cast()


@pytest.fixture
def show(tmp_path: Path) -> Path:
    """A show file without own work."""
    open_show(tmp_path / "show.omote").close()
    return tmp_path / "show.omote"


def done(job: FileJob) -> tuple[bytes, Steps]:
    """What a job makes, and the steps that it told of."""
    steps: Steps = []
    made = run_file_job(msgspec.msgpack.encode(job), lambda *step: steps.append(step))
    return made, steps


def test_a_document_goes_out_and_comes_in_the_same(built_in: Cast, show: Path, tmp_path: Path) -> None:
    made, _ = done(ExportExpression(str(show), "smile"))
    assert made == encode(
        make_document(built_in.space, built_in.titles["smile"].label, (), built_in.expressions["smile"])
    )
    (tmp_path / "smile.json").write_bytes(made)
    imported = msgspec.msgpack.decode(
        done(ImportFile(str(show), str(tmp_path / "smile.json"), "expression", 1.0))[0], type=Imported
    )
    (item,) = imported.items
    assert (item.item.kind, item.revision.written) == ("expression", 1.0)
    assert imported.said[0].startswith(f"{decode(made).label}, from smile.json")


def test_a_face_goes_out_with_its_expressions_and_tells_of_each(show: Path) -> None:
    made, steps = done(ExportFace(str(show), "dog", "smile,jawOpen"))
    assert {name for piece in read_glb(made) for name in piece.moves} == {"smile", "jawOpen"}
    assert [step[:2] for step in steps] == [(0, 2), (1, 2), (2, 2)]
    assert [step[2] for step in steps[:2]] == ["smile", "jawOpen"]


@pytest.fixture
def own_show(built_in: Cast, show: Path) -> Path:
    """The show file with a face of its own, called otherwise than its name."""
    file = open_show(show)
    arrival = ImportedItem("Aunt Ann!", (built_in.faces["old"], built_in.looks["old"]))
    file.apply(changes_to_import(built_in, Stored(), [arrival], wall=1.0))
    file.close()
    return show


def test_an_own_face_goes_out_as_an_avatar_with_its_label_its_author_and_its_terms(own_show: Path) -> None:
    job = ExportFace(str(own_show), "aunt_ann", "smile", ".vrm", ("Ann",), "strict")
    document, _ = taken_apart(done(job)[0])
    meta = document["extensions"]["VRMC_vrm"]["meta"]
    assert (meta["name"], meta["authors"], meta["avatarPermission"]) == ("Aunt Ann!", ["Ann"], "onlyAuthor")
    for lacking in ({"authors": ()}, {"licence": ""}):
        with pytest.raises(ValueError, match=r"who made it|say who may use it"):
            done(structs.replace(job, **lacking))


def test_several_files_go_out_as_one_zip_the_same_each_time(show: Path) -> None:
    job = ExportFace(str(show), "dog", "neutral", ".obj")
    made, _ = done(job)
    names = zipfile.ZipFile(io.BytesIO(made)).namelist()
    assert names[:2] == ["dog.obj", "dog.mtl"]
    assert all(name.endswith(".png") for name in names[2:])
    assert done(job)[0] == made
    with pytest.raises(ValueError, match="OBJ"):
        done(structs.replace(job, expressions="smile,cry"))


def test_a_package_of_usd_goes_out(show: Path) -> None:
    made, _ = done(ExportFace(str(show), "dog", "smile", ".usdz"))
    assert zipfile.ZipFile(io.BytesIO(made)).namelist()[0] == "dog.usdc"


def test_shapes_come_in_and_tell_of_each(built_in: Cast, show: Path, tmp_path: Path) -> None:
    rest = built_in.faces["dog"].positions.astype(np.float64)
    moved = {name: named_compound_meshes(built_in, "dog", name)["skin"] - rest for name in ("smile", "cry")}
    (tmp_path / "dog.glb").write_bytes(head_glb("skin", rest, moved))
    made, steps = done(ImportFile(str(show), str(tmp_path / "dog.glb"), "expression", 1.0))
    assert [each.item.label for each in msgspec.msgpack.decode(made, type=Imported).items] == ["smile 2", "cry 2"]
    assert steps == [(0, 2, "smile"), (1, 2, "cry")]


def test_own_work_of_the_show_file_goes_out(built_in: Cast, show: Path) -> None:
    file = open_show(show)
    changes = changes_to_import(built_in, Stored(), [ImportedItem("Own", built_in.expressions["cry"])], wall=1.0)
    file.apply(changes)
    file.close()
    own, _ = done(ExportExpression(str(show), "own"))
    assert decode(own).label == "Own"


@pytest.mark.parametrize(
    ("job", "why"),
    [
        (ExportExpression("none.omote", "smile"), "there is no show file"),
        (ImportFile("none.omote", "x.json", "expression", 1.0), "there is no show file"),
    ],
)
def test_what_cannot_be_done_is_a_sentence(job: FileJob, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        done(job)


def test_a_twin_gets_a_label_of_its_own_and_is_told(show: Path, tmp_path: Path) -> None:
    (tmp_path / "smile.json").write_bytes(done(ExportExpression(str(show), "smile"))[0])
    job = ImportFile(str(show), str(tmp_path / "smile.json"), "expression", 1.0)
    labels = list[str]()
    said = list[str]()
    for _ in range(2):
        imported = msgspec.msgpack.decode(done(job)[0], type=Imported)
        (item,) = imported.items
        labels.append(item.item.label)
        said += imported.said
        file = open_show(show)
        file.apply([Content(item.revision.content, item.content), item.item, item.revision])
        file.close()
    assert labels == ["Smile 2", "Smile 3"], "the cast has a Smile"
    assert said[0].endswith("there is a 'Smile' already, so this one is called 'Smile 2'")
