"""Channels and the action units of FACS."""

import pytest

from omote.builtin import load_cast
from omote.model.action_units import (
    ACTION_UNITS,
    ARKIT,
    MAKEHUMAN,
    ActionUnit,
    action_units,
    explain_action_unit,
    find_units,
    read_action_unit,
)
from omote.perform.name_lookup import find_names

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


@pytest.mark.parametrize("number", ACTION_UNITS)
def test_a_unit_is_read_however_it_is_written(number: int) -> None:
    name = ACTION_UNITS[number]
    for typed in (f"AU{number}", f"au {number}", f"AU-{number}", f"Au_{number}", name, name.upper()):
        assert read_action_unit(typed) == ActionUnit(number)
    for typed in (f"AU{number}L", f"L{number}", f"au {number} l", f"{name} left", f"left {name}"):
        assert read_action_unit(typed) == ActionUnit(number, "L")


@pytest.mark.parametrize("typed", ["", "12", "au", "smile", "L12R", "AU1234", "aunt 12", "jawOpen", "lip corner"])
def test_what_is_no_unit_is_none(typed: str) -> None:
    assert read_action_unit(typed) is None
    assert find_units(typed, load_cast().titles) == ()
    assert explain_action_unit(typed, load_cast().titles) == ""


def test_every_unit_finds_channels_that_are_coded_so_and_move_all_of_it() -> None:
    channels = load_cast().titles
    for number in ACTION_UNITS:
        codes = [action_units(name) for name in find_units(f"AU{number}", channels)]
        letters = {code[0].strip(f"{number}") for code in codes}
        assert all(number_of(code[0]) == number for code in codes)
        assert all(len(code) == 1 for code in codes)
        assert letters in ({""}, {"L", "R"}, {"T", "B"}) or number == 30, number
        for name in find_units(f"AU{number}L", channels):
            assert action_units(name) in ((f"L{number}",), (f"{number}L",))


def test_where_no_one_channel_is_a_unit_it_is_said_what_to_do() -> None:
    channels = load_cast().titles
    assert find_units("AU12", channels) == ("mouth-corner-puller",)
    assert find_units("R12", channels) == ("mouthSmileRight",)
    assert find_units("blink", channels) == ("eyeBlinkLeft", "eyeBlinkRight")
    assert explain_action_unit("blink", channels) == "AU45 is eyeBlinkLeft and eyeBlinkRight together"
    assert find_units("AU30", channels) == ()
    assert explain_action_unit("AU30", channels) == "AU30 is jawLeft or jawRight"
    assert explain_action_unit("AU 23", channels).startswith("no channel is AU23; there are AU1, AU2, AU4, ")
    assert explain_action_unit("AU51", channels) == "AU51 is a turn of the head (turn)"
    assert explain_action_unit("AU12", ["joy"]) == "no channel is AU12"


@pytest.mark.parametrize(
    ("typed", "unit", "weight"), [("AU12C", "AU12", 0.6), ("12 E", "AU12", 1), ("L12A", "AU12L", 0.2)]
)
def test_an_intensity_of_facs_is_answered_with_what_is_meant(typed: str, unit: str, weight: float) -> None:
    said = explain_action_unit(typed, load_cast().expressions)
    grade = typed[-1]
    assert said.startswith(f"{unit}{grade} is {unit} at FACS's intensity {grade}")
    assert said.endswith(f"write {unit}={weight:g}")
    with pytest.raises(ValueError, match=rf"there is no channel '{typed}' in this cast; {unit}{grade} is {unit} at"):
        find_names(typed, load_cast().expressions, "channel")


def test_a_half_is_no_intensity_and_what_has_no_channel_has_none() -> None:
    assert explain_action_unit("AU28B", load_cast().expressions) == "AU28B is mouthRollLower"
    assert "intensity" not in explain_action_unit("AU11C", load_cast().expressions)
