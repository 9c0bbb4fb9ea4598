"""cast.npz as arrays, and what is refused."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from omote import builtin, load_cast
from omote.builtin.castfile import FORMAT, cast_of, meshes_of
from omote.model.space.gain import Gain

Arrays = dict[str, NDArray[Any]]


@pytest.fixture
def arrays() -> Arrays:
    """The arrays of the baked file, to be changed."""
    with np.load(builtin.CAST, allow_pickle=False) as file:
        return dict(file)


def test_the_same_arrays_give_the_same_cast(arrays: Arrays) -> None:
    assert cast_of(arrays).digest == builtin.read_cast(builtin.CAST).digest


def test_fields_are_what_the_arrays_say(arrays: Arrays) -> None:
    names = [row["name"] for row in json.loads(arrays["about"].tobytes())["expressions"]]
    row = names.index("smile")
    smile = load_cast().expressions["smile"]
    np.testing.assert_array_equal(smile.dtheta, arrays["dtheta"][row])
    np.testing.assert_array_equal(smile.ratio, 1.0 + arrays["swell"][row].astype(np.float64))
    np.testing.assert_array_equal(smile.residual, arrays["residual"][row])


def test_gains_come_with_their_faces(arrays: Arrays) -> None:
    about = json.loads(arrays["about"].tobytes())
    about["gains"] = {"dog": [{"region": "ears", "value": 1.5, "expression": None}]}
    arrays["about"] = np.frombuffer(json.dumps(about).encode(), np.uint8)
    cast = cast_of(arrays)
    assert cast.faces["dog"].gains == (Gain("ears", 1.5),)
    assert not cast.faces["kaori"].gains
    assert cast.digest != load_cast().digest


def test_every_vertex_is_drawn(arrays: Arrays) -> None:
    cast = load_cast()
    skin, *parts = meshes_of(arrays)
    counts = {name: len(part.points) for name, part in cast.space.parts.items()}
    assert {mesh.name: len(np.unique(mesh.source)) for mesh in parts} == counts
    np.testing.assert_array_equal(np.unique(skin.source), np.arange(cast.space.vertex_count))
    np.testing.assert_array_equal(skin.source[skin.triangles], cast.space.triangles)
    for mesh in (skin, *parts):
        assert len(mesh.uv) == len(mesh.source)
        assert 0 <= mesh.uv.min() <= mesh.uv.max() <= 1
        assert len(np.unique(np.column_stack([mesh.source, mesh.uv]), axis=0)) == len(mesh.source)


def refusal(tmp_path: Path, arrays: Arrays) -> str:
    """The sentence that refuses a file of these arrays."""
    path = tmp_path / "cast.npz"
    np.savez(path, **arrays)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"delete it and run `make bake`") as refused:
        builtin.read_cast(path)
    assert str(path) in str(refused.value)
    return str(refused.value)


def test_another_format_is_refused(tmp_path: Path, arrays: Arrays) -> None:
    arrays["format"] = np.array(99)
    assert f"it has format 99, this version reads format {FORMAT}" in refusal(tmp_path, arrays)


@pytest.mark.parametrize(
    "name", ["dtheta", "face/kaori", "face/old/tongue", "jaw", "about", "format", "rest/lashes", "pupil"]
)
def test_a_missing_array_is_refused_by_its_name(tmp_path: Path, arrays: Arrays, name: str) -> None:
    del arrays[name]
    assert name in refusal(tmp_path, arrays)


def test_fields_of_another_sheet_are_refused(tmp_path: Path, arrays: Arrays) -> None:
    arrays["residual"] = arrays["residual"][:, 1:]
    inner = len(load_cast().space.inner.vertices)
    assert f"know {inner - 1} vertices of inner skin, this version finds {inner}" in refusal(tmp_path, arrays)


def test_values_that_are_not_finite_are_refused(tmp_path: Path, arrays: Arrays) -> None:
    arrays["face/old"][7, 1] = np.nan
    assert "'old'" in refusal(tmp_path, arrays)


def test_broken_text_is_refused(tmp_path: Path, arrays: Arrays) -> None:
    arrays["about"] = arrays["about"][:40]
    refusal(tmp_path, arrays)
