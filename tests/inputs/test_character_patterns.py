"""Whom a pattern in the place of a character means."""

import pytest

from omote.inputs.character_patterns import characters_meant, matches
from omote.inputs.osc_packet import OscError


@pytest.mark.parametrize(
    ("pattern", "meant"),
    [("one", True), ("*", True), ("o?e", True), ("{two,one}", True), ("[m-p]ne", True), ("[!o]ne", False),
     ("two", False), ("One", False), ("{two,three}", False), ("{one", False)],
)  # fmt: skip
def test_characters_are_meant_by_patterns(pattern: str, meant: bool) -> None:
    assert matches(pattern, "one") is meant


def test_all_of_several_are_the_show_s_own_all() -> None:
    assert characters_meant("*", ["one", "two"]) == ("*",)
    assert characters_meant("{one,two}", ["one", "two", "three"]) == ("one", "two")
    assert characters_meant("*", ["one"]) == ("one",)


def test_nobody_is_refused_with_who_there_is() -> None:
    with pytest.raises(OscError, match="there is no character 'three'; there is one, two, and \\* for all"):
        characters_meant("three", ["one", "two"])
