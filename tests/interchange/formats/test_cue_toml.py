"""Cue lists as text."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.formats.cue_toml import (
    HEADING,
    CueFileError,
    format_cues,
    format_running_order,
    parse_cues,
    read_cues,
    write_cues,
)
from omote.perform.clips.clip import FASTEST, LONGEST_SHIFT, SLOWEST
from omote.perform.cues.cue import Cue, CueList, Move
from omote.perform.cues.cue_action import CueAction
from omote.perform.easing import EASINGS
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.perform.mappings.mapping import MACRO_LIMITS
from omote.perform.scene.clip_goals import SETTING, ClipCall, clip_of_goal, goal_of_clip
from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    SCENE_PARTS,
    WITH_FACE,
    Goal,
    Part,
    is_of_macros,
    passes,
    ranges_of,
    takes_one_number,
    whole_of,
)

times = st.floats(0.0, 3600.0)
words = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
parts = st.one_of(
    st.builds("{}/{}".format, st.sampled_from(["one", "kaori"]), st.sampled_from(CHARACTER_PARTS)),
    st.sampled_from([f"*/{part}" for part in SCENE_PARTS]),
)


LOOKS: tuple[Goal, ...] = ({"character two": 1.0}, {"stage": 1.0}, {"x": 1.0, "y": 0.0, "z": 2.0})


clip_calls = st.builds(
    ClipCall,
    words.filter(lambda name: not name.startswith(SETTING)),
    st.none() | st.floats(0.0, LONGEST_SHIFT),
    st.none() | st.floats(SLOWEST, FASTEST),
    st.none() | st.booleans(),
    st.none() | st.dictionaries(st.sampled_from(LAYER_PARTS), st.sampled_from([0.0, 0.5, 1.0]), min_size=1),
)


@st.composite
def goals(draw: st.DrawFn, part: Part) -> Goal:
    ranges = ranges_of(part)
    if part.endswith("/look"):
        return draw(st.sampled_from(LOOKS))
    if is_of_macros(part):
        return draw(st.dictionaries(st.sampled_from(["smile", "jaw 2"]), st.floats(*MACRO_LIMITS), min_size=1))
    if ranges is not None and takes_one_number(part) and draw(st.booleans()):
        return dict.fromkeys(ranges, draw(st.floats(0.0, 1.0)))
    if ranges is not None:
        return {name: draw(st.floats(low, high)) for name, (low, high) in ranges.items()}
    if (whole_of(part) or passes(part)) and draw(st.booleans()):
        return WITH_FACE
    if passes(part):
        return goal_of_clip(draw(clip_calls))
    share = draw(st.sampled_from([1.0, 0.75, 1.05]))
    first, second = draw(st.lists(words, min_size=2, max_size=2, unique=True))
    return {first: 1.0} if share == 1.0 else {first: share, second: 1.0 - share}


actions = st.one_of(
    st.builds(
        CueAction,
        st.just("osc"),
        st.sampled_from(["10.0.0.2:53000", "desk.local:1", "[::1]:65535"]),
        st.sampled_from(["/go", '/cue/12 1 1.0 "a \\"b\\" c" true word']),
        times,
    ),
    st.builds(CueAction, st.just("midi"), st.just("Pad"), st.sampled_from(["90 3C 7F", "msc 3 go 12.5"]), times),
    st.builds(CueAction, st.just("say"), words.filter(str.strip), words.filter(str.strip), times, words),
    st.builds(
        CueAction, st.just("say"), words.filter(str.strip), words, times, sound=words.filter(lambda key: key != "")
    ),
)


@st.composite
def cue_lists(draw: st.DrawFn) -> CueList:
    numbers = draw(
        st.lists(st.from_regex(r"(0|[1-9]\d{0,4})(\.\d{0,2}[1-9])?", fullmatch=True), max_size=4, unique=True)
    )
    return tuple(
        Cue(
            number,
            number,
            {
                part: Move(draw(goals(part)), draw(times), draw(st.sampled_from([*EASINGS])), draw(times))
                for part in draw(st.lists(parts, max_size=3, unique=True))
            },
            draw(words),
            draw(words),
            draw(words),
            draw(times),
            draw(times),
            draw(st.sampled_from(["", "continue", "follow"])),
            draw(st.booleans()),
            tuple(draw(st.lists(actions, max_size=3))),
        )
        for number in numbers
    )


@given(cue_lists())
def test_what_is_written_is_read_back_as_it_was(cues: CueList) -> None:
    assert parse_cues(format_cues(cues)) == cues


def test_what_all_cues_have_is_left_out() -> None:
    cue = Cue("1", "1", {"one/face": Move({"dog": 1.0}), "*/black": Move({"black": 1.0}, 0.0)})
    assert format_cues([cue]) == HEADING + (
        '\n[[cue]]\nnumber = "1"\n[cue.moves]\n"one/face" = { to = "dog" }\n"*/black" = { to = 1.0, seconds = 0.0 }\n'
    )


def test_a_change_of_one_thing_changes_one_line() -> None:
    cues = [Cue(str(number), str(number), {"one/face": Move({"dog": 1.0})}, "A label") for number in range(5)]
    before = format_cues(cues).splitlines()
    cues[3] = Cue("3", "3", {"one/face": Move({"old": 1.0})}, "A label")
    after = format_cues(cues).splitlines()
    assert len([line for line, other in zip(before, after, strict=True) if line != other]) == 1


WRONG = """# Tuesday
[[cue]]
number = "1"
goes_on = "later"
[cue.moves]
"one/face" = { to = "dog", secs = 2 }
"one/tail" = { to = "wag" }
"*/black" = { to = 2 }
"one/place" = { to = { x = 1 } }

