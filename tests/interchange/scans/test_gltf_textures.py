"""Base colours of materials, wherever their pictures lie."""

import base64
import json

import numpy as np
import pytest

from omote.interchange.formats.gltf_document import AccessorReader, parse_document_as
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_scan import WEBP, SceneDocument, material_pictures, read_uri
from tests.interchange.scans import scan_samples as samples

PNG = samples.picture_bytes()


def test_pictures_come_from_the_buffer_from_beside_and_from_the_uri() -> None:
    images = [{"bufferView": 0}, {"uri": "a%20b.png"}, {"uri": "data:;base64," + base64.b64encode(PNG).decode()}]
    textures = [{"source": 0}, {"source": 1}, {"source": 9, "extensions": {WEBP: {"source": 2}}}]
    document = {
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": at}}} for at in range(3)]
        + [{"pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1]}}],
        "textures": textures,
        "images": images,
        "bufferViews": [{"buffer": 0, "byteOffset": 3, "byteLength": len(PNG)}],
    }
    parsed = parse_document_as(SceneDocument, json.dumps(document).encode())
    beside = Companions({"a b.png": PNG}.get)
    found = material_pictures(parsed, AccessorReader(parsed, (b"abc" + PNG,)), beside)
    for picture in found[:3]:
        np.testing.assert_array_equal(picture, samples.picture())
    np.testing.assert_array_equal(found[3][0, 0], [0, 255, 0])
    assert beside.notes == []


def test_bytes_in_a_uri_are_base64() -> None:
    assert read_uri("data:;base64,aGVsbG8=", Companions()) == b"hello"
    for uri in ("data:,hello", "data:;base64,aGVsbG8", "data:;base64,\xe9"):
        with pytest.raises(ValueError, match="export it"):
            read_uri(uri, Companions())
