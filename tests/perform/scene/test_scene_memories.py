"""Memories of a scene: what shows is kept, and comes back whole, in one breath, from whatever shows."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import Gaze, Head
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import SceneFrame
from omote.perform.scene.scene_snapshot import SceneSnapshot
from tests import synthetic

FACE = synthetic.FACES[1]


def played(cast: Cast) -> Scene:
    """Two characters that show much at once."""
    scene = Scene.begun(cast)
    two = scene.add("two", face=FACE)
    scene.enter("two", seconds=0.0)
    scene["one"].call_face(FACE, seconds=0.0)
    scene["one"].call_expression("jawOpen", seconds=0.0, strength=0.5)
    two.call_expression("jawOpen", seconds=0.0, region="mouth")
    scene["one"].set_head(yaw=0.5, pitch=0.1, roll=-0.2)
    two.set_gaze(yaw=0.3, pitch=-0.1)
    scene["one"].call_pose(synthetic.POSES[1], seconds=0.0)
    two.call_pose(synthetic.POSES[2], seconds=0.0, region="arm_left")
    scene.call_light("flat", seconds=0.0)
    scene.call_framing(["two"], size="full", seconds=0.0)
    scene.advance(0.0)
    return scene


def look(frame: SceneFrame) -> dict[str, object]:
    """All that a memory has of a frame."""
    frames = {name: each.frame for name, each in frame.characters.items()}
    mixes = {name: (dict(on.faces), dict(on.expressions), dict(on.regions)) for name, on in frames.items()}
    figures = {
        f"{name} stands": on.figure and (on.figure.poses, on.figure.regions, on.figure.bodies)
        for name, on in frames.items()
    }
    turns = {f"{name} turns": (on.head, on.gaze) for name, on in frames.items()}
    return {**mixes, **figures, **turns, "light": dict(frame.light), "framing": dict(frame.framing)}


def play_other(scene: Scene) -> None:
    """Changes all of it."""
    for character in ("one", "two"):
        scene[character].call_face("generic", seconds=0.4)
        scene[character].call_expression("neutral", seconds=0.4)
        scene[character].call_pose(synthetic.POSES[0], seconds=0.4)
        scene[character].set_head(yaw=-0.4, pitch=0.0, roll=0.0)
        scene[character].set_gaze(yaw=-0.2, pitch=0.0)
    scene.call_light("theatre", seconds=0.4)
    scene.call_framing((), seconds=0.4)


def test_it_brings_back_all_that_was_kept_at_the_end_of_its_time_and_not_before(cast: Cast) -> None:
    scene = played(cast)
    kept = look(scene.advance(0.0))
    scene.keep_memory("finale")
    play_other(scene)
    shown = look(scene.advance(0.2))  # in the middle of other calls
    scene.call_memory("finale", seconds=2.0)
    assert look(scene.advance(0.0)) == shown
    half = scene.advance(1.0)
    assert half.light_call is not None
    assert half.light_call.remaining == 1.0
    assert half.characters["one"].frame.head.yaw == pytest.approx((0.5 - 0.4) / 2)
    assert look(half) != kept
    assert look(scene.advance(1.0)) == kept
    assert scene.advance(0.0).memories == ("finale",)


def test_a_cut_is_there_at_once(cast: Cast) -> None:
    scene = played(cast)
    kept = look(scene.advance(0.0))
    scene.keep_memory("finale")
    play_other(scene)
    scene.advance(0.2)
    scene.call_memory("finale", seconds=0.0)
    assert look(scene.advance(0.0)) == kept


@given(steps=st.lists(st.floats(0.01, 0.7), min_size=1, max_size=6), seconds=st.floats(0.3, 3.0))
def test_no_angle_jumps_when_it_is_called_again_on_its_way(cast: Cast, steps: list[float], seconds: float) -> None:
    scene = played(cast)
    scene.keep_memory("left")
    scene["one"].set_head(yaw=-0.5, pitch=0.0, roll=0.0)
    scene.keep_memory("right")
    before = scene.advance(0.0).characters["one"].frame.head.yaw
    for number, step in enumerate(steps):
        scene.call_memory("left" if number % 2 == 0 else "right", seconds=seconds)
        assert scene.advance(0.0).characters["one"].frame.head.yaw == pytest.approx(before)
        before = scene.advance(step).characters["one"].frame.head.yaw
    assert abs(scene.advance(10.0).characters["one"].frame.head.yaw) == 0.5


def test_a_hand_and_a_panic_end_the_way_of_what_they_move(cast: Cast) -> None:
    scene = played(cast)
    scene.keep_memory("a")
    play_other(scene)
    scene.call_memory("a", seconds=1.0)
    scene.advance(0.5)
    scene["one"].set_head(yaw=0.0, pitch=0.0, roll=0.3)
    scene["two"].panic()
    later = scene.advance(2.0)
    assert later.characters["one"].frame.head == Head(0.0, 0.0, 0.3)
    assert later.characters["two"].frame.gaze == Gaze()
    assert dict(later.characters["one"].frame.faces) == {FACE: 1.0}, "the other parts go on"


def test_it_goes_on_from_a_snapshot_frame_by_frame_the_same(cast: Cast) -> None:
    scene = played(cast)
    scene.keep_memory("a")
    play_other(scene)
    scene.call_memory("a", seconds=1.0)
    scene.advance(0.4)
    written = msgspec.msgpack.encode(scene.snapshot())
    other = Scene.restored(cast, msgspec.msgpack.decode(written, type=SceneSnapshot))
    for step in (0.1, 0.2, 0.5):
        assert other.advance(step) == scene.advance(step)


def test_what_has_gone_is_named_and_nothing_changes(cast: Cast) -> None:
    scene = played(cast)
    scene.keep_memory("a")
    scene.remove("two", seconds=0.0)
    scene.advance(0.0)
    before = scene.snapshot()
    with pytest.raises(ValueError, match="the memory 'a' cannot be called any more: there is no character 'two'"):
        scene.call_memory("a")
    assert scene.snapshot() == before


def test_a_change_of_a_memory_is_taken_back_and_done_again(cast: Cast) -> None:
    scene = played(cast)
    first = look(scene.advance(0.0))
    scene.keep_memory("a", key="1")
    scene["one"].call_face("generic", seconds=0.0)
    second = look(scene.advance(0.0))
    scene.keep_memory("a", key="2")
    scene.delete_memory("a", key="3")

    def called() -> dict[str, object]:
        scene.call_memory("a", seconds=0.0)
        return look(scene.advance(0.0))

    scene.restore_memory("3")
    assert called() == second
    scene.restore_memory("2")
    assert called() == first
    scene.restore_memory("2")
    assert called() == second
    scene.restore_memory("2")
    scene.restore_memory("1")
    assert scene.advance(0.0).memories == ()
    scene.restore_memory("1")
    assert called() == first
