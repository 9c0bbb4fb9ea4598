"""Scans and pictures from files: whole, with what lies beside them and nothing from elsewhere."""

import os
from pathlib import Path

import numpy as np
import pytest

from omote.interchange.scans.scan_reader import read_scan
from omote.server.sandbox import scan_files
from omote.server.sandbox.scan_files import find_beside, read_picture_in_sandbox, read_scan_in_sandbox
from tests.interchange.scans import scan_samples as samples


def lay_out(folder: Path) -> Path:
    """An OBJ with its material and its texture."""
    folder.mkdir()
    (folder / "ball.obj").write_bytes(samples.write_obj(coloured=True))
    (folder / "ball.mtl").write_bytes(samples.MATERIAL)
    (folder / "head.png").write_bytes(samples.picture_bytes())
    return folder / "ball.obj"


def test_a_scan_comes_back_whole_with_its_texture(tmp_path: Path) -> None:
    told: list[str] = []
    found = read_scan_in_sandbox(lay_out(tmp_path / "scan"), follow=lambda _, what: told.append(what))
    points, triangles = samples.ball()
    assert found.notes == ()
    np.testing.assert_array_equal(found.scan.positions, points)
    np.testing.assert_array_equal(found.scan.triangles, triangles)
    np.testing.assert_array_equal(found.scan.colours, samples.colours())
    np.testing.assert_array_equal(found.scan.texture, samples.picture())
    assert told == ["reading", "handing it over"]


def test_shapes_come_back(tmp_path: Path) -> None:
    document, body = samples.gltf_document()
    path = tmp_path / "ball.vrm"
    path.write_bytes(samples.write_gltf(document, body))
    (moves,) = read_scan_in_sandbox(path).scan.shapes.values()
    (expected,) = read_scan(".vrm", path.read_bytes()).scan.shapes.values()
    np.testing.assert_array_equal(moves, expected)


@pytest.mark.parametrize(
    "name",
    ["../secret.png", "/etc/hostname", "..\\secret.png", "link.png", "linked/secret.png", "sub/../../secret.png",
     "a\0b", "x" * 5000, "", ".", "..", "sub"],
)  # fmt: skip
def test_names_in_a_file_lead_nowhere_else(name: str, tmp_path: Path) -> None:
    path = lay_out(tmp_path / "scan")
    (tmp_path / "secret.png").write_bytes(b"secret")
    (path.parent / "sub").mkdir()
    (path.parent / "link.png").symlink_to(tmp_path / "secret.png")
    (path.parent / "linked").symlink_to(tmp_path)
    assert find_beside(path, name) is None


@pytest.mark.parametrize(
    "name", ["head.png", "sub/deep.png", "sub\\deep.png", r"D:\scans\me\head.png", "/anywhere/me/head.png"]
)
def test_names_find_what_lies_beside_or_below(name: str, tmp_path: Path) -> None:
    path = lay_out(tmp_path / "scan")
    (path.parent / "sub").mkdir()
    (path.parent / "sub" / "deep.png").write_bytes(samples.picture_bytes())
    assert find_beside(path, name) == samples.picture_bytes()


def test_a_pipe_is_waited_for_by_nobody(tmp_path: Path) -> None:
    path = lay_out(tmp_path / "scan")
    os.mkfifo(path.parent / "pipe.png")
    assert find_beside(path, "pipe.png") is None
    with pytest.raises(ValueError, match="is no file but a device"):
        read_scan_in_sandbox(path.parent / "pipe.png")


def test_a_picture_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(samples.picture_bytes())
    np.testing.assert_array_equal(read_picture_in_sandbox(path), samples.picture())


def test_what_is_wrong_is_told_with_its_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.ply"
    path.write_bytes(b"hello")
    with pytest.raises(ValueError, match=r"^a\.ply: the file is no PLY, but text; export"):
        read_scan_in_sandbox(path)
    with pytest.raises(ValueError, match=r"^a\.ply: the file is no picture, but text"):
        read_picture_in_sandbox(path)
    with pytest.raises(FileNotFoundError, match=r"there is no file .*b\.ply"):
        read_scan_in_sandbox(tmp_path / "b.ply")
    with pytest.raises(ValueError, match="is no file but a folder"):
        read_scan_in_sandbox(tmp_path)
    monkeypatch.setattr(scan_files, "LARGEST", 4)
    with pytest.raises(ValueError, match=r"a\.ply has 5 bytes; expected 4 at most"):
        read_scan_in_sandbox(path)
