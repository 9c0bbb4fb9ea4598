"""The parts that messages play."""

from typing import get_args

import pytest

from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects.calls import Panic
from omote.show.objects.characters import RemoveCharacter
from omote.show.objects.faders import SetHead
from omote.show.objects.leases import LeasePart
from omote.show.objects.pictures import CallBlack, CallLight
from omote.show.ownership.parts import (
    CHARACTER_PARTS,
    REGION_PARTS,
    SCENE_PARTS,
    describe_key,
    expression_of,
    keys_of,
    keys_played,
    regions_of,
)


def test_every_message_of_a_client_plays_a_part_or_passes_whoever_holds_what() -> None:
    declared = [kind.plays for kind in CLIENT_MESSAGES if kind.plays is not None]
    played = {part for plays in declared for part in ((plays,) if isinstance(plays, str) else plays)}
    assert played | {*REGION_PARTS} == {*CHARACTER_PARTS, *SCENE_PARTS, "*"}


def test_a_message_plays_its_part_of_each_of_its_characters_or_of_the_scene(cast: Cast) -> None:
    scene = Scene.begun(cast)
    assert keys_played(SetHead("*", 0.0, 0.0, 0.0), ["one", "two"], scene) == ("one/head", "two/head")
    assert keys_played(CallLight("a", "flat", 1.0, "smooth"), [], scene) == ("*/light",)
    assert keys_played(CallBlack(1.0), ["one"], scene) == ("*/black",)
    assert keys_played(Panic("one"), ["one"], scene) == ()
    assert {*keys_played(RemoveCharacter("a", "one"), ["one"], scene)} == {f"one/{part}" for part in CHARACTER_PARTS}


def test_all_parts_of_all_are_those_of_the_scene_too() -> None:
    assert {*keys_of(["one"], "*")} < {*keys_of(["one"], "*", whole_scene=True)}
    assert {*CHARACTER_PARTS, *SCENE_PARTS, "*"} == {*get_args(LeasePart)}


@pytest.mark.parametrize("part", SCENE_PARTS)
def test_a_part_of_the_scene_is_no_characters(part: str) -> None:
    with pytest.raises(ValueError, match=r"belongs to the scene: lease it with the character \*"):
        keys_of(["one"], part)


def test_an_expression_moves_its_regions_and_nothing_else_does() -> None:
    assert [expression_of(key) for key in regions_of("one/expression")] == ["one/expression"] * len(REGION_PARTS)
    for part in {*CHARACTER_PARTS} - {"expression"}:
        assert regions_of(f"one/{part}") == ()
        assert expression_of(f"one/{part}") == ("one/expression" if part in REGION_PARTS else "")


def test_parts_are_named_in_words() -> None:
    assert [describe_key(key, {"one": "One", "two": "Rex"}) for key in ("one/face", "two/channels", "*/light")] == [
        "the face of one",
        "the channels of two (Rex)",
        "the light",
    ]
