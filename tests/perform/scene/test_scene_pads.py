"""The pads of a scene: kept, changed while they play, moved by goals, and restored."""

from __future__ import annotations

from dataclasses import replace

import msgspec
import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_player import CuePlayer
from omote.perform.mix import Weights
from omote.perform.pads.blend_space import Pad, PadLook
from omote.perform.pads.kept_pads import NO_PADS
from omote.perform.scene.cast_pads import cast_pads
from omote.perform.scene.goals import POSE_PARTS
from omote.perform.scene.pad_goals import goal_of_point
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_snapshot import SceneSnapshot

STEP = 1.0 / 60.0
LOOKS = (
    PadLook("Smile", {"smile": 1.0}, (-1.0,)),
    PadLook("Neutral", {"neutral": 1.0}, (0.0,)),
    PadLook("Jaw", {"jawOpen": 1.0}, (1.0,)),
)
MOOD = Pad("mood", "expression", 1, LOOKS)
MOUTH = Pad("lips", "mouth", 1, LOOKS)


@pytest.fixture
def scene(cast: Cast) -> Scene:
    scene = Scene.begun(cast)
    scene.set_pad(MOOD)
    scene.set_pad(MOUTH)
    return scene


def mix(scene: Scene, seconds: float = 1.0) -> Weights:
    """What shows of expressions some time later."""
    return scene.advance(seconds).characters["one"].frame.expressions


def mouth(scene: Scene, seconds: float = 1.0) -> Weights:
    frame = scene.advance(seconds).characters["one"].frame
    return frame.regions.get("mouth", frame.expressions)


def test_a_new_show_has_the_pads_of_the_cast_and_an_old_one_takes_them(cast: Cast) -> None:
    begun = Scene.begun(cast)
    assert dict(begun.pads) == cast_pads(cast)
    old = Scene.restored(cast, replace(begun.snapshot(), pads=NO_PADS))
    assert old.pads == {}
    old.add_cast_pads()
    assert dict(old.pads) == cast_pads(cast)
    old.restore_pad("cast pads")
    assert old.pads == {}


def test_a_pad_is_found_as_people_write_it(scene: Scene) -> None:
    scene.move_pad("one", "MOOD", 1.0)
    assert mix(scene) == {"jawOpen": 1.0}
    with pytest.raises(ValueError, match="there is no pad 'mod'; near are mood"):
        scene.move_pad("one", "mod", 1.0)
    with pytest.raises(ValueError, match="there is no character 'two'"):
        scene.move_pad("two", "mood", 1.0)


def test_a_pad_that_changes_while_it_plays_is_followed(scene: Scene) -> None:
    scene.move_pad("one", "mood", 1.0)
    assert mix(scene) == {"jawOpen": 1.0}
    scene.set_pad(replace(MOOD, looks=(*LOOKS[:2], replace(LOOKS[2], mix={"smile": 1.0}))))
    assert mix(scene, 0.0) == {"jawOpen": 1.0}
    assert mix(scene) == {"smile": 1.0}


def test_one_with_more_dimensions_goes_on_where_its_point_was(scene: Scene) -> None:
    scene.move_pad("one", "mood", 1.0)
    mix(scene)
    square = tuple(replace(look, place=(*look.place, 0.0)) for look in LOOKS)
    scene.set_pad(replace(MOOD, dimensions=2, looks=square))
    status = scene.advance(1.0).characters["one"].frame.pads["mood"]
    assert (status.place, status.plays) == ((1.0, 0.0), True)
    scene.set_pad(MOOD)
    assert scene.advance(1.0).characters["one"].frame.pads["mood"].place == (1.0,)


def test_one_that_is_renamed_plays_on_and_one_that_is_gone_leaves_what_it_shows(scene: Scene) -> None:
    scene.move_pad("one", "mood", 0.5)
    before = mix(scene)
    scene.rename_pad("mood", "temper", key="k")
    frame = scene.advance(0.1).characters["one"].frame
    assert (frame.expressions, frame.pads["temper"].plays) == (before, True)
    scene.restore_pad("k")
    assert scene.advance(0.1).characters["one"].frame.pads["mood"].plays
    scene.drop_pad("mood")
    frame = scene.advance(1.0).characters["one"].frame
    assert frame.expressions == pytest.approx(before, abs=1e-12)
    assert (frame.pads, scene.advance(1.0).characters["one"].frame.expression_call) == ({}, None)


