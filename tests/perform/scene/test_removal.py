"""A character that was removed comes back as it was: what it plays, where it stands, its rank and its shot."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.scene.removal import insert_at_rank
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_snapshot import MOST_REMOVALS, CharacterSnapshot, Removal, SceneSnapshot
from tests.conftest import Command, shows

NAMES = ["one", "two", "three"]


def scene_of_three(cast: Cast) -> Scene:
    scene = Scene(cast)
    for name in NAMES:
        scene.add(name, label=name.title())
        scene.enter(name, seconds=0.0)
    return scene


@given(shows, st.floats(0.0, 3.0), st.floats(0.0, 2.0), st.floats(0.0, 2.0), st.booleans())
def test_who_is_removed_and_brought_back_is_as_if_never_removed(
    cast: Cast, show: list[Command], wait: float, seconds: float, back: float, held: bool
) -> None:
    scenes = [scene_of_three(cast) for _ in range(2)]
    for scene in scenes:
        for command in show:
            command.play(scene["two"])
            scene.advance(command.wait)
        scene.place("two", x=0.3, turn=0.5, seconds=0.0)
        scene.call_framing(["one", "two"] if held else [], seconds=0.0)
        scene.advance(10_000.0)  # a call that runs out while nobody is there would differ
    ours, other = scenes
    ours.remove("two", seconds=seconds)
    ours.advance(wait)
    ours.restore("two", seconds=back)
    other.advance(wait)
    assert ours.advance(10_000.0) == other.advance(10_000.0)
    assert list(ours) == NAMES


def test_nothing_jumps_on_the_way_back(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene.remove("two", seconds=1.0)
    before = scene.advance(0.5).characters["two"]
    scene.restore("two", seconds=1.0)
    after = scene.advance(0.0).characters["two"]
    assert replace(after, leaves=True) == before
    assert not after.leaves


def test_who_was_off_the_stage_comes_back_off_the_stage(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene.leave("two", seconds=0.0)
    scene.remove("two", seconds=0.0)
    scene.advance(0.0)
    scene.restore("two", seconds=0.0)
    assert scene.advance(1.0).characters["two"].presence == 0.0


def test_a_shot_that_was_called_since_stays(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene.call_framing(["one", "two"], seconds=0.0)
    scene.remove("two", seconds=0.0)
    scene.call_framing(["three"], seconds=0.0)
    scene.advance(0.0)
    scene.restore("two", seconds=0.0)
    assert scene.advance(0.0).framing == {"three": 1.0}


def test_two_of_one_name_come_back_by_their_keys(cast: Cast) -> None:
    scene = scene_of_three(cast)
    for key, weight in (("first", 0.25), ("second", 0.5)):
        scene["two"].set_channel("jawOpen", weight)
        scene.remove("two", seconds=0.0, key=key)
        scene.advance(0.0)
        scene.add("two")
    with pytest.raises(ValueError, match="there is a character 'two' already"):
        scene.restore("first")
    scene.remove("two", seconds=0.0)
    scene.advance(0.0)
    scene.restore("first")
    assert scene.advance(0.0).characters["two"].frame.channels == {"jawOpen": 0.25}


def test_who_enters_again_was_not_removed(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene.remove("two")
    scene.enter("two")
    with pytest.raises(ValueError, match="there is no removed character 'two'"):
        scene.restore("two")


def test_who_is_removed_twice_comes_back_as_before_the_first_time(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene.remove("two", key="a")
    scene.remove("two", key="b")
    scene.advance(5.0)
    scene.restore("b", seconds=0.0)
    assert scene.advance(0.0).characters["two"].presence == 1.0


def test_only_the_last_are_remembered(cast: Cast) -> None:
    scene = scene_of_three(cast)
    for number in range(MOST_REMOVALS + 1):
        scene.add("four")
        scene.remove("four", seconds=0.0, key=str(number))
        scene.advance(0.0)
    assert list(scene.snapshot().removals) == [str(number + 1) for number in range(MOST_REMOVALS)]


def test_what_the_cast_has_lost_cannot_come_back_and_nothing_changes(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene["two"].call_face("broad", seconds=0.0)
    scene.remove("two", seconds=0.0)
    scene.advance(0.0)
    lost = SimpleNamespace(faces={"generic": None}, expressions=cast.expressions, digest="")
    scene.recast(lost)
    before = scene.snapshot()
    with pytest.raises(ValueError, match="there is no face 'broad'"):
        scene.restore("two")
    assert scene.snapshot() == before


def test_a_full_scene_takes_nobody_back(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene.remove("two", seconds=0.0)
    scene.advance(0.0)
    for name in "abcdef":
        scene.add(name)
    with pytest.raises(ValueError, match="there are 8 characters"):
        scene.restore("two")


def test_removals_outlive_a_restart(cast: Cast) -> None:
    scene = scene_of_three(cast)
    scene["two"].set_channel("jawOpen", 0.5)
    scene.call_framing(["two"], seconds=0.0)
    scene.remove("two", seconds=1.0)
    written = msgspec.msgpack.encode(scene.snapshot())
    scene.advance(5.0)
    for snapshot in (written, msgspec.msgpack.encode(scene.snapshot())):
        other = Scene.restored(cast, msgspec.msgpack.decode(snapshot, type=SceneSnapshot))
        other.restore("two", seconds=0.0)
        frame = other.advance(0.0)
        assert frame.characters["two"].frame.channels == {"jawOpen": 0.5}
        assert frame.framing == {"two": 1.0}


def with_removals(snapshot: SceneSnapshot, **removals: Removal) -> SceneSnapshot:
    return replace(snapshot, removals=removals)


@pytest.mark.parametrize(
    ("said", "change"),
    [
        ("nothing is kept of gone, removed as x", {"character": "gone", "kept": None}),
        ("a character cannot be called 'A B'", {"character": "A B"}),
        ("the presence of two, removed as x, is 2.0", {"presence": 2.0}),
        ("the label of a character is ''", {"kept": "no label"}),
    ],
)
def test_removals_that_no_scene_has_written_are_rejected(cast: Cast, said: str, change: dict[str, Any]) -> None:
    snapshot = scene_of_three(cast).snapshot()
    two = snapshot.characters["two"]
    nameless = CharacterSnapshot(two.performer, replace(two.standing, label=""))
    changes: dict[str, Any] = {key: nameless if value == "no label" else value for key, value in change.items()}
    broken = with_removals(snapshot, x=replace(Removal("two", ("one",), 1.0, None, two), **changes))
    with pytest.raises(ValueError, match=said):
        Scene.restored(cast, broken)


@given(st.permutations(NAMES), st.sampled_from(NAMES))
def test_a_character_goes_back_to_its_rank(names: list[str], name: str) -> None:
    before = tuple(names[: names.index(name)])
    others = {each: 0 for each in names if each != name}
    assert list(insert_at_rank(others, name, 1, before)) == names
