"""How a clip plays as a goal."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.clips.clip import FASTEST, LONGEST_SHIFT, SLOWEST, Clip, Lane
from omote.perform.clips.clip_runs import run_of
from omote.perform.clips.motion_curve import make_curve
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.perform.scene.clip_goals import SETTING, ClipCall, call_of_run, clip_of_goal, goal_of_clip

calls = st.builds(
    ClipCall,
    st.text(max_size=20).filter(lambda name: not name.startswith(SETTING)),
    st.none() | st.floats(0.0, LONGEST_SHIFT),
    st.none() | st.floats(SLOWEST, FASTEST),
    st.none() | st.booleans(),
    st.none() | st.dictionaries(st.sampled_from(LAYER_PARTS), st.floats(0.0, 1.0), min_size=1),
)


@given(calls)
def test_a_call_comes_back_from_its_goal(call: ClipCall) -> None:
    assert clip_of_goal(goal_of_clip(call)) == call


def test_one_name_alone_is_a_clip() -> None:
    assert clip_of_goal({":start": 1.0}) == ClipCall(":start")


@pytest.mark.parametrize(
    ("goal", "reason"),
    [
        ({"a": 0.5, "b": 0.5}, "a = 0.5, b = 0.5; expected one clip"),
        ({"a": 0.5}, "expected one clip, with the weight 1"),
        ({":start": 1.0, ":loop": 1.0}, "expected one clip"),
        ({"a": 1.0, ":begin": 1.0}, "a clip is not called with ':begin'; expected :start"),
        ({"a": 1.0, ":speed": 0.0}, "the speed of a clip is 0.0; give a number from 0.05 to 20"),
        ({"a": 1.0, ":loop": 0.5}, "the loop of a clip is 0.5; expected 1"),
        ({"a": 1.0, ":mouth": 2.0}, "the mouth of a clip is 2.0; give a number from 0 to 1"),
    ],
)
def test_what_no_clip_plays_is_refused(goal: dict[str, float], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        clip_of_goal(goal)


@given(calls.filter(lambda call: (call.start or 0.0) < 9.0))
def test_what_plays_says_how_it_was_called(call: ClipCall) -> None:
    clip = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {}))], speed=2.0)
    run = run_of(
        clip,
        call.name,
        seconds=None,
        start=call.start or 0.0,
        speed=call.speed,
        loop=call.loop,
        weights=call.weights,
        number=1,
    )
    said = call_of_run(run, clip)
    called = {"start": said.start or 0.0, "speed": said.speed, "loop": said.loop, "weights": said.weights}
    assert run_of(clip, said.name, seconds=None, number=1, **called) == run  # type: ignore[arg-type]
    assert call_of_run(replace(run, speed=2.0, loop=False, start=0.0), clip).speed is None
    assert call_of_run(run, None).speed == run.speed
