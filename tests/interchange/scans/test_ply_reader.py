"""PLY files: clouds and meshes, text and both orders of bytes, with colours and textures; all others are refused."""

import codecs

import numpy as np
import pytest

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.ply_reader import read_ply
from tests.interchange.scans import scan_samples as samples

BESIDE = {"head.png": samples.picture_bytes()}
POINTS, TRIANGLES = samples.ball()


@pytest.mark.parametrize("order", samples.ORDERS)
@pytest.mark.parametrize("coloured", ["", "uchar", "float"])
def test_a_mesh_comes_back_as_it_was_written(order: str, coloured: str) -> None:
    scan = read_ply(samples.write_ply(order, coloured=coloured), Companions())
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.triangles, TRIANGLES)
    if coloured:
        np.testing.assert_array_equal(scan.colours, samples.colours())
    else:
        assert scan.colours is None


@pytest.mark.parametrize("order", samples.ORDERS)
def test_a_cloud_has_no_triangles(order: str) -> None:
    scan = read_ply(samples.write_ply(order, cloud=True, coloured="uchar"), Companions())
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.colours, samples.colours())
    assert scan.triangles is None


@pytest.mark.parametrize("order", samples.ORDERS)
def test_polygons_of_several_lengths_become_fans(order: str) -> None:
    """The first triangle gets its first corner once more: the second triangle of its fan has no area and goes."""
    scan = read_ply(samples.write_ply(order, quads=True), Companions())
    np.testing.assert_array_equal(scan.triangles, TRIANGLES)


@pytest.mark.parametrize("order", samples.ORDERS)
@pytest.mark.parametrize("quads", [False, True])
def test_the_texture_of_faces_comes_with_its_picture(order: str, quads: bool) -> None:
    scan = read_ply(samples.write_ply(order, corners="face", quads=quads), Companions(BESIDE.get))
    np.testing.assert_array_equal(scan.texture, samples.picture())
    assert scan.texcoords is not None
    np.testing.assert_allclose(scan.texcoords, samples.texcoords(), atol=1e-6)


def test_doubled_points_of_a_texture_are_joined() -> None:
    corners = POINTS[TRIANGLES].reshape(-1, 3)
    uv = samples.texcoords().reshape(-1, 2)
    head = ["ply", "format ascii 1.0", "comment TextureFile head.png", f"element vertex {len(corners)}"]
    head += [f"property float {name}" for name in "xyzst"]
    head += [f"element face {len(TRIANGLES)}", "property list uchar int vertex_index", "end_header"]
    rows = [" ".join(map(repr, [*p, u, 1 - v])) for p, (u, v) in zip(corners.tolist(), uv.tolist(), strict=True)]
    rows += [f"3 {3 * at} {3 * at + 1} {3 * at + 2}" for at in range(len(TRIANGLES))]
    scan = read_ply("\n".join(head + rows).encode(), Companions(BESIDE.get))
    assert scan.triangles is not None
    assert scan.texcoords is not None
    assert len(scan.positions) == len(POINTS)
    np.testing.assert_array_equal(scan.positions[scan.triangles], POINTS[TRIANGLES])
    np.testing.assert_allclose(scan.texcoords, samples.texcoords(), atol=1e-9)


def test_a_texture_that_is_missing_is_told_and_the_shape_stays() -> None:
    beside = Companions()
    scan = read_ply(samples.write_ply(corners="face"), beside)
    assert scan.texture is None
    assert len(scan.positions) == len(POINTS)
    assert beside.notes == ["its texture 'head.png' does not lie beside it: give both together"]


def test_points_that_a_scanner_did_not_see_go_from_a_cloud() -> None:
    head, _, body = samples.write_ply(cloud=True).partition(b"end_header\n")
    lines = body.splitlines()
    lines[5] = b"nan nan nan"
    scan = read_ply(head + b"end_header\n" + b"\n".join(lines), Companions())
    np.testing.assert_array_equal(scan.positions, np.delete(POINTS, 5, axis=0))


def test_strips_of_range_scanners_become_triangles() -> None:
    head = ["ply", "format ascii 1.0", f"element vertex {len(POINTS)}", *(f"property float {n}" for n in "xyz")]
    head += ["element tristrips 1", "property list int int vertex_indices", "end_header"]
    rows = [" ".join(map(repr, point)) for point in POINTS.tolist()]
    scan = read_ply("\n".join([*head, *rows, "9 0 1 2 3 -1 4 5 6 7"]).encode(), Companions())
    np.testing.assert_array_equal(scan.triangles, [[0, 1, 2], [2, 1, 3], [4, 5, 6], [6, 5, 7]])


@pytest.mark.parametrize("order", samples.ORDERS)
def test_names_may_have_capitals_and_a_text_its_mark(order: str) -> None:
    data = samples.write_ply(order, coloured="uchar", corners="face")
    head, end, body = data.partition(b"end_header")
    for name in (b"vertex 128", b"vertex_indices", b"red", b"green", b"blue", b"face 252", b"texcoord", b"float x"):
        head = head.replace(name, name.title() if b" " not in name else name[:-1] + name[-1:].upper())
    head = head.replace(b"element vertex", b"element Vertex").replace(b"TextureFile", b"texturefile")
    scan = read_ply(codecs.BOM_UTF8 + head + end + body, Companions(BESIDE.get))
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.colours, samples.colours())
    np.testing.assert_array_equal(scan.texture, samples.picture())


