"""The lights by name."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from omote.model.albedo import encode_light
from omote.perform.lights import BACKGROUNDS, FIRST_LIGHT, LIGHTS, Backdrop, Lamp, check_light, find_background


def test_lamps_shine_along_unit_vectors_and_every_light_has_a_label() -> None:
    for name, light in LIGHTS.items():
        assert check_light(name) == name
        assert light.label
        for way in (light.key.direction, light.fill.direction, light.rims.left, light.rims.right):
            assert math.hypot(*way) == pytest.approx(1.0, abs=1e-12)


def test_a_green_for_keyers_stands_behind_the_flat_light_exactly() -> None:
    edge = LIGHTS["flat"].backdrop.edge
    assert bytes(encode_light(np.array(edge))).hex() == BACKGROUNDS["green"].removeprefix("#")


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Lamp((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)), "the direction of a lamp is .*; give three finite numbers"),
        (lambda: Lamp((math.inf, 0.0, 0.0), (1.0, 1.0, 1.0)), "the direction of a lamp is"),
        (lambda: Lamp((0.0, 0.0, 1.0), (1.0, -0.1, 1.0)), "the colour of a light is .*; give three finite numbers"),
        (lambda: Backdrop((0.0, 0.0, math.nan), (0.0, 0.0, 0.0)), "the colour of a light is"),
        (lambda: replace(LIGHTS["flat"], size=0.0), "has size 0.0.*; give a size in radians"),
        (lambda: replace(LIGHTS["flat"], shade=1.1), "shade 1.1.*a shade from 0 to 1"),
        (lambda: replace(LIGHTS["flat"], exposure=math.nan), "exposure nan.*an exposure above 0"),
    ],
)
def test_a_light_with_values_that_cannot_be_is_refused(make: Callable[[], object], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        make()


def test_a_show_begins_with_one_of_them() -> None:
    assert FIRST_LIGHT in LIGHTS


def test_another_is_refused_with_what_there_is() -> None:
    with pytest.raises(ValueError, match=f"there is no light 'candle'; choose one of {', '.join(LIGHTS)}$"):
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
