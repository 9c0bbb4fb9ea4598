"""OBJ files: their vertices in order, and nothing that is no point."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from omote.interchange.scans import wavefront_reader
from omote.interchange.scans.wavefront_reader import read_obj_pieces


def read_obj(data: bytes) -> np.ndarray:
    """The vertices of a file that names no skin."""
    (piece,) = read_obj_pieces(data)
    return piece.points


points = arrays(np.float64, st.tuples(st.integers(1, 6), st.just(3)), elements=st.floats(-1e6, 1e6))


@given(points)
def test_vertices_come_back_in_order(given_points: np.ndarray) -> None:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in given_points.tolist()]
    text = "\n".join(["# made by nobody", "o head", *lines, "vn 0 0 1", "vt 0 0", "f 1 2 3"])
    np.testing.assert_array_equal(read_obj(text.encode()), given_points)


def test_colours_behind_a_vertex_are_passed_over() -> None:
    np.testing.assert_array_equal(read_obj(b"v 1 2 3 0.5 0.5 0.5\r\n\tv 4 5 6\r\n"), [[1, 2, 3], [4, 5, 6]])


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (b"", "but an empty file; export"),
        (b"f 1 2 3", "no OBJ with vertices, but text"),
        (b"v 1 2", "is no vertex of the OBJ; expected 3 numbers"),
        (b"v a b c", "a vertex of the OBJ has 'a', which is no number"),
        (b"v 1 2 nan", "vertex 1 is"),
        (b"v 0 0 0\nv 1e999 0 0", "vertex 2 is"),
        (b"v " + b"9" * 400 + b" 0 0", "vertex 1 is"),
    ],
)
def test_what_is_no_shape_is_refused(text: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_obj(text)


def test_a_file_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wavefront_reader, "MOST_POINTS", 1)
    with pytest.raises(ValueError, match="has 2 points; expected 1 at most"):
        read_obj(b"v 0 0 0\nv 0 0 0")
    monkeypatch.setattr(wavefront_reader, "LARGEST", 3)
    with pytest.raises(ValueError, match="expected 3 at most"):
        read_obj(b"v 0 0 0")


@given(points, points)
def test_a_head_of_several_objects_comes_back_by_their_names(skin: np.ndarray, tongue: np.ndarray) -> None:
    lines = []
    for name, part in (("skin", skin), ("tongue", tongue)):
        lines += [f"o {name}", *(f"v {x!r} {y!r} {z!r}" for x, y, z in part.tolist())]
    first, second = read_obj_pieces("\n".join(lines).encode())
    assert (first.name, second.name) == ("skin", "tongue")
    np.testing.assert_array_equal(first.points, skin)
    np.testing.assert_array_equal(second.points, tongue)


@pytest.mark.parametrize("text", [b"v 1 2 3\nv 4 5 6", b"o head\nv 1 2 3\no hat\nv 4 5 6", b"o\nv 1 2 3\nv 4 5 6"])
def test_all_is_the_skin_where_no_object_says_so(text: bytes) -> None:
    (piece,) = read_obj_pieces(text)
    assert piece.name == "skin"
    np.testing.assert_array_equal(piece.points, [[1, 2, 3], [4, 5, 6]])
