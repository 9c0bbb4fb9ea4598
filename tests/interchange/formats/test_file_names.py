"""Which names files may have."""

from collections.abc import Callable
from pathlib import Path

import pytest

from omote.interchange.formats.file_names import (
    IMPORTS,
    KINDS,
    check_document_name,
    check_export_name,
    picture_kind,
    require_imports,
)


def test_the_name_says_the_kind() -> None:
    assert {picture_kind(Path(f"a{suffix}")) for suffix in KINDS} == set(KINDS.values())
    assert picture_kind(Path("A.PNG")) == "image/png"
    with pytest.raises(ValueError, match=r"'a\.gif' is no name of a picture; end it with \.png"):
        picture_kind(Path("a.gif"))


@pytest.mark.parametrize("name", ["a.glb", "a.NPZ", "b.csv", "a.usdz", "a.OBJ", "c.vrm"])
def test_an_export_has_an_ending_that_says_its_kind(name: str) -> None:
    check_export_name(Path(name))


def test_another_ending_is_refused() -> None:
    with pytest.raises(ValueError, match=r"'a\.fbx' is no name of an exported face; end it with \.glb, .* or \.csv"):
        check_export_name(Path("a.fbx"))
    with pytest.raises(ValueError, match=r"'a\.txt' is no name of a document; end it with \.json"):
        check_document_name(Path("a.txt"))


@pytest.mark.parametrize("check", [picture_kind, check_export_name, check_document_name])
def test_a_folder_is_no_file(tmp_path: Path, check: Callable[[Path], object]) -> None:
    with pytest.raises(IsADirectoryError, match="is a folder; give the name of a file in it"):
        check(tmp_path)


def test_files_to_be_taken_in_are_there_and_say_what_they_are(tmp_path: Path) -> None:
    for kind, endings in IMPORTS.items():
        paths = [tmp_path / f"smile{ending}" for ending in endings]
        for path in paths:
            path.touch()
        require_imports(paths, kind)
    for name, kind, what in (
        (
            "smile.txt",
            "expression",
            r"smile\.txt cannot be taken in as an expression: it has no shapes .* omote face smile",
        ),
        ("head.FBX", "expression", r"head\.FBX cannot be taken in as an expression: export it as \.glb or \.obj"),
        ("take.pcap", "expression", r"omote play-take take\.pcap plays it"),
        ("smile.json", "face", "leave out --as face"),
        ("anna.mtl", "face", "is read where that is given"),
        ("notes", "face", r"is told by its name; end that with \.ply, \.obj"),
    ):
        (tmp_path / name).touch()
        with pytest.raises(ValueError, match=what):
            require_imports([tmp_path / name], kind)
    with pytest.raises(FileNotFoundError, match=r"there is no file .*; did you mean .*smile\.ply\?"):
        require_imports([tmp_path / "smile"])
    with pytest.raises(FileNotFoundError, match="name one that is there"):
        require_imports([tmp_path / "frown.json"])
    with pytest.raises(IsADirectoryError, match="is a folder; name the files in it"):
        require_imports([tmp_path])
