"""What pictures share: what cannot be drawn is refused before a browser is asked."""

from typing import Any

import pytest

from omote.stage_data.picture_setting import LARGEST, SMALLEST, Setting, read_size, refuse_count, split_list


@pytest.mark.parametrize("size", [(SMALLEST - 1, 100), (100, LARGEST + 1), (LARGEST, LARGEST), (0, 0), (-5, 100)])
def test_a_size_that_no_canvas_has_is_refused(size: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match=f"a picture of {size[0]}x{size[1]} pixels"):
        Setting(*size)


def test_a_quality_that_there_is_not_is_refused() -> None:
    with pytest.raises(ValueError, match="no quality 'best'; give one of lowest"):
        Setting(quality="best")


def test_a_transparent_background_is_refused() -> None:
    with pytest.raises(ValueError, match="'#00b140'; leave one out"):
        Setting(transparent=True, background="#00b140")


def test_a_size_is_read() -> None:
    assert read_size("640x720") == (640, 720)
    assert read_size(" 64 X 48 ") == (64, 48)


@pytest.mark.parametrize("text", ["", "640", "640x", "640x720x3", "-1x5", "1e3x5", "9999999999x5", "²x5"])
def test_what_is_no_size_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="is not understood; give width x height"):
        read_size(text)


def test_words_between_commas() -> None:
    assert split_list(" a, b ,,c") == ["a", "b", "c"]


def test_paper_is_left_out_where_a_picture_is_transparent() -> None:
    assert Setting().paper("image/jpeg") is not None
    assert Setting(transparent=True).paper("image/png") is None
    with pytest.raises(ValueError, match="a JPEG cannot be transparent"):
        Setting(transparent=True).paper("image/jpeg")


def test_a_background_is_kept_as_its_colour() -> None:
    assert Setting(background="green").background == Setting(background="#00B140").background == "#00b140"
    with pytest.raises(ValueError, match="'gren' is no colour; did you mean green"):
        Setting(background="gren")


@pytest.mark.parametrize("count", [0, 2001])
def test_an_empty_table_and_one_without_end_are_refused(count: int) -> None:
    with pytest.raises(ValueError, match=f"the table has {count} pictures"):
        refuse_count(count)


@pytest.mark.parametrize(
    ("wish", "sentence"),
    [
        ({"mask": "square"}, "no mask 'square'; give one of oval, face"),
        ({"mask": "oval"}, "needs something around it"),
        ({"luminance": 1.5}, "a luminance of 1.5 cannot be given to a picture; give 0.01 to 0.9"),
        ({"contrast": float("nan")}, "a contrast of nan cannot be given"),
    ],
)
def test_a_finish_that_cannot_be_is_refused(wish: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        Setting(**wish)
    with pytest.raises(TypeError, match="the luminance is 'x'; give a number"):
        Setting(luminance="x")  # type: ignore[arg-type]


def test_what_is_finished_is_no_jpeg() -> None:
    with pytest.raises(ValueError, match=r"a JPEG would change what is masked or matched; write a \.png"):
        Setting(contrast=0.5).paper("image/jpeg")