def with_faces(properties: list[str], rows: list[str], *comments: str) -> bytes:
    """The ball as text whose faces say more than their corners."""
    head, _, body = samples.write_ply().partition(b"end_header\n")
    lines = [f"{line} {more}" for line, more in zip(body.decode().splitlines()[len(POINTS) :], rows, strict=True)]
    text = head.decode().replace("ply\n", "ply\n" + "".join(f"comment {each}\n" for each in comments), 1)
    text = text.replace("comment TextureFile head.png\n", "")
    said = "".join(f"property {each}\n" for each in properties)
    return "\n".join([text + said + "end_header", *body.decode().splitlines()[: len(POINTS)], *lines]).encode()


def test_colours_that_faces_alone_have_are_those_of_the_vertices_around() -> None:
    half = POINTS[TRIANGLES].mean(axis=1)[:, 2] > 0
    data = with_faces(
        [f"uchar {name}" for name in ("red", "green", "blue")], ["255 0 0" if up else "0 0 255" for up in half]
    )
    scan = read_ply(data, Companions())
    assert scan.colours is not None
    inside = np.array([len(set(half[np.any(np.equal(TRIANGLES, at), axis=1)])) == 1 for at in range(len(POINTS))])
    np.testing.assert_array_equal(scan.colours[inside, 0], np.where(POINTS[inside, 2] > 0, 255, 0))
    np.testing.assert_allclose(scan.colours.astype(int).sum(axis=1), 255, atol=1)


def test_each_face_has_the_picture_that_it_names() -> None:
    """Two pictures of one colour each, and faces of either by turns."""
    red, blue = (np.full((6, 5, 3), tone, np.uint8) for tone in ([255, 0, 0], [0, 0, 255]))
    beside = {"a.png": samples.picture_bytes(pixels=red), "b c.png": samples.picture_bytes(pixels=blue)}
    rows = [f"6 .1 .1 .9 .1 .9 .9 {at % 2}" for at in range(len(TRIANGLES))]
    data = with_faces(["list uchar float texcoord", "int texnumber"], rows, "TextureFile a.png", "TextureFile b c.png")
    scan = read_ply(data, Companions(beside.get))
    assert scan.texture is not None
    assert scan.texcoords is not None
    high, wide = scan.texture.shape[:2]
    middle = (scan.texcoords.mean(axis=1) * [wide, high]).astype(int)
    seen = scan.texture[middle[:, 1], middle[:, 0]]
    np.testing.assert_array_equal(seen, np.where(np.arange(len(seen))[:, None] % 2, [0, 0, 255], [255, 0, 0]))


def test_points_that_are_no_numbers_cost_their_faces_and_are_said() -> None:
    lines = samples.write_ply().split(b"\n")
    lines[lines.index(b"end_header") + 1 + 5] = b"nan 0 0"
    beside = Companions()
    scan = read_ply(b"\n".join(lines), beside)
    np.testing.assert_array_equal(scan.positions, np.delete(POINTS, 5, axis=0))
    assert scan.triangles is not None
    assert len(scan.triangles) == sum(5 not in triangle for triangle in TRIANGLES.tolist())
    assert beside.notes == ["1 of its 128 points are no numbers (the first is point 5): they are left out"]


BINARY = samples.write_ply("binary_little_endian")
TEXT = samples.write_ply()


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"hello", "no PLY, but text"),
        (TEXT[:60], "no end"),
        (TEXT.replace(b"ascii", b"utf8"), "the format 'utf8 1.0'; expected one of ascii"),
        (TEXT.replace(b"format ascii 1.0\n", b""), "names no format"),
        (TEXT.replace(b"property float x", b"property string x"), "'property string x'; expected property"),
        (TEXT.replace(b"list uchar int", b"list float int"), "counts a list by float"),
        (TEXT.replace(b"element vertex 128", b"element vertex many"), "expected element, a name and a count"),
        (TEXT.replace(b"element vertex 128", b"element vertex 6000000"), "6000000 vertex; expected 5000000 at most"),
        (TEXT.replace(b"element vertex 128", b"element vertex 4000000"), "does not hold them"),
        (TEXT.replace(b"property float z", b"property float w"), "no vertices with x, y and z"),
        (TEXT[:-40], "does not hold them"),
        (TEXT[:-4] + b"9999\n", "names points 0 to 9999"),
        (TEXT[:-4] + b"some\n", "'some', which is no number"),
        (BINARY[:-4], "does not hold them"),
        (BINARY.replace(b"face 252", b"face 253"), "does not hold them"),
    ],
)
def test_what_is_wrong_is_refused_with_a_sentence(data: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_ply(data, Companions())
