"""Goals of a scene are read, and called from whatever shows."""

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.layers.layer_names import LAYER_PARTS, LAYERS
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    PASSING,
    POSE_PARTS,
    SCENE_PARTS,
    Goal,
    Part,
    check_goal,
    is_setting,
    split_part,
)
from omote.perform.scene.scene import Scene
from tests import synthetic

PARTS = (*(f"one/{part}" for part in CHARACTER_PARTS if part not in PASSING), *(f"*/{part}" for part in SCENE_PARTS))
"""All that come to a stand; of clips: `perform/clips/test_clip_playing.py`."""
GOALS: dict[Part, Goal] = {
    "one/face": {synthetic.FACES[1]: 0.75, synthetic.FACES[0]: 0.25},
    "one/expression": {"jawOpen": 1.0},
    **{f"one/{region}": {"jawOpen": 0.5, "neutral": 0.5} for region in ("brows", "eyes", "mouth", "rest")},
    "one/pose": {"bow": 1.0},
    **{f"one/{part}": {"wave": 0.5, "stand": 0.5} for part in POSE_PARTS},
    "one/body": {"broad": 0.75, "own": 0.25},
    "one/head": {"yaw": 0.3, "pitch": -0.1, "roll": 0.2},
    "one/gaze": {"yaw": 0.3, "pitch": -0.1},
    "one/place": {"x": 0.5, "depth": 1.0, "size": 2.0, "turn": -1.0},
    "one/presence": {"presence": 0.25},
    "one/motion": {"liveliness": 0.0, "blinks": 0.5, "gaze": 2.0, "breath": 0.0},
    "one/skin": {"folds": 0.5, "blood": 1.5},
    "one/springs": {"ears-sway": 0.5, "ears-flap": 0.0, "jowls-sway": 2.0, "cheeks-bounce": 1.25},
    "one/look": {"yaw": 0.25, "pitch": -0.125},
    "one/macros": {"mouth": -0.5},
    **{f"one/layer:{layer}": {part: 0.5 + 0.05 * place for place, part in enumerate(LAYER_PARTS)} for layer in LAYERS},
    "*/light": {"flat": 0.75, "theatre": 0.25},
    "*/framing": {"one": 1.0},
    "*/black": {"black": 0.75},
}


def begun(cast: Cast) -> Scene:
    """A scene with a macro."""
    scene = Scene.begun(cast)
    scene["one"].set_mapping(MacroMapping("mouth", (MacroTarget("channel/jawOpen"),)))
    return scene


def test_every_part_is_tried() -> None:
    assert GOALS.keys() == {*PARTS}


@pytest.mark.parametrize("part", PARTS)
def test_a_part_goes_where_it_is_called_from_where_it_was_and_nothing_else_moves(cast: Cast, part: str) -> None:
    scene = begun(cast)
    before = {each: scene.shown_goal(each) for each in PARTS}
    for each in PARTS:
        assert check_goal(each, scene.goal_of(each)) == scene.goal_of(each) == before[each]
    scene.call_goal(part, GOALS[part], seconds=2.0)
    assert scene.goal_of(part) == GOALS[part]
    assert is_setting(split_part(part)[1]) or scene.shown_goal(part).keys() >= before[part].keys()
    scene.advance(1.0)
    scene.advance(1.0)
    assert scene.shown_goal(part) == pytest.approx(GOALS[part])
    with_it = {part} | ({"one/expression"} if part == "one/rest" else set())
    others = [each for each in PARTS if each not in with_it]
    assert {each: scene.shown_goal(each) for each in others} == {each: before[each] for each in others}
    assert "/".join(split_part(part)) == part


def test_what_cannot_be_called_changes_nothing(cast: Cast) -> None:
    scene = Scene.begun(cast)
    snapshot = scene.snapshot()
    for part, goal, reason in (
        ("two/face", {synthetic.FACES[0]: 1.0}, "there is no character 'two'"),
        ("one/face", {"nobody": 1.0}, "there is no face 'nobody'"),
        ("one/eyes", {"nothing": 1.0}, "there is no expression 'nothing'"),
        ("*/light", {"dusk": 1.0}, "there is no light 'dusk'"),
        ("*/framing", {"two": 1.0}, "there is no character 'two'"),
        ("one/look", {"character two": 1.0}, "there is no character 'two'"),
        ("one/look", {"character one": 1.0}, "one cannot look at itself"),
        ("one/look", {"gaze_point seat": 1.0}, "there is no gaze point 'seat'"),
    ):
        with pytest.raises(ValueError, match=reason):
            scene.call_goal(part, goal)
    assert scene.snapshot() == snapshot


