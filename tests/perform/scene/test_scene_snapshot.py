"""A snapshot of a scene comes back exactly, and one that no scene has written is rejected."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.axis import Axis
from omote.perform.scene.goals import Goal
from omote.perform.scene.memories import Memories, Memory, Turning
from omote.perform.scene.movement import Movement
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_snapshot import SceneSnapshot, check_scene, names_held_by, without_time


def running(cast: Cast) -> SceneSnapshot:
    """Two characters, one on its way, and a framing that is called."""
    scene = Scene.begun(cast)
    two = scene.add("two", face="broad", label="Two")
    two.set_channel("jawOpen", 0.5)
    scene.enter("two", seconds=2.0)
    scene.place("two", x=1.0, turn=0.3, seconds=2.0)
    scene.call_framing(["one", "two"], seconds=3.0)
    scene.advance(0.7)
    scene.place("two", x=-1.0, seconds=2.0)
    scene.call_black(0.5, seconds=2.0, easing="late")
    scene.keep_memory("a")
    scene["one"].set_head(yaw=0.3, pitch=0.0, roll=0.0)
    scene.keep_memory("a")
    scene.call_memory("a", seconds=1.0)
    scene["one"].set_head(yaw=-0.3, pitch=0.0, roll=0.0)
    scene.call_memory("a", seconds=1.0)
    return scene.snapshot()


def test_it_is_written_and_read_exactly(cast: Cast) -> None:
    snapshot = running(cast)
    for form in (msgspec.msgpack, msgspec.json):
        assert form.decode(form.encode(snapshot), type=SceneSnapshot) == snapshot
    assert check_scene(snapshot, cast) is snapshot


def test_one_that_is_older_than_memories_has_none(cast: Cast) -> None:
    written = msgspec.json.decode(msgspec.json.encode(running(cast)))
    del written["memories"]
    for character in written["characters"].values():
        del character["turning"]
    assert Scene.restored(cast, msgspec.convert(written, SceneSnapshot)).advance(0.0).memories == ()


def test_one_that_is_older_than_black_has_the_picture_up(cast: Cast) -> None:
    snapshot = running(cast)
    scene = Scene.restored(cast, snapshot)
    assert (scene.advance(2.0).black, scene.advance(0.0).black_goal) == (0.5, 0.5)
    written = msgspec.json.decode(msgspec.json.encode(snapshot))
    del written["black"]
    frame = Scene.restored(cast, msgspec.convert(written, SceneSnapshot)).advance(0.0)
    assert (frame.black, frame.black_goal) == (0.0, 0.0)


def with_two(part: str, **changes: Any) -> Callable[[SceneSnapshot], SceneSnapshot]:
    def change(snapshot: SceneSnapshot) -> SceneSnapshot:
        two = snapshot.characters["two"]
        changed: Any = replace(getattr(two, part), **changes)
        return replace(snapshot, characters={**snapshot.characters, "two": replace(two, **{part: changed})})

    return change


def with_light_of_memory(snapshot: SceneSnapshot, light: Goal) -> SceneSnapshot:
    return replace(snapshot, memories=Memories({"a": Memory({"*/light": light})}))


FAR = Movement({"yaw": 9.0, "pitch": 0.0, "roll": 0.0})

BROKEN: dict[str, Callable[[SceneSnapshot], SceneSnapshot]] = {
    "there is no face 'gone'": with_two("performer", face=Axis("gone")),
    "two is at 9.0 seconds, its scene at": with_two("performer", time=9.0),
    "the label of a character is ''": with_two("standing", label=""),
    "the place of two: has presence; it must have x": with_two("standing", place=Movement({"presence": 1.0})),
    "the presence of two: presence is 2.0": with_two("standing", presence=Movement({"presence": 2.0})),
    "a character cannot be called 'A B'": lambda s: replace(s, characters={"A B": s.characters["one"]}),
    "the number of characters is 9.0": lambda s: replace(
        s, characters=dict.fromkeys(["a", "b", "c", "d", "e", "f", "g", "h", "i"], s.characters["one"])
    ),
    "there is no light 'candle'": lambda s: replace(s, light=Axis("candle")),
    "there is no framing 'three'": lambda s: replace(s, framing=Axis("three")),
    r"there is no framing 'two\+one'": lambda s: replace(s, framing=Axis("two+one")),
    "the fade of the picture: black is 2.0": lambda s: replace(s, black=Movement({"black": 2.0})),
    "the fade of the picture: has no numbers": lambda s: replace(s, black=Movement({})),
    r"the memory a: the weights of \*/light sum to 0": lambda s: with_light_of_memory(s, {}),
    r"the memory a: flat of \*/light is 3.0": lambda s: with_light_of_memory(s, {"flat": 3.0}),
    "the name of a memory is ''": lambda s: replace(s, memories=Memories({"": s.memories.kept["a"]})),
    "the way of the head: yaw is 9.0": lambda s: replace(
        s, characters={**s.characters, "one": replace(s.characters["one"], turning=Turning({"head": FAR}, 0))}
    ),
    "there is no part that turns 'neck'": lambda s: replace(
        s, characters={**s.characters, "one": replace(s.characters["one"], turning=Turning({"neck": FAR}, 0))}
    ),
    "the snapshot's time": lambda s: replace(s, time=math.inf),
}


@pytest.mark.parametrize("said", BROKEN)
def test_what_no_scene_has_written_is_rejected(cast: Cast, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        Scene.restored(cast, BROKEN[said](running(cast)))


def test_something_else_is_rejected(cast: Cast) -> None:
    other: Any = {"characters": {}}
    with pytest.raises(TypeError, match=r"the snapshot is a dict; expected what Scene.snapshot\(\) gives"):
        Scene.restored(cast, other)


def test_what_rests_is_the_same_whatever_the_clock_says(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.add("two")
    before = without_time(scene.snapshot())
    scene.advance(5.0)
    assert without_time(scene.snapshot()) == before
    scene["two"].set_channel("jawOpen", 0.1)
    assert without_time(scene.snapshot()) != before


def test_all_names_in_use_are_held(cast: Cast) -> None:
    faces, expressions, poses = names_held_by(running(cast))
    assert faces == {"generic", "broad"}
    assert expressions == {"neutral", "jawOpen"}
    assert poses == {"stand"}
