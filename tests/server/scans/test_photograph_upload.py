"""Photographs and landmarks from pages are refused in sentences, at one place."""

from typing import Any

import msgspec
import pytest

from omote.model.fitting.photographs.landmark_table import LANDMARKS
from omote.server.scans.scan_upload import (
    BESIDE,
    LARGEST_PHOTOGRAPH,
    LARGEST_SIDE,
    MOST_PHOTOGRAPHS,
    SMALLEST_SIDE,
    read_photographs,
)

MIDDLE = [0.5, 0.5, 0.0]


def described(file: str = "1.jpg", **other: Any) -> dict[str, Any]:
    """What a page says of a photograph."""
    return {
        "file": file, "name": "anna.jpg", "width": 640, "height": 480, "points": [MIDDLE] * LANDMARKS, **other,
    }  # fmt: skip


def read(*photographs: dict[str, Any], size: int = 1000) -> list[Any]:
    sizes = {each["file"]: size for each in photographs if each["file"] != "away.jpg"}
    return read_photographs(msgspec.json.encode(photographs), sizes)


def test_one_to_eight_photographs_are_read_as_they_were_described() -> None:
    (one,) = read(described())
    assert (one.file, one.name, one.width, one.height) == ("1.jpg", "anna.jpg", 640, 480)
    assert one.points == [tuple(MIDDLE)] * LANDMARKS
    assert len(read(*(described(f"{number}.png") for number in range(MOST_PHOTOGRAPHS)))) == MOST_PHOTOGRAPHS
    edge = [[1.0 + BESIDE, -BESIDE, 9.0]] * LANDMARKS
    assert read(described(width=SMALLEST_SIDE, height=LARGEST_SIDE, points=edge), size=LARGEST_PHOTOGRAPH)


@pytest.mark.parametrize(
    ("photographs", "size", "why"),
    [
        ([], 1, "0 photographs with a face came; expected 1 to 8"),
        ([described(f"{number}.jpg") for number in range(MOST_PHOTOGRAPHS + 1)], 1, "9 photographs with a face came"),
        ([described(), described()], 1, "came twice"),
        ([described("away.jpg")], 1, "'anna.jpg' did not come as JPEG or PNG"),
        ([described("1.gif")], 1, "did not come as JPEG or PNG"),
        ([described()], LARGEST_PHOTOGRAPH + 1, "is too large: 16 MB"),
        ([described(width=LARGEST_SIDE + 1)], 1, "4097 x 480 pixels"),
        ([described(height=SMALLEST_SIDE - 1)], 1, "640 x 63 pixels"),
        ([described(points=[MIDDLE] * (LANDMARKS - 1))], 1, "477 landmarks; expected 478"),
        ([described(points=[[0.5, 1.6, 0.0]] * LANDMARKS)], 1, "lie outside the picture"),
        ([described(points=[[0.5, 0.5]] * LANDMARKS)], 1, "cannot be read"),
        ([described(points=[[None, 0.5, 0.0]] * LANDMARKS)], 1, "cannot be read"),
        ([{"file": "1.jpg"}], 1, "cannot be read"),
        ([described(name="bad\x00\n" + "x" * 300, width=1)], 1, f"'{'x' * 80}' has 1 x 480 pixels"),
    ],
)
def test_what_cannot_be_fitted_is_refused_in_a_sentence(photographs: Any, size: int, why: str) -> None:
    with pytest.raises(ValueError, match=r"\.$") as refused:
        read(*photographs, size=size)
    assert why in str(refused.value)


@pytest.mark.parametrize("data", [b"", b"words", b"{}", b"[1]", b"\xff" * 9])
def test_what_is_no_document_is_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="cannot be read"):
        read_photographs(data, {})


@pytest.mark.parametrize("number", ["1e999", "-1e999", "NaN", "Infinity"])
def test_numbers_that_are_not_finite_are_refused(number: str) -> None:
    data = msgspec.json.encode([described()]).replace(b"[0.5,0.5,0.0]", f"[0.5,0.5,{number}]".encode(), 1)
    with pytest.raises(ValueError, match=r"(no finite numbers|cannot be read)"):
        read_photographs(data, {"1.jpg": 1})
