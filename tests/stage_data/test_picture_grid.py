"""Sheets and settings: what cannot be drawn is refused before a browser is asked."""

import pytest

from omote.model.cast import Cast
from omote.stage_data.picture_grid import LARGEST, SMALLEST, PictureGrid, Setting, build_grid, read_size, split_list

ONE = [[{"faces": {"generic": 1.0}}]]


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


def test_a_grid_has_a_row_for_each_face_and_a_column_for_each_expression_and_turn(cast: Cast) -> None:
    faces = list(cast.faces)[:2]
    sheet = build_grid(
        cast, faces=",".join(faces), expressions="neutral, smile=0.5", turns="-30,0", light="flat", labels=True
    )
    assert sheet.rows == faces
    assert sheet.columns == ["neutral -30°", "neutral 0°", "smile=0.5 -30°", "smile=0.5 0°"]
    assert [[next(iter(pose["faces"])) for pose in row] for row in sheet.poses] == [[face] * 4 for face in faces]
    assert [pose["head"][0] < 0 for pose in sheet.poses[0]] == [True, False, True, False]
    assert build_grid(cast, faces="generic", expressions="smile", turns="0", light="flat", labels=False).columns == ()


def test_words_between_commas() -> None:
    assert split_list(" a, b ,,c") == ["a", "b", "c"]


def test_an_empty_grid_and_one_without_end_are_rejected(cast: Cast) -> None:
    with pytest.raises(ValueError, match="the sheet has 0 pictures"):
        build_grid(cast, faces="", expressions="smile", turns="0", light="flat", labels=True)
    with pytest.raises(ValueError, match="the sheet has 2001 pictures"):
        PictureGrid([ONE[0] * 2001])


def test_names_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="every row and every column has a name"):
        PictureGrid(ONE, rows=("a", "b"))
    with pytest.raises(ValueError, match="every picture has a caption"):
        PictureGrid(ONE, captions=[["a", "b"]])


def test_paper_is_left_out_where_a_picture_is_transparent() -> None:
    assert PictureGrid(ONE).on_paper(Setting(), "image/jpeg").kind == "image/jpeg"
    assert PictureGrid(ONE).on_paper(Setting(), "image/png").paper is not None
    assert PictureGrid(ONE).on_paper(Setting(transparent=True), "image/png").paper is None
    with pytest.raises(ValueError, match="a JPEG cannot be transparent"):
        PictureGrid(ONE).on_paper(Setting(transparent=True), "image/jpeg")