def test_a_region_that_is_called_to_its_face_goes_with_it_again(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.call_goal("one/brows", {"jawOpen": 1.0}, seconds=0.0)
    scene.call_goal("one/brows", {}, seconds=1.0)
    scene.advance(0.5)
    assert 0.0 < scene.shown_goal("one/brows")["jawOpen"] < 1.0
    scene.advance(0.5)
    scene.advance(0.0)
    assert scene.goal_of("one/brows") == {}


def test_a_part_that_is_called_on_its_way_goes_on_at_its_speed(cast: Cast) -> None:
    """Numbers and turns as mixes do: no part jumps, and none stops for an instant."""
    scene = Scene.begun(cast)
    for part, name in (("one/place", "x"), ("one/head", "yaw"), ("*/black", "black")):
        scene.call_goal(part, GOALS[part], seconds=1.0)
        places = []
        for step in range(40):
            if step == 20:
                scene.call_goal(part, {key: 0.5 * value for key, value in GOALS[part].items()}, seconds=1.0)
            scene.advance(1.0 / 60.0)
            places.append(scene.shown_goal(part)[name])
        speeds = np.diff(places)
        assert np.abs(np.diff(speeds)).max() < 0.25 * np.abs(speeds).max(), part


PACED = [part for part in PARTS if not is_setting(split_part(part)[1])]  # which is followed by its own filters


@pytest.mark.parametrize("part", PACED)
def test_what_was_called_with_a_pace_is_held_and_goes_on_as_if_nothing_had_been(cast: Cast, part: str) -> None:
    scene, other = begun(cast), begun(cast)
    for each in (scene, other):
        each.call_goal(part, GOALS[part], seconds=2.0, pace=1.0)
        each.advance(0.75)
    stands = scene.shown_goal(part)
    scene.set_pace(0.0)
    scene.advance(3.0)
    assert scene.shown_goal(part) == stands
    held = Scene.restored(cast, scene.snapshot())
    for each in (scene, held):
        each.set_pace(1.0)
        each.advance(0.5)
    other.advance(0.5)
    assert scene.shown_goal(part) == held.shown_goal(part) == other.shown_goal(part)


@pytest.mark.parametrize("part", PACED)
def test_no_pace_holds_what_hands_call(cast: Cast, part: str) -> None:
    scene, other = begun(cast), begun(cast)
    scene.call_goal(part, GOALS[part], seconds=2.0, pace=1.0)
    scene.set_pace(0.0)
    for each in (scene, other):
        each.call_goal(part, GOALS[part], seconds=2.0)
        each.set_pace(0.0)
        each.advance(1.0)
    assert scene.shown_goal(part) == other.shown_goal(part) != begun(cast).shown_goal(part)


@pytest.mark.parametrize("part", ["one/expression", "one/head", "one/place", "*/light", "*/black"])
def test_a_call_of_what_goes_slowly_takes_over_the_speed_that_shows(cast: Cast, part: str) -> None:
    """Whatever its pace, half a millisecond before a call and after it a part moves as fast."""
    scene = Scene.begun(cast)
    scene.call_goal(part, GOALS[part], seconds=2.0, pace=0.25)
    scene.advance(3.0)
    name = max(GOALS[part], key=lambda each: abs(GOALS[part][each]))
    step, shown = 0.0005, []
    for _ in range(2):
        shown.append(scene.shown_goal(part)[name])
        scene.advance(step)
    shown.append(scene.shown_goal(part)[name])
    scene.call_goal(part, Scene.begun(cast).shown_goal(part), seconds=4.0)
    for _ in range(2):
        scene.advance(step)
        shown.append(scene.shown_goal(part)[name])
    speeds = np.diff(shown) / step
    assert abs(speeds[1]) > 0.01
    assert speeds[2] == pytest.approx(speeds[1], rel=0.02)
