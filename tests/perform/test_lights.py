"""The lights by name."""

import pytest

from omote.perform.lights import FIRST_LIGHT, LIGHTS, check_light


@pytest.mark.parametrize("name", LIGHTS)
def test_each_is_known_by_its_name(name: str) -> None:
    assert check_light(name) == name
    assert LIGHTS[name]


def test_a_show_begins_with_one_of_them() -> None:
    assert FIRST_LIGHT in LIGHTS


def test_another_is_refused_with_what_there_is() -> None:
    with pytest.raises(ValueError, match="there is no light 'candle'; choose one of theatre, portrait, flat"):
        check_light("candle")
