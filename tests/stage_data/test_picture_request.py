"""What is asked of pictures, as it is typed."""

import pytest

from omote.face_commands import EXPRESSIONS
from omote.model.cast import Cast
from omote.stage_data.picture_grid import lay_out
from omote.stage_data.picture_request import GridRequest, RenderRequest, file_name, morph_steps, plan_cells


def test_a_grid_of_faces_has_a_row_for_each() -> None:
    plan = plan_cells(GridRequest(faces="kaori, dog", expressions="neutral,smile", turns="0,-30"))
    assert plan.rows == ["kaori", "dog"]
    assert plan.columns == ["neutral 0°", "neutral -30°", "smile 0°", "smile -30°"]
    assert [name for name, _ in plan.cells[1]] == [
        "dog-neutral-0", "dog-neutral--30", "dog-smile-0", "dog-smile--30",
    ]  # fmt: skip
    assert plan.cells[1][3][1].turn == "-30"


def test_a_column_of_shut_eyes_is_called_so() -> None:
    plan = plan_cells(GridRequest(faces="kaori", expressions=EXPRESSIONS))
    assert plan.columns == ["neutral", "joy", "angry", "surprise", "eyes shut", "jawOpen"]
    turned = plan_cells(GridRequest(faces="kaori", expressions="eyeBlinkLeft+eyeBlinkRight", turns="0,20"))
    assert turned.columns == ["eyes shut 0°", "eyes shut 20°"]
    assert plan.cells[0][4][0] == "kaori-eyeBlinkLeft+eyeBlinkRight", "files keep the names that draw them again"


def test_a_morph_goes_from_face_to_face_in_even_steps(cast: Cast) -> None:
    one, other = list(cast.faces)[:2]
    sheet = lay_out(GridRequest(morph=f"{one}:{other}:5", expressions="neutral,smile"), cast)
    shares = [[pose["faces"].get(other, 0.0) for pose in row] for row in sheet.poses]
    assert shares == [pytest.approx([0, 0.25, 0.5, 0.75, 1.0])] * 2
    assert sheet.columns == ["0 %", "25 %", "50 %", "75 %", "100 %"]
    assert sheet.rows == ["neutral", "smile"]


@pytest.mark.parametrize("count", [2, 3, 7, 11, 33])
def test_steps_of_a_morph_weigh_one(count: int) -> None:
    steps = morph_steps(f"kaori:man:{count}")
    assert len({file for _, file, _ in steps}) == len(steps) == count
    for _, _, mix in steps[1:-1]:
        assert sum(float(part.split("=")[1]) for part in mix.split("+")) == pytest.approx(1, abs=1e-6)


def test_listed_percents_are_the_steps_of_a_morph() -> None:
    steps = morph_steps("kaori:man:0/12.5/100")
    assert [title for title, *_ in steps] == ["0 %", "12.5 %", "100 %"]
    assert [mix for *_, mix in steps] == ["kaori", "kaori=0.875000+man=0.125000", "man"]


@pytest.mark.parametrize(
    "text",
    [
        *("kaori", "kaori:man", "kaori:man:1", "kaori:man:x", ":man:3", "a:b:3:4", "a:b:99999", "a:b:0mm", "a:b:mm"),
        *("a:b:0dE", "a:b:1lab", "a:b:lab", "a:b:0/50", "a:b:10/100", "a:b:0/50/50/100", "a:b:0/-5/100", "a:b:0/x/100"),
    ],
)
def test_a_morph_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="as in kaori:man:11"):
        morph_steps(text)


def test_files_have_names_of_their_own() -> None:
    plan = plan_cells(GridRequest(faces="a/b,a b,A_B", expressions="smile"))
    names = [name for row in plan.cells for name, _ in row]
    assert len({name.casefold() for name in names}) == 3
    assert file_name("../../etc:passwd") == ".._.._etc_passwd"


def test_a_pose_is_of_a_figure_that_is_seen() -> None:
    assert RenderRequest(pose="bow", framing="full").words.poses == (("bow", 1.0),)
    with pytest.raises(ValueError, match="--framing full"):
        _ = RenderRequest(pose="bow").words
    with pytest.raises(ValueError, match="no framing 'wide'"):
        _ = RenderRequest(framing="wide").setting
