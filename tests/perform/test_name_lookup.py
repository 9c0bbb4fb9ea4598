"""Names as people type them."""

import pytest

from omote.perform.name_lookup import find_name, find_names, fold, nearest

NAMES = ["crooked_smile", "smile", "jawOpen", "mouth-open", "mouth-parling", "Büste"]
LABELS = {"mouth-parling": "Lips parted", "smile": "Smile", "jawOpen": "Jaw open"}


@pytest.mark.parametrize(
    "typed", ["crooked_smile", "crooked-smile", "Crooked Smile", "CROOKEDSMILE", " crooked  smile "]
)
def test_case_spaces_hyphens_and_underscores_make_no_other_name(typed: str) -> None:
    assert find_name(typed, NAMES, "expression", LABELS) == "crooked_smile"


@pytest.mark.parametrize("name", NAMES)
def test_every_name_finds_itself_however_it_is_written(name: str) -> None:
    for typed in (name, name.upper(), name.replace("_", "-"), name.replace("-", " ")):
        assert find_name(typed, NAMES, "expression", LABELS) == name


def test_a_label_finds_its_name() -> None:
    assert find_name("lips parted", NAMES, "expression", LABELS) == "mouth-parling"
    assert find_name("jaw open", NAMES, "channel") == "jawOpen"
    assert find_name("buste", NAMES, "face") == "Büste"


def test_a_name_exactly_as_it_is_wins() -> None:
    assert find_name("a_b", ["a-b", "a_b"], "face") == "a_b"
    assert find_name("one", ["one", "two"], "face", {"two": "One"}) == "one"


def test_several_that_could_be_meant_are_named() -> None:
    with pytest.raises(ValueError, match="the face 'A B' could be a-b or a_b; write one of these names"):
        find_name("A B", ["a-b", "a_b"], "face")


def test_the_nearest_names_are_told() -> None:
    with pytest.raises(ValueError, match=r"there is no expression 'smle' in this cast; near are .*smile"):
        find_name("smle", NAMES, "expression", LABELS)
    assert nearest("lip parted", NAMES, LABELS)[0] == "mouth-parling"


@pytest.mark.parametrize("typed", ["", "--", "?"])
def test_nothing_is_nobody(typed: str) -> None:
    with pytest.raises(ValueError, match="there is no face"):
        find_name(typed, NAMES, "face")


def test_folding_twice_is_folding_once() -> None:
    assert fold(fold("Ärger-Lächeln 2")) == fold("Ärger-Lächeln 2") == "argerlacheln2"


def test_action_units_find_what_has_no_such_name() -> None:
    names = ["AU12", "eyeBlinkLeft", "eyeBlinkRight", "jawOpen"]
    assert find_name("AU 26", names, "expression") == find_name("jaw drop", names, "channel") == "jawOpen"
    assert find_name("au12", names, "expression") == "AU12", "an own name wins"
    assert find_name("AU45R", names, "expression") == "eyeBlinkRight"
    assert find_names("AU45", names, "channel") == ("eyeBlinkLeft", "eyeBlinkRight")
    with pytest.raises(ValueError, match=r"AU45 is eyeBlinkLeft and eyeBlinkRight together; write one of them, or"):
        find_name("AU45", names, "expression")
    with pytest.raises(ValueError, match=r"there is no expression 'AU4' in this cast; no channel is AU4; there"):
        find_name("AU4", names, "expression")
    with pytest.raises(ValueError, match=r"there is no face 'AU26' in this cast; (near|there) are"):
        find_name("AU26", names, "face")
