"""Grids of pictures: what is asked for stands in its row and column."""

import pytest

from omote.model.cast import Cast
from omote.stage_data.picture_grid import PictureGrid, lay_out, spell_out
from omote.stage_data.picture_request import GridRequest, RenderRequest
from omote.stage_data.picture_setting import Setting
from omote.stage_data.playing_cast import build_playing_cast
from tests.stage_data.heads import synthetic_cast

ONE = [[{"faces": {"generic": 1.0}}]]


def test_names_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="every row and every column has a name"):
        PictureGrid(ONE, rows=("a", "b"))
    with pytest.raises(ValueError, match="every picture has a caption"):
        PictureGrid(ONE, captions=[["a", "b"]])


def test_a_grid_has_a_row_for_each_face_and_a_column_for_each_expression_and_turn(cast: Cast) -> None:
    faces = list(cast.faces)[:2]
    request = GridRequest(faces=",".join(faces), expressions="neutral, smile=0.5", turns="-30,0", light="flat")
    sheet = lay_out(request, cast)
    assert sheet.rows == faces
    assert sheet.columns == ["neutral -30°", "neutral 0°", "smile=0.5 -30°", "smile=0.5 0°"]
    assert [[next(iter(pose["faces"])) for pose in row] for row in sheet.poses] == [[face] * 4 for face in faces]
    assert [pose["head"][0] < 0 for pose in sheet.poses[0]] == [True, False, True, False]
    assert lay_out(GridRequest(faces="generic", expressions="smile", labels=False), cast).columns == ()


def test_kinds_in_a_table_are_their_expressions() -> None:
    cast = synthetic_cast()
    playing = build_playing_cast(cast, (), {})
    spelled = spell_out(GridRequest(faces="generic", expressions="smile=0.5, PERFORMED,jaw open"), playing)
    assert isinstance(spelled, GridRequest)
    performed = [name for name, title in cast.titles.items() if title.kind == "performed"]
    assert spelled.expressions.split(",") == ["smile=0.5", *performed, "jaw open"]
    assert spell_out(spelled, playing) == spelled
    with pytest.raises(ValueError, match=r"there are no own expressions here; name a show file .*: --show my\.omote"):
        spell_out(GridRequest(faces="generic", expressions="own"), playing)
    one = RenderRequest(expression=("own",))
    assert spell_out(one, playing) is one


def test_one_picture_is_a_table_of_one(cast: Cast) -> None:
    ((pose,),) = lay_out(RenderRequest(face=("generic",), expression=("smile=0.5",), channel=("jawOpen",)), cast).poses
    assert pose["expressions"] == {"smile": 0.5, "neutral": 0.5}
    assert pose["channels"] == {"jawOpen": 1.0}


def test_a_grid_of_no_pictures_is_refused() -> None:
    with pytest.raises(ValueError, match="the table has 0 pictures"):
        PictureGrid([])


def test_a_grid_lies_on_the_paper_of_its_setting() -> None:
    assert PictureGrid(ONE).on_paper(Setting(), "image/jpeg").kind == "image/jpeg"
    assert PictureGrid(ONE).on_paper(Setting(transparent=True), "image/png").paper is None
