"""STL files: text and binary, corners joined; all others are refused."""

import numpy as np
import pytest

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.stl_reader import is_binary_stl, read_stl
from tests.interchange.scans import scan_samples as samples

POINTS, TRIANGLES = samples.ball()


@pytest.mark.parametrize("text", [False, True])
def test_corners_at_one_place_become_one_point(text: bool) -> None:
    scan = read_stl(samples.write_stl(text=text))
    assert scan.triangles is not None
    assert len(scan.positions) == len(POINTS)
    np.testing.assert_array_equal(scan.positions[scan.triangles], POINTS[TRIANGLES])


def test_a_binary_file_that_begins_as_text_is_binary() -> None:
    assert is_binary_stl(samples.write_stl())
    assert not is_binary_stl(samples.write_stl(text=True))


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
@pytest.mark.parametrize("end", ["\r\n", "\r"])
def test_a_text_is_the_same_however_it_is_written(encoding: str, end: str) -> None:
    text = samples.write_stl(text=True).decode().upper().replace("\n", end).replace(".", ",").replace(" ", "\t")
    scan = read_stl(text.encode(encoding))
    np.testing.assert_array_equal(scan.positions[scan.triangles], POINTS[TRIANGLES])


@pytest.mark.parametrize("text", [False, True])
def test_a_corner_that_is_no_number_costs_its_triangles_and_is_said(text: bool) -> None:
    data = samples.write_stl(text=text)
    if text:
        first = data.index(b"vertex")
        data = data[:first] + b"vertex nan 0 0" + data[data.index(b"\n", first) :]
    else:
        data = data[:96] + b"\0\0\xc0\x7f" + data[100:]
    beside = Companions()
    scan = read_stl(data, beside)
    assert scan.triangles is not None
    assert len(scan.triangles) == len(TRIANGLES) - 1
    assert len(beside.notes) == 1


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"hello", "no STL, but text"),
        (samples.write_stl()[:-1].replace(b"solid", b"wrong"), "no STL of 252 triangles"),
        (samples.write_stl(text=True)[:-80], "corners with"),
        (samples.write_stl(text=True).replace(b"vertex 0.0", b"vertex zero"), "'zero.*', which is no number"),
        (b"x" * 80 + b"\xff\xff\xff\xff", "4294967295 triangles; expected 10000000 at most"),
        (b"solid nothing\nendsolid", "0 corners"),
    ],
)
def test_what_is_wrong_is_refused_with_a_sentence(data: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_stl(data)
