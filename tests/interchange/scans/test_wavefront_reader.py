"""OBJ files: polygons, corners from either end, colours and textures by material; all others are refused."""

import numpy as np
import pytest

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.wavefront_reader import read_wavefront
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
