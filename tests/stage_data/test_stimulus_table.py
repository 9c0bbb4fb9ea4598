"""Stimuli from a table: rows become requests, clips their frames, and all that is wrong is said at once."""

from __future__ import annotations

import pytest

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.perform.easing import EASINGS
from omote.stage_data.clip_poses import ClipPoses
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


RAMP = Clip([Lane(make_curve([0.0, 4.0], {"jawOpen": [0.0, 1.0]}, {}))], start=1.0, speed=0.5)
"""Three seconds of motion, at half speed."""


def test_a_motion_clip_is_drawn_from_second_to_second_at_its_speed(cast: Cast) -> None:
    poses = ClipPoses(cast, {"ramp": RAMP})
    lines = ["name,clip,from,to,speed,fps,format,at", "a,ramp,,,,10,,", "b,ramp,1,1.5,2,20,mov,", "c,ramp,,,,,,2.5"]
    (a, b, c), own = read_stimuli("\n".join(lines).encode(), cast, show="my.omote", clips=poses)
    assert (len(a.frames), a.fps, a.film, a.files[-1], own) == (60, 10.0, "", "a/0060.png", [])
    assert [frame.at for frame in a.frames] == pytest.approx([0.05 * number for number in range(60)])
    assert [frame.at for frame in b.frames] == pytest.approx([1.0, 1.1, 1.2, 1.3, 1.4])
    assert (b.fps, b.film, b.row, c.row) == (20.0, "b.mov", 3, 4)
    assert b.clip is not None
    assert (b.clip.start, b.clip.end, b.clip.speed) == (2.0, 2.5, 2.0)
    assert c.frames == (RenderRequest(clip="ramp", at=2.5, show="my.omote"),)
    assert (c.files, c.fps) == (["c.png"], 0.0)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("clip\nrams", "row 2, clip: there is no clip 'rams'"),
        ("clip,seconds\nramp,1", "row 2, seconds: a motion clip has its own motion; leave it empty"),
        ("clip,turn\nramp,5", "row 2: the clip ramp has turn of its own"),
        ("clip,from,to\nramp,2,1", "row 2: the clip ramp has 3 s, and nothing from 2 s to 1 s"),
        ("clip,to\nramp,3.1", "row 2: the clip ramp has 3 s, and nothing from 0 s to 3.1 s"),
        ("clip,at\nramp,3.1", "row 2: the clip ramp has no second 3.1"),
        ("clip,format\nramp,mp4", "row 2, format: there is no format 'mp4'"),
        ("name,format\na,mov", "row 2, format: this is of a clip"),
        ("seconds,speed\n1,2", "row 2, speed: this is of a motion clip"),
        ("seconds,clip,at\n1,ramp,2", "row 2, at: this is of a motion clip"),
        ("name,at\na,1", "row 2: the second 1 is of no clip"),
    ],
)
def test_what_no_motion_clip_is_drawn_by_is_refused(text: str, sentence: str, cast: Cast) -> None:
    with pytest.raises(TableError) as raised:
        read_stimuli(text.encode(), cast, clips=ClipPoses(cast, {"ramp": RAMP}))
    assert sentence in "\n".join(raised.value.sentences)


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
