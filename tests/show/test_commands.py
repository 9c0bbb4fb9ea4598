"""Every command of a console reaches the performer, by the table."""

import math
from typing import get_args

import pytest

from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.show import messages as wire
from omote.show.commands import ACTIONS
from omote.show.validation import Refusal


def test_a_call_in_seconds_runs_and_one_by_hand_waits(cast: Cast) -> None:
    performer = Performer(cast)
    ACTIONS[wire.CallFace](performer, wire.CallFace("1", "broad", 1.0, "smooth"))
    ACTIONS[wire.CallExpression](performer, wire.CallExpression("2", "smile", None, "smooth"))
    frame = performer.advance(1.0)
    assert (frame.faces, frame.expressions) == ({"broad": 1.0}, {"neutral": 1.0})


@pytest.mark.parametrize("kind", [wire.CallFace, wire.CallExpression, wire.CallLight])
def test_infinite_seconds_are_no_word_of_the_wire(cast: Cast, kind: type[wire.CallFace]) -> None:
    with pytest.raises(Refusal, match="seconds"):
        ACTIONS[kind](Performer(cast), kind("1", "broad", math.inf, "smooth"))


def test_every_message_that_plays_has_an_action() -> None:
    asked = set(get_args(wire.KeepMessage))
    assert {*wire.CLIENT_MESSAGES} - {*ACTIONS} == asked | {wire.Hello, wire.Cancel, wire.Ping, wire.Drawing}
