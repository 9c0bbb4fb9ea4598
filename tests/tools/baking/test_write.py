"""Files with the same bytes for the same content."""

import io
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from tests.pictures import read_png
from tools.baking.write import npz_bytes, png_bytes, write_file

ARRAYS = {"b": np.arange(6, dtype=np.float32).reshape(2, 3), "a/c": np.array(1), "d": np.zeros((0, 3), np.int32)}


def test_the_order_of_arrays_does_not_show() -> None:
    assert npz_bytes(ARRAYS) == npz_bytes(dict(reversed(ARRAYS.items())))


def test_no_member_tells_when_it_was_made() -> None:
    with zipfile.ZipFile(io.BytesIO(npz_bytes(ARRAYS))) as archive:
        assert {member.date_time for member in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_arrays_come_back_with_shape_and_type() -> None:
    with np.load(io.BytesIO(npz_bytes(ARRAYS)), allow_pickle=False) as file:
        assert set(file) == set(ARRAYS)
        for name, array in ARRAYS.items():
            assert (file[name].shape, file[name].dtype) == (array.shape, array.dtype)
            np.testing.assert_array_equal(file[name], array)


@given(
    arrays(
        np.uint8,
        array_shapes(min_dims=2, max_dims=2, max_side=9).map(lambda shape: (*shape, 4)),
        elements=st.integers(0, 255),
    )
)
def test_pictures_come_back(picture: np.ndarray) -> None:
    np.testing.assert_array_equal(read_png(png_bytes(picture)), picture)


def test_a_file_is_replaced_whole(tmp_path: Path) -> None:
    path = tmp_path / "new" / "cast.npz"
    write_file(path, b"old")
    write_file(path, b"new")
    assert [(found.name, found.read_bytes()) for found in path.parent.iterdir()] == [("cast.npz", b"new")]


def test_a_write_that_fails_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "cast.npz"
    write_file(path, b"old")

    def fails(*_: object) -> None:
        raise OSError("disk full")

    monkeypatch.setattr(Path, "replace", fails)
    with pytest.raises(OSError, match="disk full"):
        write_file(path, b"new")
    assert [(found.name, found.read_bytes()) for found in tmp_path.iterdir()] == [("cast.npz", b"old")]
