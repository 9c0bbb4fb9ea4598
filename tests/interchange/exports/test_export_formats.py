"""The formats of exports: each writes what its name says, and nobody is surprised by another."""

import builtins
from typing import Any

import pytest

from omote.interchange.exports.export_formats import FORMATS, OBJ_FOLDER, bake_face, check_kind, find_kind
from omote.interchange.formats.file_names import EXPORTS
from omote.interchange.formats.glb_reader import read_glb
from tests.stage_data.heads import context

BEGINNINGS = {
    ".glb": b"glTF", ".usdc": b"PXR-USDC", ".usda": b"#usda", ".usdz": b"PK\x03\x04", ".npz": b"PK\x03\x04",
    ".csv": b"expression,", ".obj": b"# Omote", OBJ_FOLDER: b"# Omote",
}  # fmt: skip


@pytest.mark.parametrize("kind", [*EXPORTS, OBJ_FOLDER])
def test_each_kind_writes_files_of_its_own(kind: str) -> None:
    check_kind(kind)
    files = bake_face(context(), "broad", ["smile"], kind, "aunt")
    name, data = next(iter(files.items()))
    assert name == ("aunt/neutral.obj" if kind == OBJ_FOLDER else f"aunt{kind}")
    assert data.startswith(BEGINNINGS[kind])


def test_every_name_of_a_format_is_a_kind() -> None:
    assert {find_kind(name) for name in FORMATS} == {*EXPORTS, OBJ_FOLDER} - {".obj"}
    assert find_kind("USD") == ".usdc"
    with pytest.raises(ValueError, match="there is no format 'fbx'; give one of glb, usd"):
        find_kind("fbx")


def test_hair_may_be_left_out() -> None:
    bald, whole = (bake_face(context(), "broad", [], ".glb", "a", hair=hair)["a.glb"] for hair in (False, True))
    names = {piece.name for piece in read_glb(whole)} - {piece.name for piece in read_glb(bald)}
    assert names == ({"hair"} if context().cast.looks["broad"].hair_style else set())


def test_a_kind_whose_library_is_missing_is_told_beforehand(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name.startswith("pxr"):
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    check_kind(".glb")
    with pytest.raises(ValueError, match=r'pip install "omote\[usd\]"'):
        check_kind(".usdz")
