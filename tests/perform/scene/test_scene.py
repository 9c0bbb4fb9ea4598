"""Several characters: each plays as if it were alone, stands at its place, comes and goes without a jump."""

import math
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.easing import find_easing
from omote.perform.frame import Frame
from omote.perform.performer import Performer
from omote.perform.scene.framings import SHOT_SIZES
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import Place, SceneFrame
from omote.perform.scene.scene_snapshot import SceneSnapshot
from tests.conftest import Command, commands, shows

NAMES = ("one", "two", "three")
Order = tuple[str, Command]
orders = st.lists(st.tuples(st.sampled_from(NAMES), commands), max_size=30)
waits = st.floats(0.0, 1.0)
directions = st.one_of(
    st.tuples(st.just("place"), st.sampled_from(NAMES), st.floats(-2.0, 2.0), waits),
    st.tuples(st.just("enter"), st.sampled_from(NAMES), waits),
    st.tuples(st.just("leave"), st.sampled_from(NAMES), waits),
    st.tuples(st.just("remove"), st.just("three"), waits),
    st.tuples(st.just("framing"), st.sets(st.sampled_from(NAMES[:2])), st.sampled_from([None, *SHOT_SIZES]), waits),
    st.tuples(st.just("light"), st.sampled_from(["theatre", "flat"]), waits),
    st.tuples(st.just("black"), st.floats(0.0, 1.0), waits),
)


def scene_of(cast: Cast, names: tuple[str, ...] = NAMES) -> Scene:
    scene = Scene(cast)
    for name in names:
        scene.add(name)
    return scene


def direct(scene: Scene, what: tuple[Any, ...]) -> None:
    """What an operator does to the scene, not to a character in it."""
    match what:
        case ("place", name, x, seconds) if name in scene:
            scene.place(name, x=x, size=2.0, seconds=seconds)
        case ("enter" | "leave" | "remove" as change, name, seconds) if name in scene:
            getattr(scene, change)(name, seconds=seconds)
        case ("framing", names, size, seconds):
            scene.call_framing(names or None, size=size, seconds=seconds)
        case ("light", name, seconds):
            scene.call_light(name, seconds=seconds)
        case ("black", black, seconds):
            scene.call_black(black, seconds=seconds)


