"""Materials of OBJ files: by name, with options of their maps; what is in no library is said."""

from __future__ import annotations

import numpy as np
import pytest

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.obj_materials import ObjMaterial, find_material, read_materials
from omote.interchange.scans.text_table import TextTable
from tests.interchange.scans import scan_samples as samples

PICTURES = {name: samples.picture_bytes() for name in ("head.png", "my head.png", "2048.png", "1 2.png")}


def read(library: bytes, named: bytes = b"mtllib a.mtl") -> tuple[dict[str, ObjMaterial], list[str]]:
    """The materials of a file that names one library, and what is said of them."""
    beside = Companions((PICTURES | {"a.mtl": library, "my a.mtl": library}).get)
    return read_materials(TextTable(named), beside), beside.notes


@pytest.mark.parametrize(
    ("words", "scale", "shift"),
    [
        (b"head.png", (1.0, 1.0), (0.0, 0.0)),
        (b"my head.png", (1.0, 1.0), (0.0, 0.0)),
        (b'"my head.png"', (1.0, 1.0), (0.0, 0.0)),
        (b"-s 2 3 1 head.png", (2.0, 3.0), (0.0, 0.0)),
        (b"-o 0.5 -s 2 -clamp on head.png # the skin", (2.0, 1.0), (0.5, 0.0)),
        (b"-blendu on -imfchan r -bm 0.5 -o .25 .5 0 2048.png", (1.0, 1.0), (0.25, 0.5)),
        (b"-s 1,5 2,5 1 head.png", (1.5, 2.5), (0.0, 0.0)),
    ],
)
@pytest.mark.parametrize("keyword", [b"map_Kd", b"MAP_KD\t", b"\tmap_kd"])
def test_a_map_has_its_options_and_its_picture(
    keyword: bytes, words: bytes, scale: tuple[float, float], shift: tuple[float, float]
) -> None:
    materials, notes = read(b"newmtl skin\n" + keyword + b" " + words + b"\n")
    np.testing.assert_array_equal(materials["skin"].picture, samples.picture())
    assert (materials["skin"].scale, materials["skin"].shift, notes) == (scale, shift, [])


@pytest.mark.parametrize(
    "named", [b"mtllib my a.mtl", b"mtllib\ta.mtl # all", b"MTLLIB b.mtl a.mtl", b'mtllib "my a.mtl"']
)
def test_a_library_is_found_by_all_of_its_name_or_as_one_of_several(named: bytes) -> None:
    assert list(read(b"newmtl skin\nKd 1 0 0", named)[0]) == ["skin"]


def test_a_library_that_is_not_there_is_said() -> None:
    assert read(b"", b"mtllib c.mtl")[1] == [
        "its materials 'c.mtl' do not lie beside it: give both together, with its pictures"
    ]


@pytest.mark.parametrize(
    ("words", "colour"), [(b"1 0 0", [255, 0, 0]), (b"1", [255] * 3), (b"0 0,0 1 # blue", [0, 0, 255])]
)
def test_a_colour_may_be_grey_and_have_a_comment(words: bytes, colour: list[int]) -> None:
    materials, _ = read(b"newmtl skin\n  Kd\t" + words)
    np.testing.assert_array_equal(materials["skin"].picture[0, 0], colour)


def test_names_differ_by_capitals_and_comments_and_others_are_said_once() -> None:
    materials, _ = read(b"newmtl Skin # of the head\nKd 1 0 0\nnewmtl M #1\nKd 0 1 0\nnewmtl M #2\nKd 0 0 1\n")
    beside = Companions()
    assert find_material(materials, "skin", beside) is materials["Skin # of the head"]
    assert find_material(materials, "M #2", beside) is materials["M #2"]
    assert find_material(materials, "hair", beside) is find_material(materials, "hair", beside) is None
    assert beside.notes == ["its material 'hair' is in none of its files of materials: what is made of it is grey"]
