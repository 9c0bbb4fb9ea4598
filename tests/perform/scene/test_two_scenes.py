"""A second scene follows who is in the first and keeps all else of its own; what differs is found and called."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.scene.goals import WITH_FACE
from omote.perform.scene.scene import Scene
from omote.perform.scene.two_scenes import differing_parts, follow, shared_of, take_parts


@pytest.fixture
def first(cast: Cast) -> Scene:
    scene = Scene.begun(cast)
    scene.add("two", face="broad", label="Two")
    scene.enter("two", seconds=0.0)
    scene.advance(1.0)
    return scene


@pytest.fixture
def second(cast: Cast, first: Scene) -> Scene:
    scene = Scene.restored(cast, first.snapshot())
    scene["one"].call_face("long", seconds=0.0)
    scene.call_framing(["two"], seconds=0.0)
    return scene


def test_a_scene_that_follows_one_with_its_cast_stays_as_it_is(first: Scene, second: Scene) -> None:
    own = second.snapshot()
    assert follow(own, first.snapshot()) == own
    assert shared_of(own) == shared_of(first.snapshot())


def test_who_comes_comes_as_it_is_there_and_who_goes_goes_with_its_shots(
    cast: Cast, first: Scene, second: Scene
) -> None:
    first.add("three", face="long")
    first.remove("two", seconds=0.0)
    first.advance(0.5)
    followed = Scene.restored(cast, follow(second.snapshot(), first.snapshot()))
    assert list(followed) == ["one", "three"]
    assert followed.goal_of("one/face") == {"long": 1.0}
    assert followed.goal_of("three/face") == {"long": 1.0}
    assert followed.goal_of("*/framing") == first.goal_of("*/framing")
    assert shared_of(followed.snapshot()) == shared_of(first.snapshot())


def test_labels_points_and_memories_are_those_of_the_first(cast: Cast, first: Scene, second: Scene) -> None:
    second.set_gaze_point("own", x=0.0, y=0.0, z=1.0)
    second["one"].look_at("gaze_point", "own")
    first.set_gaze_point("seat", x=0.0, y=0.0, z=2.0)
    first.rename("two", "Rex")
    first.keep_memory("opening")
    followed = Scene.restored(cast, follow(second.snapshot(), first.snapshot()))
    frame = followed.advance(0.0)
    assert (set(frame.gaze_points), followed.labels["two"], frame.memories) == ({"seat"}, "Rex", ("opening",))
    motion = frame.characters["one"].frame.motion
    assert motion is not None
    assert motion.target.kind == "ahead"


def test_who_leaves_the_first_has_no_parts_and_leaves_the_second(cast: Cast, first: Scene, second: Scene) -> None:
    first.remove("two", seconds=1.0)
    second["two"].call_face("long", seconds=0.0)
    assert "two/face" not in differing_parts(second, first)
    followed = Scene.restored(cast, follow(second.snapshot(), first.snapshot()))
    assert list(followed.advance(1.5).characters) == ["one"]


def test_only_what_differs_is_found_and_a_region_that_merges_is_the_same(first: Scene, second: Scene) -> None:
    assert differing_parts(second, first) == ["*/framing", "one/face"]
    second["one"].call_expression("smile", region="mouth", seconds=0.0)
    second["one"].call_expression("neutral", region="mouth", seconds=3.0)  # its own way still, to where the face is
    assert differing_parts(second, first) == ["*/framing", "one/face"]
    assert second.goal_of("one/mouth") != WITH_FACE


def test_a_t_bar_in_the_middle_is_what_shows(first: Scene, second: Scene) -> None:
    second["one"].call_face("broad", seconds=float("inf"))
    second["one"].fade_face(0.5)
    second.advance(1.0)
    shown = second.shown_goal("one/face")
    assert 0.0 < shown["broad"] < 1.0
    take_parts(second, first, differing_parts(second, first), seconds=0.0)
    assert first.goal_of("one/face") == shown


@pytest.mark.parametrize("wrong", ["one/nose", "zoe", "zoe/face"])
def test_a_part_that_there_is_not_is_rejected(first: Scene, second: Scene, wrong: str) -> None:
    with pytest.raises(ValueError, match="there is no part"):
        differing_parts(second, first, [wrong])


def test_channels_that_are_called_again_go_on_at_their_speed(first: Scene) -> None:
    """No weight jumps, and none changes its speed by more than a step of a smooth way does."""
    rng = np.random.default_rng(3)
    names = ("jawOpen", "smile", "browInnerUp")
    step = 1.0 / 240.0
    at = []
    for _ in range(25):
        first.call_channels(
            "one", {str(name): float(rng.uniform(0.0, 1.0)) for name in rng.choice(names, 2)}, seconds=1.0
        )
        for _ in range(int(rng.integers(1, 200))):
            channels = first.advance(step).characters["one"].frame.channels
            at.append([channels.get(name, 0.0) for name in names])
    speed = np.diff(np.array(at), axis=0) / step
    assert np.abs(speed).max() < 4.0
    assert np.abs(np.diff(speed, axis=0)).max() < 0.35


def test_a_hand_on_one_channel_ends_the_way_of_all(first: Scene) -> None:
    first.call_channels("one", {"jawOpen": 1.0, "smile": 1.0}, seconds=1.0)
    first.advance(0.5)
    first["one"].set_channel("smile", 0.0)
    assert first.advance(2.0).characters["one"].frame.channels == {"jawOpen": 0.5}


def test_a_source_that_begins_to_play_leaves_ways_of_head_and_channels_as_they_go(first: Scene) -> None:
    """Layers took what hands hold for the jump of a hand: a head on its way stopped when a clip or a tracker came."""
    step = 1.0 / 240.0
    at = []
    for tick in range(300):
        if tick == 10:
            first.call_goal("one/head", {"yaw": 0.6, "pitch": 0.0, "roll": 0.0}, seconds=1.0)
            first.call_channels("one", {"jawOpen": 0.5}, seconds=1.0)
        if tick == 100:
            first["one"].drive({"smile": 0.5}, layer="lips")
        frame = first.advance(step).characters["one"].frame
        at.append([frame.head.yaw, frame.channels.get("jawOpen", 0.0)])
    bends = np.abs(np.diff(np.array(at), 2, axis=0)).max(axis=0) / step
    assert bends.max() < 0.6 * 6.0 * step  # the smooth easing's largest acceleration is 5.8 of its way
    assert at[-1] == pytest.approx([0.6, 0.5], abs=1e-9)
