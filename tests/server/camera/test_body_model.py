"""The body model that a wheel leaves out: its very files are put where the pages look, and no others."""

import hashlib
import io
import json
import tarfile
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.server.camera.body_model import LISTED, install_body_model

FILES = {"pose.js": b"glue", "pose_landmark_lite.tflite": bytes(5000)}


def package(folder: Path, files: dict[str, bytes]) -> Path:
    """An npm package."""
    path = folder / "pose.tgz"
    with tarfile.open(path, "w:gz") as archive:
        for name, content in files.items():
            member = tarfile.TarInfo(f"package/{name}")
            member.size = len(content)
            archive.addfile(member, io.BytesIO(content))
    return path


@pytest.fixture
def static(tmp_path: Path) -> Path:
    """The folder of pages of a wheel."""
    folder = tmp_path / "static" / "pose-12345678"
    folder.mkdir(parents=True)
    sums = {name: hashlib.sha256(content).hexdigest() for name, content in FILES.items()}
    (folder / LISTED).write_text(json.dumps(sums))
    return folder.parent


def test_the_files_that_the_pages_want_are_put_where_they_look(static: Path, tmp_path: Path) -> None:
    folder = install_body_model(package(tmp_path, FILES | {"pose_landmark_heavy.tflite": b"left out"}), static)
    assert {path.name: path.read_bytes() for path in folder.iterdir() if path.name != LISTED} == FILES


@pytest.mark.parametrize(
    ("files", "said"),
    [
        (FILES | {"pose.js": b"another"}, "another version"),
        ({"pose.js": b"glue"}, "has no pose_landmark_lite.tflite"),
    ],
)
def test_another_package_is_refused_and_nothing_is_written(
    static: Path, tmp_path: Path, files: dict[str, bytes], said: str
) -> None:
    with pytest.raises(ValueError, match=said):
        install_body_model(package(tmp_path, files), static)
    assert [path.name for path in static.glob("*/*")] == [LISTED]


def test_what_is_no_package_is_said(static: Path, tmp_path: Path) -> None:
    picture = tmp_path / "picture.jpg"
    picture.write_bytes(b"\xff\xd8\xff")
    with pytest.raises(ValueError, match="no package of npm"):
        install_body_model(picture, static)
    with pytest.raises(ValueError, match="install Omote again"):
        install_body_model(picture, tmp_path)
    done = CliRunner().invoke(app, ["body-model", str(picture)])
    assert done.exit_code == 1
    assert "no package of npm" in done.stderr
