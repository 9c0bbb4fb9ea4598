"""OBJ files: polygons, corners from either end, colours and textures by material; all others are refused."""

import codecs

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.wavefront_reader import read_obj_pieces, read_wavefront
from tests.interchange.scans import scan_samples as samples

POINTS, TRIANGLES = samples.ball()
BESIDE = {"ball.mtl": samples.MATERIAL, "head.png": samples.picture_bytes()}


@pytest.mark.parametrize("backwards", [False, True])
def test_a_mesh_comes_back_with_its_texture(backwards: bool) -> None:
    scan = read_wavefront(samples.write_obj(backwards=backwards), Companions(BESIDE.get))
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.triangles, TRIANGLES)
    np.testing.assert_array_equal(scan.texture, samples.picture())
    assert scan.texcoords is not None
    np.testing.assert_allclose(scan.texcoords, samples.texcoords(), atol=1e-12)


def test_backward_corners_count_from_the_face_and_not_from_the_end() -> None:
    lines = samples.write_obj(backwards=True, textured=False) + b"\nv 9 9 9\nv 8 8 8\n"
    np.testing.assert_array_equal(read_wavefront(lines, Companions()).triangles, TRIANGLES)


def test_colours_of_vertices_are_read() -> None:
    scan = read_wavefront(samples.write_obj(coloured=True, textured=False), Companions())
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.colours, samples.colours())


def test_points_without_faces_are_a_cloud() -> None:
    data = b"\n".join(line for line in samples.write_obj().splitlines() if not line.startswith(b"f "))
    assert read_wavefront(data, Companions()).triangles is None


def test_polygons_become_fans_and_lines_go_on_after_a_backslash() -> None:
    points = "\n".join(f"v {x!r} {y!r} {z!r}" for x, y, z in POINTS.tolist())
    data = f"{points}\nf 1 2 3\nf 1/1 2/2/ 3//7 \\\n 4 5\n f 6 7 8 9 # not a corner".replace(" # not a corner", "")
    np.testing.assert_array_equal(
        read_wavefront(data.encode(), Companions()).triangles,
        [[0, 1, 2], [0, 1, 2], [0, 2, 3], [0, 3, 4], [5, 6, 7], [5, 7, 8]],
    )


def test_two_materials_share_one_picture_and_each_corner_keeps_its_colour() -> None:
    """Half of the ball is of the picture, half plain: each corner's pixel in the joined picture is that of its own."""
    lines = samples.write_obj().splitlines()
    faces = [at for at, line in enumerate(lines) if line.startswith(b"f ")]
    lines.insert(faces[100], b"usemtl plain")
    library = samples.MATERIAL + b"newmtl plain\nKd 1 0 0\n"
    scan = read_wavefront(b"\n".join(lines), Companions((BESIDE | {"ball.mtl": library}).get))
    assert scan.texture is not None
    assert scan.texcoords is not None
    rows, columns = scan.texture.shape[:2]
    at = np.minimum((scan.texcoords * [columns, rows]).astype(int), [columns - 1, rows - 1])
    seen = scan.texture[at[..., 1], at[..., 0]]
    own = np.minimum((samples.texcoords() * [5, 6]).astype(int), [4, 5])
    np.testing.assert_array_equal(seen[:100], samples.picture()[own[:100, :, 1], own[:100, :, 0]])
    np.testing.assert_array_equal(seen[100:], np.broadcast_to([255, 0, 0], (152, 3, 3)))


@pytest.mark.parametrize("missing", ["ball.mtl", "head.png"])
def test_what_does_not_lie_beside_it_is_told(missing: str) -> None:
    beside = Companions({name: data for name, data in BESIDE.items() if name != missing}.get)
    assert read_wavefront(samples.write_obj(), beside).texture is None
    assert missing in beside.notes[0]


OBJ = samples.write_obj(textured=False)


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"hello", "no OBJ with vertices, but text"),
        (OBJ + b"\nv 1 2", "'v 1 2' is no vertex"),
        (OBJ + b"\nv 1 2 two", "'two', which is no number"),
        (OBJ + b"\nv 1e7 2 3", "move the scan to the origin"),
        (OBJ + b"\nf 1 2 129", "'f 1 2 129' names a corner that is not among the 128"),
        (OBJ + b"\nf 0 2 3", "names a corner"),
        (OBJ + b"\nf -129 2 3", "names a corner"),
        (OBJ + b"\nf 1.5 2 3", "no whole numbers"),
        (OBJ + b"\nf 1e99 2 3", "no whole numbers"),
        (OBJ + b"\nf 1/2/3/4 2 3", "no row of corners"),
        (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "3 usable points; expected at least 100"),
    ],
)
def test_what_is_wrong_is_refused_with_a_sentence(data: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_wavefront(data, Companions())


def dressed(text: str, marks: tuple[str, str, str, str, str], encoding: str) -> bytes:
    """A text as other programs write it: with another blank, end of lines, a comment in each line and between lines,
    broken lines, marks of byte order before it and before what was added."""
    blank, end, comment, between, broken = marks
    lines = []
    for at, line in enumerate(text.splitlines()):
        words = line.split()
        numbered = words[0] in ("v", "vt", "vn", "f")
        gap = broken if numbered and at % 3 == 0 else blank
        mark = "\ufeff" if at in (0, 40, 400) and encoding == "utf-8" else ""
        lines += [mark + blank * (at % 2) + blank.join([words[0], gap.join(words[1:])]) + comment, between]
    written = end.join(lines).replace("\n", end)
    return written.encode(encoding) if encoding == "utf-8" else codecs.BOM_UTF16_LE + written.encode(encoding)


DRESS = st.tuples(
    st.sampled_from([" ", "\t", " \t "]), st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from(["", " # said by nobody", "\t# v 9 9 9", " #"]), st.sampled_from(["", "# f 1 2 3", "  # end\\"]),
    st.sampled_from([" ", "\t", " \\\n ", "\\ \n"]),
)  # fmt: skip


@given(DRESS, st.sampled_from(["utf-8", "utf-16-le"]))
def test_a_mesh_is_the_same_however_its_text_is_dressed(marks: tuple[str, str, str, str, str], encoding: str) -> None:
    """Tabs, all ends of lines, comments anywhere, lines that go on, marks of byte order: in mesh and material."""
    library = dressed(samples.MATERIAL.decode(), (*marks[:4], " "), "utf-8")
    beside = Companions((BESIDE | {"ball.mtl": library}).get)
    data = dressed(samples.write_obj(coloured=True).decode(), marks, encoding)
    scan = read_wavefront(data, beside)
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.triangles, TRIANGLES)
    np.testing.assert_array_equal(scan.colours, samples.colours())
    np.testing.assert_array_equal(scan.texture, samples.picture())
    (piece,) = read_obj_pieces(data)
    np.testing.assert_array_equal(piece.points, POINTS)
    assert beside.notes == []


