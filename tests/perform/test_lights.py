"""The lights by name."""

import pytest

from omote.perform.lights import BACKGROUNDS, FIRST_LIGHT, LIGHTS, check_light, find_background


@pytest.mark.parametrize("name", LIGHTS)
def test_each_is_known_by_its_name(name: str) -> None:
    assert check_light(name) == name
    assert LIGHTS[name]


def test_a_show_begins_with_one_of_them() -> None:
    assert FIRST_LIGHT in LIGHTS


def test_another_is_refused_with_what_there_is() -> None:
    with pytest.raises(ValueError, match="there is no light 'candle'; choose one of theatre, portrait, flat"):
        check_light("candle")


@pytest.mark.parametrize("name", BACKGROUNDS)
def test_a_background_is_found_by_its_name_and_by_its_colour(name: str) -> None:
    colour = BACKGROUNDS[name]
    assert {find_background(text) for text in (name, name.upper(), colour, colour.upper(), colour[1:])} == {colour}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("gren", "did you mean green? It is #00b140"), ("#12", "give green, blue"), ("", "give green"),
        ("#00b14g", "or write #rrggbb"), ("rgb(0,1,2)", "'rgb(0,1,2)' is no colour"),
    ],
)  # fmt: skip
def test_what_is_no_colour_is_refused_with_what_is_near(text: str, said: str) -> None:
    with pytest.raises(ValueError, match=r"#rrggbb, as in #00b140") as refused:
        find_background(text)
    assert said in str(refused.value)
