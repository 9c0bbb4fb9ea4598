"""Any file as a scan: its bytes say what it is, and for others people are told what to do."""

import numpy as np
import pytest

from omote.interchange.scans.scan_reader import read_scan
from tests.interchange.scans import scan_samples as samples

POINTS, TRIANGLES = samples.ball()
MESHES = {
    ".ply": samples.write_ply("binary_big_endian"),
    ".obj": samples.write_obj(textured=False),
    ".stl": samples.write_stl(),
}


@pytest.mark.parametrize("suffix", MESHES)
def test_every_format_holds_the_same_surface(suffix: str) -> None:
    scan = read_scan(suffix.upper(), MESHES[suffix]).scan
    np.testing.assert_array_equal(scan.positions[scan.triangles], POINTS[TRIANGLES])


def test_bytes_say_more_than_a_name() -> None:
    assert read_scan(".obj", samples.write_ply()).scan.triangles is not None
    assert len(read_scan(".ply", samples.write_gltf(*samples.gltf_document())).scan.shapes) == 1


def test_what_could_not_be_used_is_told() -> None:
    assert read_scan(".ply", samples.write_ply(corners="face")).notes == (
        "its texture 'head.png' does not lie beside it: give both together",
    )


@pytest.mark.parametrize(
    ("suffix", "data", "sentence"),
    [
        (".ply", b"", "the file is empty; copy or export it anew"),
        (".ply", b" \n", "the file is empty"),
        (".ply", b"what a head\n", "no PLY, but text"),
        (".obj", b"PK\x03\x04...", "an archive .ZIP., which is not read here; unpack it"),
        (".jpg", samples.picture_bytes("JPEG"), "a picture .JPEG., which is not read here; a photograph has no shape"),
        (".ply", samples.picture_bytes(), "a picture .PNG., which is not read here; a photograph has no shape"),
        (".blend", b"BLENDER-v300", "a Blender file, which is not read here; in Blender, File > Export"),
        (".blend", b"(\xb5/\xfd\0\1\2", r"\(.blend\), which is not read here; in Blender, File > Export"),
        (".fbx", b"Kaydara FBX Binary", "an FBX file, which is not read here; export it as .glb or .obj"),
        (".usdz", b"PK\x03\x04...", "which is not read here; export it as .glb or .obj; scanning apps"),
        (".json", b"{}", "document of expressions or a recording: omote file import show.omote"),
        (".heic", b"\0\0\0\x18ftypheic", "a photograph has no shape"),
        (".mp3", b"ID3\0\0", r"\(.mp3\), which is not read here; export it as one of .ply, .obj"),
        ("", b"hello", r"text \(no suffix\), which is not read here"),
    ],
)
def test_other_files_are_refused_with_what_to_do(suffix: str, data: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_scan(suffix, data)
