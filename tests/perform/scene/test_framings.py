"""A framing has one spelling, and says whom it holds and how much of them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.scene.character_names import ALL
from omote.perform.scene.framings import PORTRAIT, SHOT_SIZES, framing_of, framing_or_none, names_in, size_in
from tests.perform.scene.test_character_names import names


@given(st.lists(names, max_size=8), st.sampled_from(SHOT_SIZES))
def test_a_framing_says_its_characters_whatever_their_order_and_the_size_of_its_shot(
    characters: list[str], size: str
) -> None:
    framing = framing_of(characters, characters, size)
    assert framing == framing_of([*reversed(characters), *characters], characters, size)
    assert (names_in(framing), size_in(framing)) == (frozenset(characters), size)
    assert (framing == ALL) == (not characters and size == PORTRAIT)
    assert framing_or_none(framing, dict.fromkeys(characters)) == framing


def test_a_framing_of_a_stranger_of_a_text_or_of_no_size_is_rejected() -> None:
    with pytest.raises(ValueError, match="there is no character 'two'"):
        framing_of(["one", "two"], ["one", "three"])
    with pytest.raises(TypeError, match="give a list"):
        framing_of("one", ["one"])
    with pytest.raises(ValueError, match="there is no size of a shot 'knee'"):
        framing_of(["one"], ["one"], "knee")
    assert [framing_or_none(text, {"one": None}) for text in ("one:knee", "two:full", "one:portrait")] == [
        None,
        None,
        "one",
    ]
