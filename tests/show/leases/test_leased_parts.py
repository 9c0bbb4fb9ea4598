"""The parts that messages play."""

from typing import get_args

import pytest

from omote.show import messages as wire
from omote.show.leases.leased_parts import (
    CHARACTER_PARTS,
    FREE,
    PLAYS,
    REGION_PARTS,
    SCENE_PARTS,
    describe_key,
    expression_of,
    keys_of,
    keys_played,
    regions_of,
)


def test_every_message_of_a_client_plays_a_part_or_passes_whoever_holds_what() -> None:
    assert {*PLAYS} | {*FREE} == {*wire.CLIENT_MESSAGES}, "a new message needs a row in PLAYS or FREE"
    assert not {*PLAYS} & {*FREE}


def test_a_message_plays_its_part_of_each_of_its_characters_or_of_the_scene() -> None:
    assert keys_played(wire.SetHead("*", 0.0, 0.0, 0.0), ["one", "two"]) == ("one/head", "two/head")
    assert keys_played(wire.CallLight("a", "flat", 1.0, "smooth"), []) == ("*/light",)
    assert keys_played(wire.Panic("one"), ["one"]) == ()
    assert {*keys_played(wire.RemoveCharacter("a", "one"), ["one"])} == {f"one/{part}" for part in CHARACTER_PARTS}


def test_all_parts_of_all_are_those_of_the_scene_too() -> None:
    assert {*keys_of(["one"], "*")} < {*keys_of(["one"], "*", whole_scene=True)}
    assert {*CHARACTER_PARTS, *SCENE_PARTS, "*"} == {*get_args(wire.LeasePart)}


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
