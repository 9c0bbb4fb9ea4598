"""Stimuli from a table: rows become requests, clips their frames, and all that is wrong is said at once."""

from __future__ import annotations

import pytest

from omote.model.cast import Cast
from omote.perform.easing import EASINGS
from omote.stage_data.picture_request import RenderRequest
from omote.stage_data.pose_parser import find_pose
from omote.stage_data.stimulus_table import TableError, read_stimuli


def wrong(text: str, cast: Cast) -> tuple[str, ...]:
    with pytest.raises(TableError) as raised:
        read_stimuli(text.encode(), cast)
    return raised.value.sentences


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_a_row_is_the_request_that_render_makes_of_the_same_words(cast: Cast, separator: str) -> None:
    one = list(cast.faces)[1]
    lines = ["Name,Face,expression,transparent,condition", f"a,{one},smile=0.5,yes,fast", "", ",,,,slow"]
    text = "\r\n".join(line.replace(",", separator) for line in lines)
    (first, second), own = read_stimuli(b"\xef\xbb\xbf" + text.encode(), cast, show="my.omote")
    assert first.frames == (RenderRequest(face=(one,), expression=("smile=0.5",), transparent=True, show="my.omote"),)
    assert second.frames == (RenderRequest(show="my.omote"),)
    assert (first.files, second.files, own) == (["a.png"], ["0003.png"], ["condition"])
    assert second.cells["condition"] == "slow"


def test_a_clip_goes_from_its_first_picture_to_its_last_by_its_easing(cast: Cast) -> None:
    one, other = list(cast.faces)[1:3]
    text = f"name,from_face,face,expression,seconds,fps,easing\nc,{one},{other},smile,0.4,10,early"
    [[clip], _] = read_stimuli(text.encode(), cast)
    assert clip.files == [f"c/000{number}.png" for number in range(1, 6)]
    for step, request in enumerate(clip.frames):
        share = EASINGS["early"].value(step / 4)
        frame = find_pose(cast, request.words)
        assert frame.faces == pytest.approx({n: w for n, w in ((one, 1 - share), (other, share)) if w}, abs=1e-8)
        assert frame.expressions.get("smile", 0.0) == pytest.approx(share, abs=1e-8)


def test_everything_that_is_wrong_is_said_with_its_row_and_column(cast: Cast) -> None:
    heading = "name,fase,expression,turn,size,transparent,seconds,easing"
    text = f"{heading}\na,x,smil,99,64,maybe,0,soft\nA,x,,,,,,late\nb/,,,,,,,"
    said = wrong(text, cast)
    starts = [sentence.split(":")[0] for sentence in said]
    assert sorted(starts) == sorted([
        "row 1", "row 2, expression", "row 2, turn", "row 2, size", "row 2, transparent", "row 2, seconds",
        "row 2, easing", "row 3, name", "row 3, easing", "row 4, name",
    ])  # fmt: skip
    assert "row 1: there is no column 'fase'; write face, or another heading where it is your own" in said
    assert "row 3, name: 'A' is the name of row 2 already; give it another" in said


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "row 1: none of the headings is known"),
        ("name\n", "there is no row below the headings"),
        ("name,name\na,b", "the heading 'name' comes twice"),
        ("name\na,b", "row 2: it has 2 cells, and there are 1 headings"),
        ('name\n"a', "the table is no CSV"),
        ("name\ncon", "row 2, name: 'con' is no name of a file everywhere"),
        ("name\nLPT1.a", "row 2, name: 'LPT1.a' is no name of a file everywhere"),
        ("name,luminance\na,2", "is no number from 0.01 to 0.9; write for instance 0.09"),
        ("name,seconds,fps\na,1,0", "is no number from 1 to 240; write for instance 20"),
        ("name,transparent,background\na,yes,green", "row 2: a picture is transparent or has the background"),
        ("name,seconds,fps\n" + "".join(f"a{n},60,240\n" for n in range(2)), "give 20000 at most"),
    ],
)
def test_what_is_no_table_of_stimuli_is_refused(text: str, sentence: str, cast: Cast) -> None:
    assert sentence in "\n".join(wrong(text, cast))
