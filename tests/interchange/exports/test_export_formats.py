"""The formats of exports: each writes what its name says, and nobody is surprised by another."""

import builtins
from typing import Any

import pytest

from omote.interchange.avatar.vrm_licence import Credit, parse_terms
from omote.interchange.exports import usd_writer
from omote.interchange.exports.export_formats import (
    FORMATS,
    OBJ_FOLDER,
    bake_face,
    check_kind,
    find_kind,
    unwritable_kinds,
)
from omote.interchange.formats.file_names import EXPORTS, USD, VRM
from omote.interchange.formats.glb_reader import read_glb
from tests.stage_data.heads import context

BEGINNINGS = {
    ".glb": b"glTF", ".usdc": b"PXR-USDC", ".usda": b"#usda", ".usdz": b"PK\x03\x04", ".npz": b"PK\x03\x04",
    ".vrm": b"glTF",
    ".csv": b"expression,", ".obj": b"# Omote", OBJ_FOLDER: b"# Omote",
}  # fmt: skip


@pytest.mark.parametrize("kind", [*EXPORTS, OBJ_FOLDER])
def test_each_kind_writes_files_of_its_own(kind: str) -> None:
    credit = Credit(("Ann",), parse_terms(["strict"])) if kind == VRM else None
    check_kind(kind, credit)
    files = bake_face(context(), "broad", ["smile"], kind, "aunt", credit=credit)
    name, data = next(iter(files.items()))
    assert name == ("aunt/neutral.obj" if kind == OBJ_FOLDER else f"aunt{kind}")
    assert data.startswith(BEGINNINGS[kind])


def test_every_name_of_a_format_is_a_kind() -> None:
    assert {find_kind(name) for name in FORMATS} == {*EXPORTS, OBJ_FOLDER} - {".obj"}
    assert find_kind("USD") == ".usdc"
    with pytest.raises(ValueError, match="there is no format 'fbx'; give one of glb, vrm, usd"):
        find_kind("fbx")


def test_an_avatar_without_an_author_is_refused_beforehand() -> None:
    with pytest.raises(ValueError, match="a VRM names who made it: give --author NAME"):
        check_kind(VRM)


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
    with pytest.raises(ValueError, match=r'pip install "omote\[usd\]"') as refused:
        check_kind(".usdz")
    monkeypatch.setattr(usd_writer, "find_spec", lambda _: None)
    assert unwritable_kinds() == dict.fromkeys(USD, str(refused.value)), "the same sentence"
    monkeypatch.setattr(usd_writer, "find_spec", lambda _: object())
    assert unwritable_kinds() == {}
