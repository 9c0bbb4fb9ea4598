"""Mappings that say which names are near."""

from types import MappingProxyType

import pytest

from omote.model.cast import Cast
from omote.model.known_names import KnownNames, UnknownNameError, explain_unknown


def test_an_unknown_name_is_a_sentence_with_near_ones_and_a_key_error() -> None:
    names = KnownNames("face", {"dog": 1, "doll": 2, "old": 3})
    for mapping in (names, MappingProxyType(names)):
        with pytest.raises(KeyError) as raised:
            mapping["dgo"]
        assert str(raised.value) == "there is no face 'dgo' in this cast; near are dog, doll"
    assert names.get("dgo") is None
    assert "dgo" not in names


def test_what_has_no_names_says_so() -> None:
    with pytest.raises(UnknownNameError, match="no hair style 'bob' in this cast; there are none"):
        KnownNames[int]("hair style", {})["bob"]


def test_a_cast_is_asked_by_names(cast: Cast) -> None:
    for mapping, what in ((cast.faces, "face"), (cast.looks, "face"), (cast.titles, "expression")):
        with pytest.raises(KeyError, match=f"there is no {what} 'zzqqx' in this cast; there are "):
            mapping["zzqqx"]
    with pytest.raises(KeyError, match="there is no expression 'smil' in this cast; near are smile"):
        cast.expressions["smil"]


@pytest.mark.parametrize(
    ("name", "names", "what", "said"),
    [
        ("livlink", ["vmc", "livelink"], "tracker", "there is no tracker 'livlink'; near are livelink"),
        ("xyz", ["vmc", "osc"], "way to send a face", "there is no way to send a face 'xyz'; there are vmc, osc"),
        ("zzqqx", list("abcde"), "face", "there is no face 'zzqqx' in this cast; there are a, b, c and 2 more"),
        ("zzqqx", ["one", "two"], "character", "there is no character 'zzqqx' in this scene; there are one, two"),
        ("tow", ["one", "two"], "character", "there is no character 'tow' in this scene; near are two"),
        ("Mria", ["Mira"], "performer", "there is no performer 'Mria' in this show; near are Mira"),
    ],
)
def test_where_a_name_is_not_depends_on_its_kind(name: str, names: list[str], what: str, said: str) -> None:
    assert explain_unknown(name, names, what) == said


def test_an_action_unit_is_told_which_expression_it_is(cast: Cast) -> None:
    with pytest.raises(KeyError, match="there is no expression 'AU26' in this cast; AU26 is jawOpen"):
        cast.expressions["AU26"]
    with pytest.raises(KeyError, match=r"there is no face 'AU26' in this cast; (near|there) are "):
        cast.faces["AU26"]
