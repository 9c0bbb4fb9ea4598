"""Base colours of materials, wherever their pictures lie."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.formats.gltf_document import AccessorReader, parse_document_as
from omote.interchange.formats.gltf_scene import find_nothing, read_uri
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_materials import SPECULAR, UNREAD_PICTURES, WEBP, SceneDocument, material_pictures
from omote.interchange.scans.gltf_scan import read_gltf
from omote.model.albedo import decode_light, encode_light
from omote.model.fitting.scan import Scan
from tests.interchange.formats.gltf_files import ball_file
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
    assert read_uri("data:;base64,aGVsbG8=", find_nothing) == b"hello"
    for uri in ("data:,hello", "data:;base64,aGVsbG8", "data:;base64,\xe9"):
        with pytest.raises(ValueError, match="export it"):
            read_uri(uri, find_nothing)


UV = np.random.default_rng(9).random((len(samples.ball()[0]), 2))


def coloured_ball(uv: np.ndarray, material: dict[str, Any], **said: Any) -> tuple[Scan, list[str]]:
    """The ball with a picture and texture coordinates in floats, and what is said of it."""
    beside = Companions({"head.png": PNG}.get)
    sets = {f"TEXCOORD_{at}": values.astype("<f4") for at, values in enumerate(uv)}
    textures = said.pop("textures", [{"source": 0}])
    data = ball_file(attributes=sets, materials=[material], textures=textures, images=[{"uri": "head.png"}], **said)
    return read_gltf(data, beside), beside.notes


def placed(scan: Scan) -> np.ndarray:
    """The texture coordinates of a scan that has some."""
    assert scan.texcoords is not None
    return scan.texcoords


def corners(uv: np.ndarray) -> np.ndarray:
    """Texture coordinates of vertices at the corners of the ball's triangles."""
    return uv[samples.ball()[1]]


def textured(**info: Any) -> dict[str, Any]:
    """A material of the picture."""
    return {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0} | info}}


@given(st.floats(0.05, 2.0), st.floats(0.05, 2.0), st.floats(-3.0, 3.0), st.floats(-2.0, 2.0), st.booleans())
def test_a_texture_transform_leads_back_to_the_picture(
    wide: float, high: float, turn: float, shift: float, other: bool
) -> None:
    """Coordinates that are packed by the inverse of any transform come back: offset, rotation, scale, other set."""
    sine, cosine = np.sin(turn), np.cos(turn)
    matrix = np.array([[cosine, sine], [-sine, cosine]]) * [wide, high]  # as the extension's page has it
    packed = (UV - [shift, 0.25]) @ np.linalg.inv(matrix).T
    said = {"offset": [shift, 0.25], "rotation": turn, "scale": [wide, high]} | ({"texCoord": 1} if other else {})
    sets = np.stack([UV * 0.0, packed] if other else [packed])
    scan, notes = coloured_ball(sets, textured(extensions={"KHR_texture_transform": said}))
    np.testing.assert_allclose(placed(scan), corners(UV), atol=1e-4)
    np.testing.assert_array_equal(scan.texture, samples.picture())
    assert notes == []


def test_edges_of_a_picture_that_do_not_repeat_hold_what_is_beyond_them() -> None:
    beyond = UV[None] * 0.2 + [1.5, -0.7]
    kept = {"textures": [{"source": 0, "sampler": 0}]}
    clamped, _ = coloured_ball(beyond, textured(), samplers=[{"wrapS": 33071, "wrapT": 33071}], **kept)
    np.testing.assert_allclose(placed(clamped), corners(np.tile([1.0, 0.0], (len(UV), 1))), atol=1e-6)
    mirrored, _ = coloured_ball(beyond, textured(), samplers=[{"wrapS": 33648, "wrapT": 33648}], **kept)
    np.testing.assert_allclose(placed(mirrored), corners([2.0, 0.0] + beyond[0] * [-1.0, -1.0]), atol=1e-6)


@pytest.mark.parametrize("name", ["EXT_texture_webp", "EXT_texture_avif"])
def test_pictures_of_extensions_are_pictures(name: str) -> None:
    textures = [{"extensions": {name: {"source": 0}}}]
    scan, notes = coloured_ball(UV[None], textured(), textures=textures, extensionsRequired=[name])
    np.testing.assert_array_equal(scan.texture, samples.picture())
    assert notes == []


@pytest.mark.parametrize(("name", "kind"), UNREAD_PICTURES.items())
def test_a_picture_of_a_kind_that_is_not_read_is_said_and_its_other_kind_is_read(name: str, kind: str) -> None:
    only = [{"extensions": {name: {"source": 0}}}]
    scan, notes = coloured_ball(UV[None], textured(), textures=only, extensionsRequired=[name])
    assert scan.texture is None
    assert len(notes) == 1
    assert f"a texture of it is {kind} ({name})" in notes[0]
    scan, notes = coloured_ball(UV[None], textured(), textures=[only[0] | {"source": 0}])
    np.testing.assert_array_equal(scan.texture, samples.picture())
    assert notes == []


def test_the_older_kind_of_materials_has_its_colour() -> None:
    older = {"diffuseTexture": {"index": 0}, "diffuseFactor": [1, 1, 1, 0.5]}
    scan, notes = coloured_ball(UV[None], {"extensions": {SPECULAR: older}})
    np.testing.assert_array_equal(scan.texture, samples.picture())
    np.testing.assert_allclose(placed(scan), corners(UV), atol=1e-6)
    assert notes == []


def test_a_picture_is_multiplied_by_the_colour_of_its_material_in_linear_light() -> None:
    material = textured()
    material["pbrMetallicRoughness"]["baseColorFactor"] = [0.5, 1.0, 0.0, 1.0]
    scan, _ = coloured_ball(UV[None], material)
    assert scan.texture is not None
    plain = samples.picture()
    expected = encode_light(decode_light(plain) * np.array([0.5, 1.0, 0.0]))
    np.testing.assert_allclose(scan.texture.astype(int), expected.astype(int), atol=1)
    np.testing.assert_array_equal(scan.texture[..., 1], plain[..., 1])


def test_a_mesh_without_texture_coordinates_takes_no_corner_of_the_picture() -> None:
    scan, notes = coloured_ball(UV[:0], textured())
    assert scan.texture is None
    assert notes == ["a mesh of it has a picture and no texture coordinates, so it has no colours"]
