"""The command `omote export`, as it is typed."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.interchange.formats.glb_reader import read_glb

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
        (["dog", "-o", "a.gltf"], "is no name of a GLB file; end it with .glb, or with .npz or .csv for numbers"),
        (["dog", "-o", "a.glb", "--expressions", "grin"], "there is no expression 'grin'"),
        (["dog", "-o", "a.npz", "--expressions", ","], "',' names no expression; give names or a kind"),
        (["dog", "-o", "a.glb", "--show", "none.omote"], "there is no show file"),
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
