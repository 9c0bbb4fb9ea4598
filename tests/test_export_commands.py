"""The command `omote export`, as it is typed."""

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from omote.builtin import load_cast
from omote.cli import app
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.scans.wavefront_reader import read_obj_pieces
from omote.showfile.changes import Stored
from omote.showfile.show_file import open_show

runner = CliRunner()


def test_a_face_is_written_with_its_expressions_as_targets(tmp_path: Path) -> None:
    path = tmp_path / "dog.glb"  # the ending may be left out
    done = runner.invoke(app, ["export", "dog", "-o", str(tmp_path / "dog"), "--expressions", "smile,jawOpen"])
    assert done.exit_code == 0, done.output
    assert {tuple(piece.moves) for piece in read_glb(path.read_bytes())} == {("smile", "jawOpen")}
    before = path.read_bytes()  # shaped in another program, it may have the same name
    again = ["export", "dog", "-o", str(path), "--expressions", "smile"]
    assert "dog.glb is there already and stays as it is; give another name, or --force" in (
        runner.invoke(app, again).stderr
    )
    assert path.read_bytes() == before
    assert runner.invoke(app, [*again, "--force"]).exit_code == 0
    assert {tuple(piece.moves) for piece in read_glb(path.read_bytes())} == {("smile",)}