def test_one_that_plays_another_part_from_now_on_leaves_what_it_shows(scene: Scene) -> None:
    scene.move_pad("one", "mood", 1.0)
    mix(scene)
    scene.set_pad(replace(MOOD, part="mouth"))
    frame = scene.advance(1.0).characters["one"].frame
    assert (frame.expressions, frame.pads["mood"].plays) == ({"jawOpen": 1.0}, False)


def test_a_goal_moves_the_point_in_seconds_and_is_told_as_it_goes(scene: Scene) -> None:
    scene.move_pad("one", "mood", -1.0)
    mix(scene)
    goal = goal_of_point("mood", (1.0,))
    scene.call_goal("one/expression", goal, seconds=2.0)
    assert scene.goal_of("one/expression") == goal
    scene.advance(1.0)
    assert scene.shown_goal("one/expression") == goal_of_point("mood", (0.0,))
    assert mix(scene, 0.1)["neutral"] > 0.5  # it goes along the pad, past neutral
    assert mix(scene, 2.0) == {"jawOpen": 1.0}
    assert scene.goal_of("one/expression") == goal


def test_a_hand_ends_the_way_of_a_point(scene: Scene) -> None:
    scene.move_pad("one", "mood", -1.0)
    scene.call_goal("one/expression", goal_of_point("mood", (1.0,)), seconds=2.0)
    scene.advance(1.0)
    scene.move_pad("one", "mood", -0.5)
    assert mix(scene, 5.0) == pytest.approx(MOOD.mix_at((-0.5,)))


def test_a_goal_in_a_pause_leaves_the_call_by_which_a_hand_takes_the_pad_up(scene: Scene) -> None:
    """Back in a pause of the cues held that call at once, with all that it was making way for."""
    scene.move_pad("one", "mood", 1.0)
    shown = [mix(scene, STEP / 4).get("jawOpen", 0.0) for _ in range(40)]
    scene.call_goal("one/expression", goal_of_point("mood", (0.9,)), seconds=4.0, pace=0.0)
    shown += [mix(scene, STEP / 4).get("jawOpen", 0.0) for _ in range(2)]
    speeds = np.diff(shown) / (STEP / 4)
    assert speeds[-3] > 1.0
    assert speeds[-1] == pytest.approx(speeds[-3], rel=0.2)


def test_a_goal_takes_a_pad_up_from_what_shows_and_no_seconds_cut(scene: Scene) -> None:
    scene.call_goal("one/expression", goal_of_point("mood", (1.0,)), seconds=2.0)
    half = mix(scene)
    assert half == pytest.approx({"neutral": 0.5, "jawOpen": 0.5})
    assert mix(scene) == {"jawOpen": 1.0}
    scene.call_goal("one/expression", goal_of_point("mood", (-1.0,)), seconds=0.0)
    assert mix(scene, 0.0) == {"smile": 1.0}


def test_a_goal_of_the_whole_face_takes_the_regions_along(scene: Scene) -> None:
    scene.move_pad("one", "mood", 0.0)
    scene.move_pad("one", "lips", 1.0)
    assert mouth(scene) == {"jawOpen": 1.0}
    assert scene.goal_of("one/mouth") == goal_of_point("lips", (1.0,))
    scene.call_goal("one/expression", goal_of_point("mood", (-1.0,)), seconds=1.0)
    assert scene.goal_of("one/mouth") == {}
    frame = scene.advance(2.0).characters["one"].frame
    assert (frame.expressions, frame.regions) == ({"smile": 1.0}, {})


