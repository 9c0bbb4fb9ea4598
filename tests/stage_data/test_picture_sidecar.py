"""The document beside a picture."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import pytest

from omote.model.cast import Cast
from omote.stage_data.picture_grid import lay_out
from omote.stage_data.picture_request import RenderRequest
from omote.stage_data.picture_setting import Clipped
from omote.stage_data.picture_sidecar import (
    LARGEST_SIDECAR,
    Sidecar,
    describe,
    encode_sidecar,
    is_drawn,
    read_sidecar,
    sidecar_path,
)

REQUEST = RenderRequest(expression=("smile=0.3",), turn="10,-5", size="64x48")


@pytest.fixture
def sidecar(cast: Cast) -> Sidecar:
    return describe(REQUEST, lay_out(REQUEST, cast), REQUEST.setting, ("0.1.0", cast.digest, "pages"))


def test_it_comes_back_as_it_was_written(sidecar: Sidecar, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    sidecar_path(path).write_bytes(encode_sidecar(sidecar, b"picture"))
    found = read_sidecar(sidecar_path(path))
    assert found.clipped is None
    cut = msgspec.structs.replace(sidecar, clipped=Clipped(0.05, 0.0))
    sidecar_path(path).write_bytes(encode_sidecar(cut, b"picture"))
    assert (read_sidecar(sidecar_path(path)).clipped, cut.record) == (Clipped(0.05, 0.0), sidecar.record)
    assert found.request == REQUEST
    assert found.pictures["poses"][0][0]["expressions"] == {"smile": 0.3, "neutral": 0.7}
    drawn = {"width": 64, "height": 48, "background": None, "transparent": False, "quality": "high", "hair": True}
    assert found.setting == drawn | {"mask": "", "luminance": None, "contrast": None, "framing": ""}


def test_only_a_whole_picture_of_the_same_parameters_is_drawn(sidecar: Sidecar, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    assert not is_drawn(path, sidecar)
    path.write_bytes(b"picture")
    assert not is_drawn(path, sidecar)
    sidecar_path(path).write_bytes(encode_sidecar(sidecar, b"picture"))
    assert is_drawn(path, sidecar)
    others: list[dict[str, Any]] = [{"cast": "x"}, {"pages": "x"}, {"setting": {}}, {"pictures": {}}]
    for other in others:
        assert not is_drawn(path, msgspec.structs.replace(sidecar, **other))
    path.write_bytes(b"pict")
    assert not is_drawn(path, sidecar)


def test_another_weight_is_another_picture(cast: Cast, sidecar: Sidecar, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(b"picture")
    sidecar_path(path).write_bytes(encode_sidecar(sidecar, b"picture"))
    request = msgspec.structs.replace(REQUEST, expression=("smile=0.31",))
    made_by = ("0.1.0", cast.digest, "pages")
    assert not is_drawn(path, describe(request, lay_out(request, cast), request.setting, made_by))
    larger = replace(REQUEST.setting, width=65)
    assert not is_drawn(path, describe(REQUEST, lay_out(REQUEST, cast), larger, made_by))


@pytest.mark.parametrize("text", [b"", b"{}", b'{"format":"omote-picture","version":9}', b"\xff"])
def test_what_is_none_of_ours_is_refused(tmp_path: Path, text: bytes) -> None:
    (tmp_path / "a.json").write_bytes(text)
    with pytest.raises(ValueError, match="no sidecar of a picture"):
        read_sidecar(tmp_path / "a.json")


def test_what_is_far_too_large_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "a.json").open("wb") as file:
        file.truncate(LARGEST_SIDECAR + 1)
    with pytest.raises(ValueError, match="larger than 16 MB"):
        read_sidecar(tmp_path / "a.json")
