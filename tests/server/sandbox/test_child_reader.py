"""Files parsed in a sandboxed process: valid ones come back, invalid or too large ones are rejected with a message."""

import os
from pathlib import Path

import numpy as np
import pytest

from omote.interchange.avatar.export_vrm import vrm_bytes
from omote.interchange.avatar.vrm_licence import Credit, parse_terms
from omote.interchange.export_face import named_compound_meshes
from omote.interchange.formats.glb_reader import Piece, read_glb
from omote.server.sandbox import child_reader
from omote.server.sandbox.child_reader import read_in_sandbox
from tests.interchange.formats.scenes import NAMES, plain_glb, taken_apart
from tests.stage_data.heads import context


def test_pieces_come_back_whole(tmp_path: Path) -> None:
    path = tmp_path / "a.GLB"
    path.write_bytes(plain_glb())
    (piece,) = read_in_sandbox(path)
    assert piece.name == "tetra"
    assert tuple(piece.moves) == NAMES
    assert piece.rows is not None
    np.testing.assert_array_equal(piece.rows, [3, 2, 1, 0])
    assert piece.points.shape == (4, 3)


def test_a_shape_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "a.obj"
    path.write_bytes(b"v 1 2 3\nv 4 5 6\n")
    (piece,) = read_in_sandbox(path)
    np.testing.assert_array_equal(piece.points, [[1, 2, 3], [4, 5, 6]])
    assert piece.rows is None


@pytest.mark.parametrize("suffix", [".vrm", ".glb"])
def test_shapes_of_an_avatar_come_back_as_its_expressions(suffix: str, tmp_path: Path) -> None:
    cast, path = context().cast, tmp_path / f"broad{suffix}"
    poses = [(name, named_compound_meshes(cast, "broad", name)) for name in ("smile", "jawOpen")]
    path.write_bytes(vrm_bytes(context(), "broad", poses, Credit(("Ann",), parse_terms(["strict"]))))
    found, raw = (
        {name: moved for piece in pieces if piece.name == "skin" for name, moved in piece.moves.items()}
        for pieces in (read_in_sandbox(path), read_glb(path.read_bytes()))
    )
    kinds = taken_apart(path.read_bytes())[0]["extensions"]["VRMC_vrm"]["expressions"]
    assert {"relaxed", "JawOpen"} <= found.keys() <= {*kinds["preset"], *kinds["custom"]}
    assert "jawOpen" in raw
    np.testing.assert_array_equal(found["JawOpen"], raw["jawOpen"])
    np.testing.assert_array_equal(found["relaxed"], raw["smile"])


def test_what_is_wrong_is_told_with_its_file(tmp_path: Path) -> None:
    path = tmp_path / "a.glb"
    path.write_bytes(b"hello")
    with pytest.raises(ValueError, match=r"a\.glb: the file is no GLB"):
        read_in_sandbox(path)
    with pytest.raises(ValueError, match=r"'a\.fbx' is no file with a head; expected \.glb, \.vrm, \.obj or \.json"):
        read_in_sandbox(tmp_path / "a.fbx")


@pytest.mark.parametrize("kind", ["memory", "death", "files"])
def test_a_reader_that_takes_too_much_or_dies_harms_nobody(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def hungry(_: bytes) -> tuple[Piece, ...]:
        if kind == "memory":
            return (Piece("x", np.ones((2**31, 3))),)
        if kind == "death":
            os._exit(3)
        (tmp_path / "stray").write_bytes(b"x" * 10_000)
        return ()

    path = tmp_path / "a.glb"
    path.write_bytes(b"x")
    monkeypatch.setattr(child_reader, "READERS", {".glb": hungry})
    with pytest.raises(ValueError, match="needs more time or memory than any face"):
        read_in_sandbox(path)
    stray = tmp_path / "stray"
    assert not stray.exists() or stray.stat().st_size == 0