@given(shows)
def test_one_character_alone_gives_the_frames_of_a_performer(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    scene = Scene.begun(cast)
    for command in show:
        command.play(performer)
        command.play(scene["one"])
        frame = scene.advance(command.wait)
        alone = performer.advance(command.wait)
        assert frame.characters["one"].frame == alone
        assert (frame.light, frame.light_call, frame.time) == (alone.light, alone.light_call, alone.time)
        assert (frame.characters["one"].place, frame.characters["one"].presence) == (Place(), 1.0)
        assert (frame.framing, frame.framing_call) == ({"*": 1.0}, None)


@given(orders, st.permutations(NAMES), st.lists(directions, max_size=5))
def test_characters_do_not_influence_each_other_in_whatever_order_they_were_added(
    cast: Cast, show: list[Order], names: list[str], moves: list[tuple[Any, ...]]
) -> None:
    show = [(name, command) for name, command in show if command.name != "call_light"]
    scene = scene_of(cast, tuple(names))
    performers = {name: Performer(cast) for name in NAMES}
    for move in [each for each in moves if each[0] not in ("remove", "light")]:
        direct(scene, move)
    for name, command in show:
        command.play(scene[name])
        command.play(performers[name])
        frame = scene.advance(command.wait)
        alone = {each: performer.advance(command.wait) for each, performer in performers.items()}
        assert {each: character.frame for each, character in frame.characters.items()} == alone


@given(orders, st.lists(directions, max_size=8), orders, st.lists(directions, max_size=8))
def test_a_restored_scene_plays_on_frame_by_frame_the_same(
    cast: Cast, show: list[Order], moves: list[tuple[Any, ...]], later: list[Order], more: list[tuple[Any, ...]]
) -> None:
    original = scene_of(cast)
    run(original, show, moves)
    written = msgspec.msgpack.encode(original.snapshot())
    restored = Scene.restored(cast, msgspec.msgpack.decode(written, type=SceneSnapshot))
    assert restored.snapshot() == original.snapshot()
    assert list(restored) == list(original)
    assert run(restored, later, more) == run(original, later, more)


def run(scene: Scene, show: list[Order], moves: list[tuple[Any, ...]]) -> list[SceneFrame]:
    frames = []
    for name, command in show:
        if name in scene:
            command.play(scene[name])
        frames.append(scene.advance(command.wait))
    for move in moves:
        direct(scene, move)
        frames.append(scene.advance(0.1))
    return frames


@given(st.lists(directions, max_size=12), directions)
def test_no_call_makes_a_jump(cast: Cast, moves: list[tuple[Any, ...]], last: tuple[Any, ...]) -> None:
    if last[-1] < 0.05:  # a cut is one
        return
    scene = scene_of(cast)
    run(scene, [], moves)
    before = scene.advance(0.0)
    direct(scene, last)
    after = scene.advance(0.0)
    for name, character in after.characters.items():
        for number in ("x", "depth", "size", "turn"):
            was = getattr(before.characters[name].place, number)
            assert getattr(character.place, number) == pytest.approx(was, abs=1e-9)
        assert character.presence == pytest.approx(before.characters[name].presence, abs=1e-9)
    for mix, was in ((after.framing, before.framing), (after.light, before.light)):
        assert {**dict.fromkeys(was, 0.0), **mix} == pytest.approx({**dict.fromkeys(mix, 0.0), **was}, abs=1e-9)
    assert math.fsum(after.framing.values()) == pytest.approx(1.0)


def test_a_character_that_is_removed_leaves_first_and_shots_go_on_without_it(cast: Cast) -> None:
    scene = scene_of(cast)
    for name in NAMES:
        scene.enter(name, seconds=0.0)
    scene.call_framing(["one", "two"], seconds=0.0)
    scene.remove("two", seconds=1.0)
    half = scene.advance(0.5)
    assert (half.characters["two"].presence, half.characters["two"].leaves) == (0.5, True)
    assert half.framing == pytest.approx({"one+two": 0.5, "one": 0.5})
    gone = scene.advance(0.5)
    assert [*gone.characters] == ["one", "three"]
    assert gone.framing == {"one": 1.0}
    with pytest.raises(KeyError, match="there is no character 'two'"):
        scene["two"]
    assert scene.add("two") is scene["two"]


def test_it_stays_until_no_shot_holds_it(cast: Cast) -> None:
    scene = scene_of(cast)
    scene.call_framing(["two"], seconds=0.0)
    scene.call_framing(["one"], seconds=5.0)
    scene.remove("two", seconds=1.0)
    assert "two" in scene.advance(4.0).characters
    assert "two" not in scene.advance(1.0).characters


def test_one_that_enters_again_before_it_is_gone_stays(cast: Cast) -> None:
    scene = scene_of(cast)
    scene.enter("two", seconds=0.0)
    scene.remove("two", seconds=1.0)
    scene.advance(0.5)
    scene.leave("two", seconds=1.0)
    assert scene.advance(0.1).characters["two"].leaves, "leaving keeps it no more than before"
    scene.enter("two", seconds=1.0)
    character = scene.advance(2.0).characters["two"]
    assert (character.presence, character.leaves) == (1.0, False)


def test_who_plays_the_light_is_an_operator_for_every_panic(cast: Cast) -> None:
    scene = scene_of(cast)
    for name in NAMES:
        scene[name].call_face("broad", seconds=0.0)
        scene[name].panic()
    assert all(character.frame.home_next for character in scene.advance(1.0).characters.values())
    scene["one"].call_light("flat")
    assert not any(character.frame.home_next for character in scene.advance(0.0).characters.values())


def test_black_comes_from_what_is_showing_and_stays_through_a_panic(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.call_black(1.0, seconds=2.0, easing="late")
    frame = scene.advance(1.0)
    assert (frame.black, frame.black_goal) == (find_easing("late").value(0.5), 1.0)
    scene.call_black(0.0, seconds=2.0)
    turned = scene.advance(1e-3)
    assert turned.black == pytest.approx(frame.black + 1e-3 * find_easing("late").rate(0.5) / 2.0, abs=1e-5)
    assert turned.black_goal == 0.0
    scene.call_black(1.0, seconds=0.0)
    for _ in range(2):
        scene["one"].panic()
        assert (scene.advance(3.0).black, scene["one"].advance(0.0).panics > 0) == (1.0, True)


def test_black_is_no_play_of_a_face_so_the_home_face_comes_in_the_dark(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene["one"].call_face("broad", seconds=0.0)
    scene["one"].panic()
    scene.call_black(1.0, seconds=0.0)
    assert scene.advance(1.0).characters["one"].frame.home_next


WRONG: dict[str, Any] = {
    "a character cannot be called 'Two'": lambda scene: scene.add("Two"),
    "there is a character 'two' already": lambda scene: scene.add("two"),
    "there is no face 'brood'": lambda scene: scene.add("four", face="brood"),
    "the label of a character is ' '": lambda scene: scene.rename("two", " "),
    "the label of a character is 'xxx": lambda scene: scene.rename("two", "x" * 81),
    "a character cannot be labelled 'one/face', for / has": lambda scene: scene.rename("two", "one/face"),
    r"a character cannot be labelled '\*', for \* has": lambda scene: scene.add("four", label="*"),
    "there is no character 'four'": lambda scene: scene.place("four", x=0.0),
    "the size of a place is 9": lambda scene: scene.place("two", size=9.0),
    r"the time of a call \(seconds\) is -1": lambda scene: scene.enter("two", seconds=-1.0),
    "there is no easing 'bounce'": lambda scene: scene.call_framing(["two"], easing="bounce"),
    r"the time of a call \(seconds\) is no number": lambda scene: scene.remove("two", seconds=math.nan),
    "there is no easing 'jump'": lambda scene: scene.call_black(1.0, easing="jump"),
    "how black the picture is is 1.5": lambda scene: scene.call_black(1.5),
    r"the time of a call \(seconds\) is 4000": lambda scene: scene.call_black(1.0, seconds=4000.0),
    r"the time step \(seconds\) is -1": lambda scene: scene.advance(-1.0),
}


@pytest.mark.parametrize("said", WRONG)
def test_what_cannot_be_is_rejected_and_changes_nothing(cast: Cast, said: str) -> None:
    scene = scene_of(cast)
    before = scene.snapshot()
    with pytest.raises(ValueError, match=said):
        WRONG[said](scene)
    assert scene.snapshot() == before


def test_there_are_at_most_eight(cast: Cast) -> None:
    scene = scene_of(cast, tuple("abcdefgh"))
    with pytest.raises(ValueError, match="there are 8 characters, which is as many as a scene holds"):
        scene.add("i")
    assert (len(scene), "h" in scene, [*scene]) == (8, True, [*"abcdefgh"])


def test_another_cast_is_taken_by_all_or_by_none(cast: Cast) -> None:
    scene = scene_of(cast)
    scene["three"].call_face("broad", seconds=0.0)
    before = scene.snapshot()
    with pytest.raises(ValueError, match="there is no face 'broad'"):
        scene.recast(Cast(cast.space, {k: v for k, v in cast.faces.items() if k != "broad"}, dict(cast.expressions)))
    assert scene.snapshot() == before
    scene["one"].call_face("broad")


def test_a_frame_of_a_character_is_one_of_the_engine(cast: Cast) -> None:
    assert isinstance(Scene.begun(cast).advance(0.0).characters["one"].frame, Frame)


def test_a_label_that_another_has_is_refused_and_nothing_changes(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.add("two", label="Rex")
    before = scene.snapshot()
    with pytest.raises(ValueError, match="the character two is called 'Rex' already; give another label"):
        scene.rename("one", " REX ")
    with pytest.raises(ValueError, match="the character one is called 'One' already; give another label"):
        scene.add("three", label="one")
    assert scene.snapshot() == before
    scene.rename("two", "REX")


def test_who_was_removed_comes_back_with_a_label_that_another_has_meanwhile(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.add("two", label="Rex")
    scene.remove("two", seconds=0.0)
    scene.advance(0.1)
    scene.rename("one", "Rex")
    scene.restore("two")
    assert scene.labels == {"one": "Rex", "two": "Rex"}