def test_names_of_objects_end_before_a_comment() -> None:
    first, second = read_obj_pieces(b"o\tskin # the face\nv 1 2 3\nO eye_left\t# his left\nV 4,5 5 6 # 7\n")
    assert (first.name, second.name) == ("skin", "eye_left")
    np.testing.assert_array_equal(second.points, [[4.5, 5, 6]])


def test_names_with_signs_of_comments_in_them_are_whole() -> None:
    library = b"newmtl Material #25\nKd 0 0 1\nnewmtl Material #26\nmap_Kd head #1.png\n"
    data = samples.write_obj().replace(b"usemtl skin", b"usemtl Material #26")
    beside = Companions({"ball.mtl": library, "head #1.png": samples.picture_bytes()}.get)
    np.testing.assert_array_equal(read_wavefront(data, beside).texture, samples.picture())
    assert beside.notes == []


def test_decimal_commas_are_decimals() -> None:
    lines = samples.write_obj().split(b"\r\n")
    data = b"\n".join(line.replace(b".", b",") if line[:1] == b"v" else line for line in lines)
    np.testing.assert_array_equal(read_wavefront(data, Companions(BESIDE.get)).positions, POINTS)
    with pytest.raises(ValueError, match=r"'1,2,3'"):
        read_wavefront(data + b"\nv 1,2,3 4 5", Companions())


@given(st.sets(st.integers(0, len(POINTS) - 1), max_size=5), st.sampled_from(["", "1.5 1.5 1.5"]))
def test_vertices_without_a_colour_cost_no_other_one_its_own(bare: set[int], shine: str) -> None:
    """Colours of others stay; brighter than white is white, and makes nothing else darker."""
    tones = samples.colours() / 255.0
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in POINTS.tolist()]
    lines = [
        line if at in bare else f"{line} {r!r} {g!r} {b!r}"
        for at, (line, (r, g, b)) in enumerate(zip(lines, tones.tolist(), strict=True))
    ]
    beside = Companions()
    end = [f"v 0 0 0 {shine}"] if shine else []
    scan = read_wavefront("\n".join([*lines, *end]).encode(), beside)
    expected = samples.colours()
    expected[[*bare]] = 255
    assert scan.colours is not None
    np.testing.assert_array_equal(scan.colours[: len(POINTS)], expected)
    assert beside.notes == (
        [f"{len(bare)} of its {len(lines + end)} vertices have no colour: they are white"] if bare else []
    )


def test_directions_behind_vertices_are_no_colours_and_it_is_said() -> None:
    lines = [" ".join(map(repr, ["v", *point, *point])).replace("'", "") for point in POINTS.tolist()]
    beside = Companions()
    assert read_wavefront("\n".join(lines).encode(), beside).colours is None
    assert beside.notes == ["the numbers behind its vertices are no colours: they are left out"]


@given(st.integers(1, 64))
def test_colours_that_are_kept_in_comments_are_read(each: int) -> None:
    """As ZBrush writes them: some vertices a row, a mask before each colour."""
    hexes = ["ff" + bytes(tone).hex() for tone in samples.colours().tolist()]
    rows = ["#MRGB " + "".join(hexes[at : at + each]) for at in range(0, len(hexes), each)]
    data = samples.write_obj(textured=False) + "\r\n".join(["", *rows]).encode()
    np.testing.assert_array_equal(read_wavefront(data, Companions()).colours, samples.colours())


@given(st.integers(0, len(POINTS) - 1), st.sampled_from(["nan", "inf", "-1e999"]))
def test_a_vertex_that_is_no_number_costs_itself_and_is_said(at: int, bad: str) -> None:
    lines = samples.write_obj(textured=False).split(b"\r\n")
    rows = [row for row, line in enumerate(lines) if line[:2] == b"v "]
    lines[rows[at]] = f"v 1 2 {bad}".encode()
    beside = Companions()
    scan = read_wavefront(b"\n".join(lines), beside)
    np.testing.assert_array_equal(scan.positions, np.delete(POINTS, at, axis=0))
    assert scan.triangles is not None
    assert len(scan.triangles) == sum(at not in triangle for triangle in TRIANGLES.tolist())
    assert beside.notes == [f"1 of its 128 points are no numbers (the first is point {at}): they are left out"]
    with pytest.raises(ValueError, match=f"vertex {at + 1} is"):
        read_obj_pieces(b"\n".join(lines))