[[cue]]
label = "no number"
pre_wait = -1
colour = 3
[cue.moves]
'one/expression' = "smile"
"""


def test_every_error_is_said_with_its_line() -> None:
    with pytest.raises(CueFileError) as error:
        parse_cues(WRONG)
    said = str(error.value).splitlines()
    assert [line.split(":")[0] for line in said] == [
        "line 4", "line 6", "line 7", "line 8", "line 9", "line 11", "line 13", "line 14", "line 16",
    ]  # fmt: skip
    assert "a move has no 'secs'" in said[1]
    assert "black of */black is 2.0; give a number from 0 to 1" in said[3]


WRONG_ACTIONS = """[[cue]]
number = "1"
actions = [
  { does = "osc", to = "10.0.0.2", what = "/go" },
  { does = "osc", to = "10.0.0.2:53000", what = "/go" },
  { does = "midi", to = "Pad", what = "90 3C" , loud = 1 },
  { does = "shout", to = "one", what = "Ho" },
  { does = "say", to = "one", what = 3 },
  3,
]

[[cue]]
number = "2"
actions = "none"
"""


def test_an_action_is_a_line_and_what_is_wrong_with_it_is_said_there() -> None:
    with pytest.raises(CueFileError) as error:
        parse_cues(WRONG_ACTIONS)
    said = str(error.value).splitlines()
    assert [line.split(":")[0] for line in said] == ["line 3", "line 4", "line 6", "line 7", "line 8", "line 14"]
    assert "give a host and a port, such as 10.0.0.2:53000" in said[1]
    assert "an action has no 'loud'" in said[2]


def test_a_clip_is_written_with_how_it_plays() -> None:
    calls = {
        "line1": ClipCall("line1"),
        '{ clip = "line1", start = 12.4, loop = false }': ClipCall("line1", 12.4, loop=False),
        '{ clip = "line1", speed = 0.5, parts = ["mouth", "head"] }': ClipCall(
            "line1", speed=0.5, weights={"mouth": 1.0, "head": 1.0}
        ),
        '{ clip = "stop", parts = { brows = 0.5, head = 1.0 } }': ClipCall("stop", weights={"brows": 0.5, "head": 1.0}),
    }
    for text, call in calls.items():
        cue = Cue("1", "1", {"one/clip": Move(goal_of_clip(call))})
        assert clip_of_goal(cue.moves["one/clip"].goal) == call
        written = format_cues([cue])
        assert (f'"one/clip" = {{ to = {text} }}' in written) == (text != "line1")
        assert parse_cues(written) == (cue,)


WRONG_CLIPS = """[[cue]]
number = "1"
[cue.moves]
"a/clip" = { to = { clip = "line1", begin = 3 } }
"b/clip" = { to = { clip = "line1", speed = 99 } }
"c/clip" = { to = { clip = "line1", loop = 1 } }
"d/clip" = { to = { clip = "line1", parts = ["jaw"] } }
"e/clip" = { to = { clip = "line1", parts = [] } }
"f/clip" = { to = { clip = "line1", start = "12" } }
"g/clip" = { to = { line1 = 0.5, line2 = 0.5 } }
"h/face" = { to = { clip = "line1" } }
"i/clip" = { to = { clip = "line1", parts = "mouth" } }
"""


def test_what_is_wrong_with_a_clip_is_said_at_its_line() -> None:
    with pytest.raises(CueFileError) as error:
        parse_cues(WRONG_CLIPS)
    said = str(error.value).splitlines()
    assert [line.split(":")[0] for line in said] == [f"line {line}" for line in range(4, 13)]
    reasons = [
        "a clip has no 'begin'; expected clip, start, speed, loop, parts",
        "the speed of a clip is 99.0; give a number from 0.05 to 20",
        "the loop of a clip is 1; expected true or false",
        "jaw",
        "the parts of a clip are {}",
        "the start of a clip must be a number, not '12'",
        "expected one clip, with the weight 1",
        "h/face",
        "the parts of a clip are 'mouth'",
    ]
    assert [reason for reason, line in zip(reasons, said, strict=True) if reason not in line] == []


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("cue = 3", "two brackets"),
        ("[[cue]\n", "no TOML"),
        ('[[cue]]\nnumber = "1"\n[[cue]]\nnumber = "1"\n', "two cues have the number 1"),
        ("[[scene]]\n", "line 1: 'scene' is no cue"),
        ('[[cue]]\nnumber = "1"\nmoves = 3\n', "line 3: the moves are 3"),
        ('[[cue]]\nnumber = "01"\n', "line 2: a cue cannot be numbered '01'"),
        ("[[cue]]\nnumber = 1\n", "line 2: a cue cannot be numbered 1;"),
    ],
)
def test_what_is_no_list_is_refused_in_words(text: str, reason: str) -> None:
    with pytest.raises(CueFileError, match=reason):
        parse_cues(text)


def test_a_file_is_written_and_read_and_named_where_it_is_wrong(tmp_path: Path) -> None:
    path = tmp_path / "evening.toml"
    cues = (Cue("1", "1", label="Öffnen"),)
    write_cues(cues[:0], path)
    write_cues(cues, path)
    assert read_cues(path) == cues
    path.write_text("[[cue]]\n", encoding="utf-8")
    with pytest.raises(CueFileError, match=r"evening\.toml: line 1: a cue has no number"):
        read_cues(path)
    with pytest.raises(CueFileError, match="cannot be read"):
        read_cues(tmp_path / "none.toml")


def test_a_running_order_has_a_line_for_each_cue_with_what_it_moves() -> None:
    done = (CueAction("midi", "Pad", "90 3C 7F"), CueAction("say", "one", "Ho"))
    cues = [
        Cue("1", "1", {"one/face": Move({"dog": 1.0}, 2.0, delay=0.5)}, "Dog, then cat", goes_on="follow"),
        Cue("2", "2", {"one/expression": Move({"joy": 0.5, "neutral": 0.5})}, skip=True, colour="red"),
        Cue("3.5", "3.5", actions=done),
    ]
    assert format_running_order(cues).splitlines() == [
        "number,label,pre_wait,goes_on,post_wait,note,skip,colour,moves,actions",
        '1,"Dog, then cat",0.0,follow,0.0,,,,one/face dog 2 s after 0.5 s,',
        '2,,0.0,,0.0,,yes,red,"one/expression { joy = 0.5, neutral = 0.5 } 1 s",',
        "3.5,,0.0,,0.0,,,,,midi Pad 90 3C 7F; say one Ho",
    ]