@pytest.mark.parametrize("ending", [".npz", ".csv"])
def test_a_face_is_written_as_numbers(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"dog{ending}"
    done = runner.invoke(app, ["export", "dog", "-o", str(path), "--expressions", "jawOpen"])
    assert f"omote: {path}: dog, expressions: 1, " in done.stderr
    assert b"jawOpen,26,skin" in path.read_bytes() or ending == ".npz"
    path.write_bytes(b"somebody else's")
    assert "it stays as it is" in runner.invoke(app, ["export", "dog", "-o", str(path), "--force"]).stderr
    assert path.read_bytes() == b"somebody else's"


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["nobody", "-o", "a.glb"], "there is no face 'nobody'"),
        (["dog", "-o", "a.gltf"], "is no name of an exported face; end it with .glb, "),
        (["dog", "-o", "a.obj", "--expressions", "smile,jawOpen"], "an OBJ holds one shape, and 2 expressions"),
        (["-o", "a.glb"], "name a face (omote cast lists them), or --all and a folder"),
        (["dog", "--all", "-o", "a"], "name one face (omote cast lists them), or --all"),
        (["--all", "-o", "a", "--format", "fbx"], "there is no format 'fbx'; give one of glb, "),
        (["--faces", "dog,nobody", "-o", "a"], "there is no face 'nobody'"),
        (["--faces", ",", "-o", "a"], "names no face; give names by commas, all, or own with --show"),
        (["--all", "-o", "a", "--show", "none.omote"], "there is no show file"),
        (["--all", "-o", "a", "--expressions", "grin"], "there is no expression 'grin'"),
        (["dog", "-o", "a.glb", "--expressions", "grin"], "there is no expression 'grin'"),
        (["dog", "-o", "a.npz", "--expressions", ","], "',' names no expression; give names or a kind"),
        (["dog", "-o", "a.glb", "--show", "none.omote"], "there is no show file"),
        (["dog", "-o", "a.vrm"], "a VRM names who made it: give --author NAME"),
        (["dog", "-o", "a.vrm", "--author", "Ann", "--licence", "mine"], "'mine' is no term of use"),
        (["dog", "-o", "a.glb", "--author", "Ann"], "--author, --licence and --vrm0 are for a VRM alone; this is .glb"),
        (["dog", "-o", "a.npz", "--vrm0"], "--author, --licence and --vrm0 are for a VRM alone; this is .npz"),
    ],
)
def test_an_export_that_cannot_be_leaves_no_file(
    arguments: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    refused = runner.invoke(app, ["export", *arguments])
    assert refused.exit_code == 1
    assert sentence in refused.output
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("ending", [".usdc", ".usda", ".usdz", ".obj"])
def test_a_face_is_written_for_other_programs(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"dog{ending}"
    words = ["export", "dog", "-o", str(path), "--expressions", "jawOpen"]
    done = runner.invoke(app, words)
    assert done.exit_code == 0, done.output
    beside = sorted(each.name for each in tmp_path.iterdir() if each != path)
    assert beside == [] if ending == ".usdz" else all(name.startswith("dog.") for name in beside)
    before = {each.name: each.read_bytes() for each in tmp_path.iterdir()}
    path.unlink()
    if beside:  # pictures of another export are not replaced either
        refused = runner.invoke(app, words).stderr
        assert any(f"{name} is there already and stays as it is" in refused for name in beside)
        assert not path.exists()
    assert runner.invoke(app, [*words, "--force"]).exit_code == 0
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == before


def test_a_face_is_written_on_its_own_body_or_on_another(tmp_path: Path) -> None:
    heights = {}
    for words in (["--figure"], ["--body", "child"]):
        path = tmp_path / "kaori.glb"
        given = ["export", "kaori", "-o", str(path), "--expressions", "neutral", "--no-hair", "--force", *words]
        done = runner.invoke(app, given)
        assert done.exit_code == 0, done.output
        assert f"kaori on {'its body' if words == ['--figure'] else 'the body child'}, " in done.stderr
        points = {piece.name: piece.points for piece in read_glb(path.read_bytes())}
        assert points["shoes"][:, 1].min() == pytest.approx(0.0, abs=1e-4)
        heights[words[-1]] = points["skin"][:, 1].max()
    assert 1.6 < heights["--figure"] < 1.9
    assert heights["child"] < heights["--figure"] - 0.2
    refused = runner.invoke(app, ["export", "kaori", "-o", str(tmp_path / "kaori.obj"), "--figure"])
    assert "a figure is written as GLB, VRM or USD" in refused.stderr


def test_a_single_obj_is_the_face_at_rest_unless_an_expression_is_named(tmp_path: Path) -> None:
    assert runner.invoke(app, ["export", "dog", "-o", str(tmp_path / "dog.obj")]).exit_code == 0
    pieces = read_obj_pieces((tmp_path / "dog.obj").read_bytes())
    np.testing.assert_allclose(pieces[0].points, load_cast().faces["dog"].positions, atol=1e-7)


def test_faces_are_written_into_a_folder_and_not_again(tmp_path: Path) -> None:
    folder = tmp_path / "heads"
    words = [
        "export",
        "--faces",
        "dog,Kaori",
        "-o",
        str(folder),
        "--expressions",
        "smile",
        "--format",
        "npz",
        "-j",
        "1",
    ]
    done = runner.invoke(app, words)
    assert (done.exit_code, "faces written: 2" in done.stderr) == (0, True), done.output
    assert "1 of 2: dog" in done.stderr
    assert {path.name for path in folder.iterdir()} == {"dog.npz", "kaori.npz", ".omote-export"}
    again = runner.invoke(app, words)
    assert "faces written: 0; there already, whole and current: 2" in again.stderr
    (folder / "dog.npz").write_bytes(b"PK\x03\x04 theirs")
    refused = runner.invoke(app, words)
    assert (refused.exit_code, "failed: 1" in refused.stderr) == (1, True)
    assert f"dog: {folder / 'dog.npz'} is there already and is not as Omote wrote it" in refused.stderr


def test_one_face_becomes_a_folder_of_shapes(tmp_path: Path) -> None:
    words = ["export", "dog", "--format", "obj", "-o", str(tmp_path), "--expressions", "smile,jawOpen", "-j", "1"]
    assert runner.invoke(app, words).exit_code == 0
    assert {path.name for path in (tmp_path / "dog").glob("*.obj")} == {"neutral.obj", "smile.obj", "jawOpen.obj"}


def test_faces_of_a_show_file_are_chosen_as_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert runner.invoke(app, ["export", "dog", "-o", "rover.obj"]).exit_code == 0
    taken = runner.invoke(app, ["file", "import", "my.omote", "rover.obj", "--as", "face"])
    assert taken.exit_code == 0, taken.output
    words = ["export", "--faces", "own", "--show", "my.omote", "--format", "npz", "-o", "out", "--expressions", "smile"]
    done = runner.invoke(app, [*words, "-j", "1"])
    assert (done.exit_code, [path.name for path in (tmp_path / "out").glob("*.npz")]) == (0, ["rover.npz"]), done.output


def test_a_run_that_is_stopped_says_how_to_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("omote.server.farm.export_run.run_export", stop)
    done = runner.invoke(app, ["export", "--all", "-o", str(tmp_path / "heads")])
    assert (done.exit_code, "the same command goes on from there" in done.stderr) == (130, True)


def test_a_cluster_that_is_not_there_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.farm.dask_pool.TIMEOUT", 0.2)
    done = runner.invoke(app, ["export", "--all", "-o", str(tmp_path / "heads"), "--on", "tcp://127.0.0.1:9"])
    assert (done.exit_code, "no Dask scheduler answers at 'tcp://127.0.0.1:9'" in done.stderr) == (1, True)


def test_a_face_is_written_as_an_avatar_of_its_author(tmp_path: Path) -> None:
    path = tmp_path / "dog.vrm"
    done = runner.invoke(app, ["export", "dog", "-o", str(path), "--author", "Ann", "--author", "Ben"])
    assert done.exit_code == 0, done.output
    assert "dog is by Ann, Ben; it came with Omote and is CC0, so anyone may use it for anything" in done.stderr
    assert b'"authors":["Ann","Ben"]' in path.read_bytes()
    told = ["export", "dog", "-o", str(path), "--author", "Ann", "--licence", "strict", "--force"]
    assert "others may use it so: avatarPermission onlyAuthor" in runner.invoke(app, told).stderr
    assert b'"avatarPermission":"onlyAuthor"' in path.read_bytes()
    assert runner.invoke(app, [*told, "--vrm0"]).exit_code == 0
    assert b'"VRM":{"exporterVersion"' in path.read_bytes()


def test_an_own_face_becomes_an_avatar_when_its_licence_is_said(tmp_path: Path) -> None:
    show = tmp_path / "a.omote"
    path = tmp_path / "aunt.vrm"
    cast = load_cast()
    aunt = ImportedItem("Aunt", (cast.faces["auntie"], cast.looks["auntie"]))
    with closing(open_show(show)) as file:
        file.apply(changes_to_import(cast, Stored(), [aunt], wall=0.0))
    words = ["export", "aunt", "-o", str(path), "--show", str(show), "--author", "Ann"]
    assert "is an own face and not CC0 as the built-in cast is: say who may use it" in runner.invoke(app, words).stderr
    assert not path.exists()
    assert runner.invoke(app, [*words, "--licence", "strict"]).exit_code == 0
    assert b'"avatarPermission":"onlyAuthor"' in path.read_bytes()


def test_a_folder_of_avatars_has_one_credit(tmp_path: Path) -> None:
    words = ["export", "--faces", "dog", "-o", str(tmp_path / "heads"), "--format", "vrm", "--jobs", "1"]
    assert "a VRM names who made it: give --author NAME" in runner.invoke(app, words).stderr
    done = runner.invoke(app, [*words, "--author", "Ann"])
    assert done.exit_code == 0, done.output
    assert b'"authors":["Ann"]' in (tmp_path / "heads" / "dog.vrm").read_bytes()
    other = runner.invoke(app, [*words, "--author", "Ben"])
    assert "faces written: 1" in other.stderr
    assert b'"authors":["Ben"]' in (tmp_path / "heads" / "dog.vrm").read_bytes()
