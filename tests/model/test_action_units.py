"""Channels and the action units of FACS."""

import pytest

from omote.builtin import load_cast
from omote.model.action_units import ACTION_UNITS, ARKIT, MAKEHUMAN, action_units

WITHOUT = {"mouthLeft", "mouthRight", "mouthShrugUpper", "nose-depression"}
"""Units of the cast that FACS has no unit for."""


def number_of(code: str) -> int:
    return int(code.strip("LRTB"))


def test_every_unit_of_the_cast_is_coded_or_known_to_have_no_code() -> None:
    titles = load_cast().titles
    units = {name for name, title in titles.items() if title.kind in ("arkit", "makehuman")}
    assert {name for name in units if not action_units(name)} == WITHOUT
    assert {name for name in titles if action_units(name)} == units - WITHOUT


def test_every_code_has_a_name_and_every_name_a_channel() -> None:
    assert {number for codes in (*ARKIT.values(), *MAKEHUMAN.values()) for number in codes} == set(ACTION_UNITS)
    assert all(number_of(code) in ACTION_UNITS for name in load_cast().titles for code in action_units(name))


def test_left_and_right_are_one_unit_on_two_sides() -> None:
    other = {"L": "R", "R": "L"}
    for name in load_cast().titles:
        mirrored = name.replace("Left", "Right").replace("-left-", "-right-")
        if mirrored != name and not name.startswith("eyeLook"):
            assert action_units(mirrored) == tuple(
                "".join(other.get(letter, letter) for letter in code) for code in action_units(name)
            )


@pytest.mark.parametrize(
    ("name", "codes"),
    [
        ("browInnerUp", ("1",)),
        ("eyeLookInLeft", ("L62",)),  # the left eye towards the nose: to the character's right
        ("jawLeft", ("30L",)),
        ("mouthRollLower", ("B28",)),
        ("eyebrows-left-up", ("L1", "L2")),
        ("joy", ()),
        ("no such channel", ()),
    ],
)
def test_some_by_the_book(name: str, codes: tuple[str, ...]) -> None:
    assert action_units(name) == codes
