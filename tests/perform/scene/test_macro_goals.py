"""Macros that a cue moves: in its time from where they are, until a hand takes one."""

from __future__ import annotations

import pytest

from omote.model.cast import Cast
from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_player import CuePlayer
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.pads.blend_space import Pad, PadLook
from omote.perform.scene.scene import Scene


@pytest.fixture(name="scene")
def _scene(cast: Cast) -> Scene:
    scene = Scene.begun(cast)
    for name, channel in (("mouth", "jawOpen"), ("brows", "browInnerUp")):
        scene["one"].set_mapping(MacroMapping(name, (MacroTarget(f"channel/{channel}"),)))
    return scene


def values_of(scene: Scene, dt: float) -> dict[str, float]:
    return {name: macro.value for name, macro in scene.advance(dt).characters["one"].frame.macros.items()}


def test_a_cue_moves_macros_in_its_time_and_hands_take_them(scene: Scene) -> None:
    player = CuePlayer(scene, [Cue("a", "1", {"one/macros": Move({"mouth": 0.8, "brows": -0.4}, seconds=2.0)})])
    player.go()
    player.advance(0.0)
    player.advance(1.0)
    assert scene.goal_of("one/macros") == {"mouth": 0.8, "brows": -0.4}
    assert scene.shown_goal("one/macros") == pytest.approx({"mouth": 0.4, "brows": -0.2})
    scene["one"].move_macro("mouth", 0.1)
    assert values_of(scene, 2.0) == {"mouth": 0.1, "brows": -0.4}


def test_it_goes_on_after_a_snapshot_and_a_panic_ends_it(scene: Scene, cast: Cast) -> None:
    scene.call_goal("one/macros", {"mouth": 1.0}, seconds=1.0)
    scene.advance(0.5)
    other = Scene.restored(cast, scene.snapshot())
    assert other.advance(0.25) == scene.advance(0.25)
    scene["one"].panic()
    assert values_of(scene, 1.0) == {"mouth": 0.0, "brows": 0.0}
    assert values_of(other, 1.0) == {"mouth": 1.0, "brows": 0.0}


def test_what_there_is_not_is_refused(scene: Scene) -> None:
    for goal, said in (({"eyes": 0.5}, "no macro 'eyes'"), ({"mouth": 2.0}, "-1 to 1"), ({"a/b": 0.5}, "addresses")):
        with pytest.raises(ValueError, match=said):
            scene.call_goal("one/macros", goal)


def test_a_macro_moves_the_point_of_a_pad_until_another_hand_does(scene: Scene, cast: Cast) -> None:
    one, other = sorted(name for name in cast.expressions if name != "neutral")[:2]
    looks = [PadLook(one, {one: 1.0}, (-1.0, 0.0)), PadLook(other, {other: 1.0}, (1.0, 0.0))]
    scene.set_pad(Pad("mix", "expression", 2, tuple(looks)))
    targets = (MacroTarget("pad/mix/x", low=-1.0, rise=0.1), MacroTarget("pad/gone/x"), MacroTarget("pad/mix/z"))
    scene["one"].set_mapping(MacroMapping("blend", targets))
    scene["one"].move_macro("blend", 1.0)
    frame = [scene.advance(1 / 60) for _ in range(90)][-1].characters["one"].frame
    assert dict(frame.expressions) == {other: 1.0}
    assert frame.pads["mix"].place == (1.0, 0.0)
    scene.move_pad("one", "mix", 0.25, 0.5)
    assert scene.advance(1.0).characters["one"].frame.pads["mix"].place == (0.25, 0.5)
    scene["one"].move_macro("blend", 0.5)
    assert scene.advance(8.0).characters["one"].frame.pads["mix"].place == (0.0, 0.5)
    scene["one"].drop_mapping("blend")
    assert scene.advance(1.0).characters["one"].frame.pads["mix"].place == (0.0, 0.5)
