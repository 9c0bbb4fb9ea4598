"""Extensions that a document needs: what packs numbers is refused by its name, what changes no shape is read."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.gltf_extensions import COMPRESSED, DRACO
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_scan import read_gltf
from tests.interchange.formats.gltf_files import Arrays, ball_file
from tests.interchange.scans import scan_samples as samples

POINTS, TRIANGLES = samples.ball()
Read = Callable[[bytes, Companions], Any]


def as_pieces(data: bytes, beside: Companions) -> Any:
    """What an import reads."""
    return read_glb(data, note=beside.note)


@pytest.mark.parametrize("read", [read_gltf, as_pieces])
@pytest.mark.parametrize("name", COMPRESSED)
def test_packed_numbers_are_refused_by_the_name_of_the_extension(read: Read, name: str) -> None:
    with pytest.raises(ValueError, match=f"needs {name}: its numbers are compressed .* export it without compression"):
        read(ball_file(extensionsRequired=[name]), Companions())


@pytest.mark.parametrize("read", [read_gltf, as_pieces])
def test_packed_numbers_are_refused_where_the_file_does_not_say_that_it_needs_them(read: Read) -> None:
    """A primitive of Draco has accessors without bytes, which would all be zero; meshopt has buffers without."""
    arrays = Arrays()
    position = arrays.add(POINTS.astype("<f4"))
    del arrays.document["accessors"][position]["bufferView"]
    primitive = {"attributes": {"POSITION": position}, "extensions": {DRACO: {"bufferView": 0}}}
    meshes = {"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}]}
    with pytest.raises(ValueError, match=DRACO):
        read(arrays.written(**meshes), Companions())
    name = "EXT_meshopt_compression"
    buffers = [*arrays.document["buffers"], {"byteLength": 8, "extensions": {name: {"fallback": True}}}]
    with pytest.raises(ValueError, match=f"{name}.*meshopt.*npx gltfpack -noq -i packed.glb -o plain.glb"):
        read(arrays.written(buffers=buffers), Companions())


@pytest.mark.parametrize("read", [read_gltf, as_pieces])
def test_what_changes_no_shape_is_read_and_an_unknown_one_is_said(read: Read) -> None:
    harmless = ["KHR_materials_unlit", "KHR_texture_basisu", "EXT_texture_webp", "KHR_mesh_quantization", "VRMC_vrm"]
    beside = Companions()
    read(ball_file(extensionsRequired=harmless), beside)
    assert beside.notes == []
    read(ball_file(extensionsRequired=["ACME_bones"]), beside)
    assert beside.notes == ["it needs ACME_bones, which is not read here: its shape may lack what that adds"]


@pytest.mark.parametrize("kind", ["i1", "u1", "<i2", "<u2"])
@pytest.mark.parametrize("normalized", [False, True])
def test_quantized_numbers_are_read_to_their_step(kind: str, normalized: bool) -> None:
    """KHR_mesh_quantization: whole numbers, brought back by the node; bytes at a stride of four."""
    info = np.iinfo(kind)
    low = float(info.min) if info.min and not normalized else -float(info.max) if info.min else 0.0
    step = 2.0 / (info.max - low)
    whole = np.rint((POINTS + 1.0) / step + low)
    padded = np.zeros((len(POINTS), 4), kind)
    padded[:, :3] = whole
    arrays = Arrays()
    position = arrays.add(padded)
    arrays.document["accessors"][position] |= {"type": "VEC3", "normalized": normalized}
    arrays.document["bufferViews"][0]["byteStride"] = padded.itemsize * 4
    indices = arrays.add(TRIANGLES.reshape(-1).astype("<u2"))
    scale = step * (info.max if normalized else 1.0)
    node = {"mesh": 0, "scale": [scale] * 3, "translation": [-1.0 - low * step] * 3}
    primitive = {"attributes": {"POSITION": position}, "indices": indices}
    data = arrays.written(
        nodes=[node], meshes=[{"primitives": [primitive]}], extensionsRequired=["KHR_mesh_quantization"]
    )
    (piece,) = read_glb(data)
    np.testing.assert_allclose(piece.points, POINTS, atol=0.51 * step)
    np.testing.assert_array_equal(read_gltf(data, Companions()).positions, piece.points)
