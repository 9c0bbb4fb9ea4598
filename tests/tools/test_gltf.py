"""Khronos' validator and three.js, asked from Python."""

from pathlib import Path

import pytest

from tests.interchange.formats.scenes import plain_glb, put_together
from tools.gltf import inspect


def test_each_file_is_judged_in_turn(tmp_path: Path) -> None:
    good = tmp_path / "good.glb"
    bad = tmp_path / "bad.glb"
    good.write_bytes(plain_glb())
    bad.write_bytes(put_together({"asset": {"version": "2.0"}, "nodes": [{"children": [7]}]}))
    (found,) = inspect([good])
    assert found["validator"]["errors"] == 0
    assert found["three"]["meshes"]["tetra"]["vertices"] == 4
    with pytest.raises(RuntimeError, match="node could not inspect the files"):
        inspect([bad])
