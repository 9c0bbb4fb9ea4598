"""Clips of a scene: named, called as goals, paused with cues, found again after a restart and by who comes back."""

from __future__ import annotations

from typing import Any

import pytest

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.perform.scene.scene import Scene

CLIP = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {"jawOpen": 2}))])


def begun(cast: Cast) -> Scene:
    scene = Scene.begun(cast)
    scene.set_clips({"line1": CLIP})
    return scene


def test_a_clip_of_a_scene_pauses_with_the_cues_that_called_it(cast: Cast) -> None:
    scene = begun(cast)
    scene.call_goal("one/clip", {"line1": 1.0}, seconds=0.1, pace=1.0)
    scene.advance(0.5)
    scene.set_pace(0.0)
    elapsed = [scene.advance(0.5).characters["one"].frame.clips[0].elapsed for _ in range(2)]
    assert elapsed == [0.5, 0.5]
    assert scene.goal_of("one/clip") == {"line1": 1.0}
    scene.set_pace(1.0)
    scene.call_goal("one/clip", {}, seconds=0.1)
    assert scene.goal_of("one/clip") == {}
    scene.advance(0.2)
    assert scene.advance(0.0).characters["one"].frame.clips == ()


def test_who_comes_back_goes_on_with_its_clip(cast: Cast) -> None:
    scene = begun(cast)
    scene.add("two")
    scene.play_clip("two", "line1", loop=True)
    scene.remove("two", seconds=0.0)
    scene.advance(0.1)
    scene.restore("two")
    assert [clip.name for clip in scene.advance(0.1).characters["two"].frame.clips] == ["line1"]


def test_a_restored_scene_goes_on_with_its_clips(cast: Cast) -> None:
    scene = begun(cast)
    scene.play_clip("one", "line1", weights={"mouth": 0.5})
    scene.advance(0.2)
    again = Scene.restored(cast, scene.snapshot())
    again.set_clips({"line1": CLIP})
    assert again.advance(0.1) == scene.advance(0.1)


def test_what_is_not_there_is_refused(cast: Cast) -> None:
    scene = begun(cast)
    no_clip: Any = 7
    with pytest.raises(TypeError, match="the clip line1 is a int"):
        scene.set_clips({"line1": no_clip})
    with pytest.raises(ValueError, match="there is no clip 'line2' in this show"):
        scene.play_clip("one", "line2")
    with pytest.raises(ValueError, match="there is no character 'two'"):
        scene.play_clip("two", "line1")
    with pytest.raises(ValueError, match="expected one clip"):
        scene.call_goal("one/clip", {"line1": 0.5, "line2": 0.5})
    assert scene.clips == {"line1": CLIP}
