"""Identifiers: valid, none twice, and what is one already stays."""

from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.exports.identifiers import identifiers


@given(st.lists(st.text(max_size=6), unique=True, max_size=8))
def test_identifiers_are_valid_and_none_is_there_twice(names: list[str]) -> None:
    found = identifiers(names)
    assert [*found] == names
    assert len({each.lower() for each in found.values()}) == len(names)
    assert all(each.isascii() and each.isidentifier() for each in found.values())


def test_what_is_an_identifier_stays() -> None:
    names = ["smile", "eyeBlinkLeft", "mouth_1"]
    assert identifiers(names) == dict(zip(names, names, strict=True))


def test_names_that_are_alike_are_told_apart() -> None:
    assert [*identifiers(["two words", "two-words", "Two_words"]).values()] == [
        "two_words",
        "two_words_1",
        "Two_words_2",
    ]
