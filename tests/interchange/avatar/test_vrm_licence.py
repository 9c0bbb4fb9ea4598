"""Terms of use: words become VRM's terms, what is not said is strict, and nobody's face goes out without its author."""

import pytest

from omote.interchange.avatar.vrm_licence import CC0_URL, TERMS, Credit, parse_terms


def test_each_term_can_be_said_and_what_is_not_said_is_as_strict_as_vrm_has_it() -> None:
    strict = {name: values[0] for name, values in TERMS.items()}
    assert parse_terms(["strict"]) == strict
    assert parse_terms([]) is parse_terms([" , "]) is None
    for name, values in TERMS.items():
        for value in values:
            word = {True: "yes", False: "no"}.get(value, str(value)) if isinstance(value, bool) else value
            assert parse_terms([f" {name} = {word} "]) == strict | {name: value}
    assert parse_terms(["AVATARPERMISSION=Everyone,redistribution=true", "modification=prohibited"]) == strict | {
        "avatarPermission": "everyone",
        "allowRedistribution": True,
    }


def test_cc0_lets_everybody_do_everything() -> None:
    assert parse_terms(["CC0"]) == {name: values[-1] for name, values in TERMS.items()} | {"otherLicenseUrl": CC0_URL}


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["mine"], "'mine' is no term of use; give --licence strict"),
        (["strict,cc0"], "'strict' is no term of use"),
        (["modification"], "'modification' is no term of use"),
        (["modification=maybe"], "modification is 'maybe'; expected one of prohibited, allowModification, "),
        (["redistribution=maybe"], "allowRedistribution is 'maybe'; expected yes or no"),
        (["modification=prohibited", "Modification=prohibited"], "modification is given twice"),
    ],
)
def test_other_words_are_refused_with_those_that_there_are(words: list[str], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        parse_terms(words)


@pytest.mark.parametrize("authors", [(), ("",), ("Ann", " ")])
def test_a_vrm_has_an_author(authors: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="a VRM names who made it: give --author NAME"):
        Credit(authors)


def test_what_came_with_omote_is_free_and_an_own_face_is_asked_about() -> None:
    said = Credit(("Ann",), parse_terms(["strict"]))
    silent = Credit(("Ann",))
    assert silent.agreed("kaori", own=False) == parse_terms(["cc0"])
    assert said.agreed("kaori", own=False) == said.agreed("aunt", own=True) == parse_terms(["strict"])
    with pytest.raises(
        ValueError, match="'aunt' is an own face and not CC0 as the built-in cast is: say who may use it"
    ):
        silent.agreed("aunt", own=True)
    assert "came with Omote and is CC0" in silent.sentence("kaori")
    assert "aunt is by Ann, and others may use it so: avatarPermission onlyAuthor, " in said.sentence("aunt")
    assert "allowRedistribution no" in said.sentence("aunt")


def test_an_own_face_that_is_made_of_the_cast_alone_is_as_free() -> None:
    credit = Credit(("Ann",), free=frozenset({"aunt"}))
    assert credit.agreed("aunt", own=True) == parse_terms(["cc0"])
    assert "aunt is by Ann; it is made of nothing but faces that came with Omote and is CC0" in credit.sentence("aunt")
    with pytest.raises(ValueError, match="'uncle' is an own face"):
        credit.agreed("uncle", own=True)