@pytest.mark.parametrize(
    ("part", "goal", "message"),
    [
        ("one/expression", goal_of_point("gone", (0.0,)), "there is no pad 'gone'"),
        ("one/expression", goal_of_point("lips", (0.0,)), "the pad lips plays the mouth, not the expression"),
        ("one/mouth", goal_of_point("lips", (0.0, 0.0)), "which has 1 dimensions"),
    ],
)
def test_a_goal_that_no_pad_has_is_refused(scene: Scene, part: str, goal: Weights, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        scene.call_goal(part, goal)


def test_cues_move_points_and_go_back(scene: Scene) -> None:
    cues = (
        Cue("a", "1", {"one/expression": Move(goal_of_point("mood", (-1.0,)), 1.0)}),
        Cue("b", "2", {"one/expression": Move(goal_of_point("mood", (1.0,)), 1.0)}),
    )
    player = CuePlayer(scene, cues)
    player.go()
    player.advance(1.5)
    player.go()
    assert player.advance(1.5).characters["one"].frame.expressions == {"jawOpen": 1.0}
    player.go_back()
    assert player.advance(1.5).characters["one"].frame.expressions == {"smile": 1.0}


def test_a_memory_keeps_the_mix_and_needs_no_pad(scene: Scene) -> None:
    scene.move_pad("one", "mood", 0.5)
    shown = mix(scene)
    scene.keep_memory("half")
    scene.drop_pad("mood")
    scene.move_pad("one", "lips", 1.0)
    scene.call_memory("half", seconds=1.0)
    assert mouth(scene, 2.0) == pytest.approx(shown)


@pytest.mark.parametrize("seconds", [0.0, 0.1, 0.5, 3.0])
def test_a_snapshot_goes_on_to_the_bit(scene: Scene, cast: Cast, seconds: float) -> None:
    scene.move_pad("one", "lips", 0.5)
    scene.move_pad("one", "mood", -1.0)
    scene.advance(0.05)
    scene.call_goal("one/expression", goal_of_point("mood", (1.0,)), seconds=2.0)
    scene.advance(seconds)
    written = msgspec.json.encode(scene.snapshot())
    other = Scene.restored(cast, msgspec.json.decode(written, type=SceneSnapshot))
    for _ in range(150):
        assert scene.advance(STEP) == other.advance(STEP)
    assert other.snapshot() == scene.snapshot()


def test_a_character_that_comes_back_plays_on_with_the_pads_of_now(scene: Scene) -> None:
    scene.add("two")
    scene.move_pad("two", "mood", 1.0)
    scene.advance(1.0)
    scene.remove("two", seconds=0.0)
    scene.advance(1.0)
    scene.rename_pad("mood", "temper")
    scene.restore("two", seconds=0.0)
    frame = scene.advance(1.0).characters["two"].frame
    assert (frame.expressions, frame.pads) == ({"jawOpen": 1.0}, {})


def test_a_look_that_a_cast_lacks_is_neutral_and_comes_with_it(scene: Scene, cast: Cast) -> None:
    scene.set_pad(replace(MOOD, looks=(replace(LOOKS[0], mix={"beam": 1.0}), *LOOKS[1:])))
    scene.move_pad("one", "mood", -1.0)
    assert mix(scene) == {"neutral": 1.0}
    scene.recast(cast.with_expressions(beam=cast.expressions["smile"]))
    assert mix(scene) == {"beam": 1.0}


def test_what_is_no_pad_is_refused(scene: Scene) -> None:
    with pytest.raises(TypeError, match="the pad is a str"):
        scene.set_pad("mood")  # type: ignore[arg-type]


def test_the_goal_of_a_pose_is_the_point_of_the_pad_that_plays_it(scene: Scene) -> None:
    looks = (PadLook("Stand", {"stand": 1.0}, (-1.0,)), PadLook("Bow", {"bow": 1.0}, (1.0,)))
    scene.set_pad(Pad("moves", "pose", 1, looks))
    goal = goal_of_point("moves", (0.5,))
    scene.call_goal("one/pose", goal, seconds=1.0)
    scene.advance(2.0)
    assert scene.goal_of("one/pose") == goal
    assert all(scene.goal_of(f"one/{part}") == {} for part in POSE_PARTS)
    with pytest.raises(ValueError, match="plays the pose, not the expression"):
        scene.call_goal("one/expression", goal)
