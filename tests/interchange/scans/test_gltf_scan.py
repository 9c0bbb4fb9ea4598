"""glTF files: what a viewer shows at rest as one scan, with its picture and its targets; all others are refused."""

import copy
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_scan import read_gltf
from omote.model.fitting.scan import Scan
from tests.interchange.scans import scan_samples as samples

POINTS, TRIANGLES = samples.ball()
Json = dict[str, Any]


def read_changed(change: Callable[[Json], object], **where: str) -> Scan:
    """The ball's scan, its document changed."""
    document, body = samples.gltf_document(**where)
    document = copy.deepcopy(document)
    change(document)
    return read_gltf(samples.write_gltf(document, body), Companions())


@pytest.mark.parametrize("where", ["binary", "data", "beside"])
def test_the_ball_comes_back_where_its_node_stands(where: str) -> None:
    document, body = samples.gltf_document(where=where)
    beside = {"ball 1.bin": body, "head.png": samples.picture_bytes()} if where == "beside" else {}
    scan = read_gltf(samples.write_gltf(document, body, binary=where == "binary"), Companions(beside.get))
    assert scan.triangles is not None
    assert scan.texcoords is not None
    assert len(scan.positions) == len(POINTS)
    np.testing.assert_allclose(scan.positions[scan.triangles], 2 * POINTS[TRIANGLES] + [0, 10, 0], atol=1e-6)
    np.testing.assert_array_equal(scan.texture, samples.picture())
    np.testing.assert_allclose(scan.texcoords, samples.texcoords(), atol=1e-7)
    moved = scan.shapes["jawOpen"][scan.triangles]
    np.testing.assert_allclose(moved, 2 * POINTS[TRIANGLES] * [0, 0.5, 0], atol=1e-6)


def test_a_node_outside_the_scene_is_not_read_unless_there_is_no_scene() -> None:
    assert len(read_changed(lambda d: None).positions) == len(POINTS)
    assert len(read_changed(lambda d: d.pop("scenes")).positions) == 2 * len(POINTS)


def test_names_of_targets_stand_where_vrm_0_has_them() -> None:
    def moved(document: Json) -> None:
        document["meshes"][0]["primitives"][0]["extras"] = document["meshes"][0].pop("extras")

    assert list(read_changed(moved).shapes) == ["jawOpen"]


def test_a_skin_at_rest_places_its_mesh_and_its_node_does_not() -> None:
    """Every vertex hangs at one joint that stands at (0, 0, 3): the mesh stands there, in its own size."""
    document, body = samples.gltf_document()
    count = len(TRIANGLES) * 3
    joints = np.zeros((count, 4), "<u2").tobytes()
    weights = np.tile(np.array([1, 0, 0, 0], "<f4"), (count, 1)).tobytes()
    at = len(body)
    views = document["bufferViews"]
    body += joints + weights
    views += [{"buffer": 0, "byteOffset": at, "byteLength": len(joints)}]
    views += [{"buffer": 0, "byteOffset": at + len(joints), "byteLength": len(weights)}]
    document["buffers"][0]["byteLength"] = len(body)
    document["accessors"] += [
        {"bufferView": 5, "componentType": 5123, "type": "VEC4", "count": count},
        {"bufferView": 6, "componentType": 5126, "type": "VEC4", "count": count},
    ]
    document["meshes"][0]["primitives"][0]["attributes"] |= {"JOINTS_0": 4, "WEIGHTS_0": 5}
    document["nodes"] += [{"translation": [0, 0, 3]}]
    document["skins"] = [{"joints": [3]}]
    document["nodes"][1]["skin"] = 0
    scan = read_gltf(samples.write_gltf(document, body), Companions())
    np.testing.assert_allclose(scan.positions[scan.triangles], POINTS[TRIANGLES] + [0, 0, 3], atol=1e-6)


def test_strips_and_fans_are_triangles_of_the_same_side() -> None:
    def of_mode(mode: int) -> Scan:
        return read_changed(lambda d: d["meshes"][0]["primitives"][0].update(mode=mode))

    corners = 2 * POINTS[TRIANGLES].reshape(-1, 3) + [0, 10, 0]
    strip = of_mode(5)
    fan = of_mode(6)
    assert strip.triangles is not None
    assert fan.triangles is not None
    np.testing.assert_allclose(strip.positions[strip.triangles[0]], corners[[0, 1, 2]], atol=1e-6)
    joined = {tuple(np.round(corner, 3).tolist()) for corner in fan.positions[fan.triangles][:, 2]}
    assert joined == {tuple(np.round(corners[0], 3).tolist())}


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda d: d.update(extensionsRequired=["KHR_draco_mesh_compression"]), "compressed"),
        (lambda d: d["scenes"][0].update(nodes=[]), "shows no mesh"),
        (lambda d: d["accessors"][0].update(count=6_000_000), "6000000 points; expected 5000000"),
        (lambda d: d["accessors"][2].update(count=40_000_000), "triangles; expected"),
        (lambda d: d["meshes"][0]["primitives"][0].update(targets=[{"POSITION": 3}] * 20_000), "numbers of morph"),
        (lambda d: d["accessors"][2].update(bufferView=0, count=9), "names vertices|not finite|no whole"),
        (lambda d: d["accessors"][3].update(count=5), "5 rows and its mesh 756"),
        (lambda d: d["buffers"][0].update(uri="../secret.bin"), "does not lie beside it"),
        (lambda d: d["buffers"][0].update(uri="data:text/plain,hello"), "expected base64"),
        (lambda d: d["buffers"][0].update(uri="data:text/plain;base64,???"), "is damaged"),
        (lambda d: d["nodes"][1].update(skin=0), None),
    ],
)
def test_what_is_wrong_is_refused_with_a_sentence(change: Callable[[Json], object], sentence: str | None) -> None:
    if sentence is None:  # a skin without weights places nothing
        assert len(read_changed(change).positions) == len(POINTS)
        return
    with pytest.raises(ValueError, match=sentence):
        read_changed(change)


def test_a_picture_that_is_damaged_is_told_and_the_shape_stays() -> None:
    document, body = samples.gltf_document(where="data")
    document["images"] = [{"uri": "data:image/png;base64,aGVsbG8="}]
    beside = Companions()
    assert read_gltf(samples.write_gltf(document, body, binary=False), beside).texture is None
    assert "no picture, but text" in beside.notes[0]
