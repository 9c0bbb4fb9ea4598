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
    assert characters_meant("*", {"one": "One", "two": "Two"}) == ("*",)
    assert characters_meant("{one,two}", dict.fromkeys(("one", "two", "three"), "")) == ("one", "two")
    assert characters_meant("*", {"one": "One"}) == ("one",)


def test_nobody_is_refused_with_who_there_is() -> None:
    with pytest.raises(
        OscError, match=r"there is no character 'three' in this scene, which has one, two \(Rex\), and \* for all"
    ):
        characters_meant("three", {"one": "One", "two": "Rex"})


@pytest.mark.parametrize(("written", "meant"), [("rex", "two"), ("REX", "two"), ("one", "one"), ("ana_maria", "three")])
def test_a_label_is_an_address_too_where_no_name_is(written: str, meant: str) -> None:
    labels = {"one": "Rex II", "two": "Rex", "three": "Ana Maria"}
    assert characters_meant(written, labels) == (meant,)


def test_a_label_that_several_have_is_refused_with_their_names() -> None:
    with pytest.raises(OscError, match="could be one or two"):
        characters_meant("rex", {"one": "Rex", "two": "rex"})
