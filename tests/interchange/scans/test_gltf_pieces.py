"""Pieces of glTF scenes: colours, names of targets."""

import copy

import numpy as np
import pytest

from omote.interchange.formats.gltf_document import node_places, parse_document_as
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_materials import SceneDocument
from omote.interchange.scans.gltf_scan import ScenePiece, SurfaceReader, read_gltf
from omote.model.albedo import encode_light
from tests.interchange.formats.gltf_files import ball_file
from tests.interchange.scans import scan_samples as samples


def only_piece(document: dict[str, object], body: bytes) -> ScenePiece:
    """The piece of the ball's node."""
    text = samples.write_gltf(document, b"", binary=False)
    parsed = parse_document_as(SceneDocument, text)
    (piece,) = SurfaceReader(parsed, (body,), Companions()).pieces(1, node_places(parsed))
    return piece


def test_colours_are_encoded_from_linear_light() -> None:
    document, body = samples.gltf_document()
    count = document["accessors"][0]["count"]
    tones = np.tile(np.array([0, 65535, 32768, 65535], "<u2"), (count, 1)).tobytes()
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(body), "byteLength": len(tones)})
    document["accessors"].append(
        {"bufferView": 5, "componentType": 5123, "normalized": True, "type": "VEC4", "count": count}
    )
    document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 4
    colours = only_piece(document, body + tones).colours
    assert colours is not None
    np.testing.assert_array_equal(colours, np.broadcast_to([0, 255, 188], (count, 3)))


def test_two_targets_of_one_name_are_told_apart() -> None:
    document, body = samples.gltf_document()
    changed = copy.deepcopy(document)
    changed["meshes"][0]["primitives"][0]["targets"] *= 3
    changed["meshes"][0]["extras"]["targetNames"] = ["a", "a", ""]
    assert list(only_piece(changed, body).moves) == ["a", "a 1", "target_2"]


TONES = np.random.default_rng(8).integers(0, 256, (len(samples.ball()[0]), 4))


@pytest.mark.parametrize("columns", [3, 4])
@pytest.mark.parametrize(("kind", "most"), [("u1", 255.0), ("<u2", 65535.0), ("<f4", 1.0)])
def test_colours_are_the_same_in_every_kind_of_number(kind: str, most: float, columns: int) -> None:
    """Whole numbers are parts of one whether or not the file says so: the format knows no other colours."""
    values = np.rint(TONES / 255.0 * most) if kind != "<f4" else TONES / 255.0
    data = ball_file(attributes={"COLOR_0": values[:, :columns].astype(kind)})
    colours = read_gltf(data, Companions()).colours
    assert colours is not None
    np.testing.assert_allclose(colours, encode_light(TONES[:, :3] / 255.0), atol=1)


def test_colours_that_cannot_be_read_cost_themselves() -> None:
    tones = (TONES[:, :3] / 255.0).astype("<f4")
    tones[5, 1] = np.nan
    colours = read_gltf(ball_file(attributes={"COLOR_0": tones}), Companions()).colours
    assert colours is not None
    assert colours[5, 1] == 255
    beside = Companions()
    scan = read_gltf(ball_file(attributes={"COLOR_0": tones[:9]}), beside)
    assert scan.colours is None
    assert beside.notes == [
        "colours of its vertices cannot be read (COLOR_0 has 9 rows and its mesh 128 vertices; export it anew)"
    ]
