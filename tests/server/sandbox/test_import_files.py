"""What files bring: each kind by its own reader, with a sentence about each thing."""

from pathlib import Path

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.edit.store.import_items import make_document
from omote.interchange.export_face import named_compound_meshes
from omote.interchange.formats.expression_json import encode
from omote.model.cast import Cast
from omote.server.sandbox.import_files import expressions_from, faces_from
from tests.interchange.formats.scenes import head_glb


@pytest.fixture(scope="module")
def built_in() -> Cast:
    """The built-in cast."""
    return load_cast()


def as_obj(points: np.ndarray) -> bytes:
    """Vertices as an OBJ file."""
    return "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()).encode()


def test_a_document_brings_its_expression(built_in: Cast, tmp_path: Path) -> None:
    path = tmp_path / "s.json"
    path.write_bytes(encode(make_document(built_in.space, "Sm", ["t"], built_in.expressions["smile"])))
    ((arrival, sentence),) = expressions_from(built_in, [path])
    assert (arrival.label, arrival.tags, sentence) == ("Sm", ("t",), "Sm, from s.json")


def test_heads_bring_their_targets(built_in: Cast, tmp_path: Path) -> None:
    rest = built_in.faces["dog"].positions.astype(np.float64)
    moved = named_compound_meshes(built_in, "dog", "smile")["skin"] - rest
    path = tmp_path / "dog.glb"
    path.write_bytes(head_glb("skin", rest, {"grin": moved}))
    ((arrival, sentence),) = expressions_from(built_in, [path])
    assert arrival.label == "grin"
    assert sentence.startswith("grin, taken from dog")


def test_a_head_at_rest_is_a_face(built_in: Cast, tmp_path: Path) -> None:
    path = tmp_path / "Aunt.obj"
    path.write_bytes(as_obj(built_in.faces["kaori"].positions.astype(np.float64)))
    for look, expected in (("", "kaori"), ("dog", "dog")):
        ((arrival, sentence),) = faces_from(built_in, [path], look=look)
        assert sentence == "Aunt, a face"
        assert isinstance(arrival.made, tuple)
        face, worn = arrival.made
        assert worn == built_in.looks[expected]
        np.testing.assert_array_equal(face.positions, built_in.faces["kaori"].positions)


def test_what_is_not_there_is_refused(built_in: Cast, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="there is no file"):
        list(expressions_from(built_in, [tmp_path / "a.json"]))
    (tmp_path / "a.json").write_bytes(b"{}")
    with pytest.raises(ValueError, match=r"a\.json: it is JSON of another program; expected an expression of Omote"):
        list(expressions_from(built_in, [tmp_path / "a.json"]))
