"""Names of characters are plain."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.scene.character_names import (
    LONGEST_NAME,
    check_character_name,
    describe_character,
    find_character,
)

names = st.from_regex(rf"[a-z0-9_-]{{1,{LONGEST_NAME}}}", fullmatch=True)


@given(names)
def test_what_addresses_can_hold_is_a_name(name: str) -> None:
    assert check_character_name(name) == name


@pytest.mark.parametrize("name", ["", "Kaori", "a b", "a+b", "*", "é", "x" * 25, "a/b", "a\n", 7, None])
def test_other_names_are_rejected(name: object) -> None:
    with pytest.raises(ValueError, match=r"a character cannot be called .* give 1 to 24 lower case letters"):
        check_character_name(name)


LABELS = {"one": "Ana", "two": "Big Rex", "ana": "One", "four": "Bo", "five": "BO"}


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("two", "two"), ("Two", "two"), ("Big Rex", "two"), ("big_rex", "two"), ("BIG-REX", "two"), ("ana", "ana"),
     ("Ana", "ana"), ("One", "one")],
)  # fmt: skip
def test_a_character_is_found_by_its_name_and_else_by_its_label(typed: str, meant: str) -> None:
    assert find_character(typed, LABELS) == meant


@pytest.mark.parametrize("typed", ["three", "", "*", "rex"])
def test_nobody_is_refused_with_all_that_there_are(typed: str) -> None:
    with pytest.raises(
        ValueError, match=r"there is no character .* in this scene, which has one \(Ana\), two \(Big Rex\)"
    ):
        find_character(typed, LABELS)


def test_a_label_that_several_have_is_refused_with_their_names() -> None:
    with pytest.raises(ValueError, match="the character 'bo' could be four or five; give one of these names"):
        find_character("bo", LABELS)


def test_a_character_is_described_with_a_label_that_is_not_its_name() -> None:
    assert [describe_character("two", label) for label in ("Two", "two", "Rex")] == ["two", "two", "two (Rex)"]
