"""Cues, and what none can be."""

from dataclasses import replace
from typing import Any

import pytest

from omote.perform.cues.cue import MOST_CUES, Cue, Move, check_cues, is_of, with_move
from omote.perform.cues.cue import check_cue_number as check_number

DOG = Move({"dog": 1.0}, seconds=2.0, delay=0.5)
ONE = Cue("a", "1", {"one/face": DOG, "*/black": Move({"black": 1.0}, 1.0)}, pre_wait=0.25, post_wait=3.0)


def test_it_is_as_long_as_its_longest_move_and_is_followed_after_its_begin_or_its_end() -> None:
    assert (ONE.length, ONE.next_after, Cue("b", "2").length) == (2.5, None, 0.0)
    assert replace(ONE, goes_on="continue").next_after == 0.25 + 3.0
    assert replace(ONE, goes_on="follow").next_after == 0.25 + 2.5 + 3.0


def test_a_whole_expression_comes_before_its_regions() -> None:
    moves = {f"one/{part}": Move({"joy": 1.0}) for part in ("brows", "eyes", "expression")}
    assert next(iter(Cue("a", "1", moves).moves)) == "one/expression"


def test_a_move_is_added_and_taken_out_again() -> None:
    with_light = with_move(ONE, "*/light", Move({"flat": 1.0}))
    assert with_light.moves.keys() == {*ONE.moves, "*/light"}
    assert with_move(with_light, "*/light", None) == ONE


@pytest.mark.parametrize("number", ["0", "7", "12.5", "99999.999"])
def test_numbers_that_a_cue_can_have(number: str) -> None:
    assert check_number(number) == number


@pytest.mark.parametrize("number", ["", "01", "1.", ".5", "1.50", "-1", "1e3", "100000", "1.2345", 7, None])
def test_numbers_that_none_can_have(number: Any) -> None:
    with pytest.raises(ValueError, match="a cue cannot be numbered"):
        check_number(number)


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        ({"goes_on": "later"}, "there is no way to go on after a cue 'later'"),
        ({"pre_wait": -1.0}, "the pre_wait of the cue 1 .seconds. is -1.0"),
        ({"label": "x" * 81}, "the label of the cue 1 is longer than 80 characters"),
        ({"moves": {"one/tail": DOG}}, "there is no part 'one/tail'"),
        ({"moves": {"one/head": DOG}}, "the goal of one/head has dog"),
    ],
)
def test_what_no_cue_can_be_is_rejected_in_words(wrong: dict[str, Any], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        replace(ONE, **wrong)


def test_a_list_has_each_number_once_and_not_too_many() -> None:
    assert check_cues([ONE, Cue("b", "2")]) == (ONE, Cue("b", "2"))
    with pytest.raises(ValueError, match="two cues have the number 1"):
        check_cues([ONE, Cue("b", "1")])
    with pytest.raises(ValueError, match="two cues have the identity a"):
        check_cues([ONE, Cue("a", "2")])
    with pytest.raises(ValueError, match="a list holds 2000"):
        check_cues([Cue(str(number), str(number)) for number in range(MOST_CUES + 1)])


def test_a_part_is_of_its_character() -> None:
    assert is_of("one/face", ["one"])
    assert not is_of("*/light", ["one", "two"])
