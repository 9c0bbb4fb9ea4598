"""Names of characters are plain, and a framing has one spelling."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.scene.character_names import ALL, LONGEST_NAME, check_character_name, framing_of, names_in

names = st.from_regex(rf"[a-z0-9_-]{{1,{LONGEST_NAME}}}", fullmatch=True)


@given(names)
def test_what_addresses_can_hold_is_a_name(name: str) -> None:
    assert check_character_name(name) == name


@pytest.mark.parametrize("name", ["", "Kaori", "a b", "a+b", "*", "é", "x" * 25, "a/b", "a\n", 7, None])
def test_other_names_are_rejected(name: object) -> None:
    with pytest.raises(ValueError, match=r"a character cannot be called .* give 1 to 24 lower case letters"):
        check_character_name(name)


@given(st.lists(names, max_size=8))
def test_a_framing_names_its_characters_whatever_their_order(characters: list[str]) -> None:
    framing = framing_of(characters, characters)
    assert framing == framing_of([*reversed(characters), *characters], characters)
    assert names_in(framing) == frozenset(characters)
    assert (framing == ALL) == (not characters)


def test_a_framing_of_a_stranger_or_of_a_text_is_rejected() -> None:
    with pytest.raises(ValueError, match="there is no character 'two'"):
        framing_of(["one", "two"], ["one", "three"])
    with pytest.raises(TypeError, match="give a list"):
        framing_of("one", ["one"])
