"""Pieces of glTF scenes: colours, names of targets."""

import copy

import numpy as np

from omote.interchange.formats.gltf_document import node_places, parse_document_as
from omote.interchange.scans.gltf_scan import SceneDocument, ScenePiece, SceneReader
from tests.interchange.scans import scan_samples as samples


def only_piece(document: dict[str, object], body: bytes) -> ScenePiece:
    """The piece of the ball's node."""
    text = samples.write_gltf(document, b"", binary=False)
    parsed = parse_document_as(SceneDocument, text)
    (piece,) = SceneReader(parsed, (body,)).pieces(1, node_places(parsed))
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
